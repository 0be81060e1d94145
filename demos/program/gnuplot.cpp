#include "program/gnuplot.h"

#include <fcntl.h>
#include <unistd.h>

#include "program/child_process.h"

namespace hooke::program {

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20;
    quoted += c == '\'' ? std::string("''") : std::string(1, is_control ? ' ' : c);
  }
  return quoted + "'";
}

Drawing draw(const std::filesystem::path& folder, const std::string& script) {
  const int log = open((folder / "gnuplot.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0) return Drawing::failed;
  ChildProcess gnuplot({"gnuplot", script}, folder, log);
  close(log);
  if (!gnuplot.found()) return Drawing::no_gnuplot;
  return gnuplot.wait() ? Drawing::done : Drawing::failed;
}

}  // namespace hooke::program
