#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

namespace hooke::program {

/// Another program at work, as a process of its own. Ctrl-C in the terminal does not reach it: what it does
/// for this program ends when this program says so.
class ChildProcess {
 public:
  /// Starts `words`: the program's name, looked for in PATH, and its arguments, in a folder (empty: this
  /// program's). What it says goes to `log`, an open file; -1: nowhere.
  ChildProcess(std::vector<std::string> words, const std::filesystem::path& folder, int log);

  /// Kills it, unless wait() saw its end.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Whether there is such a program.
  bool found() const { return found_; }

  /// Writes to its input, at its pace. False where it takes no more.
  bool write(std::span<const std::byte> bytes);

  /// Ends its input and waits for its end. Whether it started and all went well.
  bool wait();

 private:
  void start(std::vector<char*> words, const std::filesystem::path& folder, int log, int read_end);
  void end_input();

  pid_t id_ = -1;
  int input_ = -1;
  bool found_ = true;
};

}  // namespace hooke::program
