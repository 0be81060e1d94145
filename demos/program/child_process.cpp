#include "program/child_process.h"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace hooke::program {
namespace {

/// Writing to a program that has ended is an error to tell, not a signal to die of.
class IgnoredBrokenPipe {
 public:
  IgnoredBrokenPipe() {
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigemptyset(&ignore.sa_mask);
    sigaction(SIGPIPE, &ignore, &before_);
  }
  ~IgnoredBrokenPipe() { sigaction(SIGPIPE, &before_, nullptr); }
  IgnoredBrokenPipe(const IgnoredBrokenPipe&) = delete;
  IgnoredBrokenPipe& operator=(const IgnoredBrokenPipe&) = delete;

 private:
  struct sigaction before_ = {};
};

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> words, const std::filesystem::path& folder, int log) {
  int ends[2];
  if (pipe(ends) != 0) return;
  input_ = ends[1];
  // Other children must not inherit this end: they would keep the input from ending.
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  start(pointers(words), folder, log, ends[0]);
  close(ends[0]);
}

ChildProcess::~ChildProcess() {
  if (id_ > 0) kill(id_, SIGKILL);
  wait();
}

void ChildProcess::start(std::vector<char*> words, const std::filesystem::path& folder, int log,
                         int read_end) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, read_end, STDIN_FILENO);
  if (log < 0) {
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  } else {
    posix_spawn_file_actions_adddup2(&files, log, STDOUT_FILENO);
  }
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a group of its own
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&id_, words.front(), &files, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) id_ = -1;
  found_ = error != ENOENT;
}

bool ChildProcess::write(std::span<const std::byte> bytes) {
  const IgnoredBrokenPipe ignored;
  while (!bytes.empty() && id_ > 0) {
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return id_ > 0;
}

void ChildProcess::end_input() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

bool ChildProcess::wait() {
  end_input();
  if (id_ < 0) return false;
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace hooke::program
