#include "program/gnuplot.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hooke::program {
namespace {

constexpr int not_found = 127;  // what a shell returns, too

/// In the child: becomes gnuplot. Only calls that are allowed after a fork of a program with threads.
[[noreturn]] void become_gnuplot(const char* folder, const char* script) {
  const int log = chdir(folder) == 0 ? open("gnuplot.log", O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
  if (log >= 0) {
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
  }
  execlp("gnuplot", "gnuplot", script, static_cast<char*>(nullptr));
  _exit(errno == ENOENT ? not_found : 1);
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20;
    quoted += c == '\'' ? std::string("''") : std::string(1, is_control ? ' ' : c);
  }
  return quoted + "'";
}

Drawing draw(const std::filesystem::path& folder, const std::string& script) {
  const pid_t child = fork();
  if (child < 0) return Drawing::failed;
  if (child == 0) become_gnuplot(folder.c_str(), script.c_str());
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_found) return Drawing::no_gnuplot;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Drawing::done : Drawing::failed;
}

}  // namespace hooke::program
