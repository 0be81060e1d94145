#include "viewer/virtual_display.h"

#include <array>
#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hooke::test {
namespace {

/// In the child: becomes the server, which writes the number of its display to `out` once it is ready.
[[noreturn]] void become_server(int out, const std::string& screen) {
  const int nothing = open("/dev/null", O_WRONLY);
  dup2(nothing, STDERR_FILENO);
  const std::string number = std::to_string(out);
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp",
         "-noreset", static_cast<char*>(nullptr));
  _exit(127);
}

/// What the server writes up to a line's end, within so many seconds; empty where it does not.
std::string line_from(int in, int seconds) {
  std::string line;
  pollfd waited{in, POLLIN, 0};
  char c = 0;
  while (poll(&waited, 1, 1000 * seconds) > 0 && read(in, &c, 1) == 1) {
    if (c == '\n') return line;
    line += c;
  }
  return {};
}

}  // namespace

VirtualDisplay::VirtualDisplay(int width, int height) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    reason_ = "no pipe can be made";
    return;
  }
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  process_ = fork();
  if (process_ == 0) become_server(ends[1], screen);
  close(ends[1]);
  const std::string number = process_ < 0 ? std::string() : line_from(ends[0], 30);
  close(ends[0]);
  if (number.empty()) {
    reason_ = "Xvfb is not there, or does not start; install xvfb";
    return;
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay() {
  if (process_ <= 0) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

}  // namespace hooke::test
