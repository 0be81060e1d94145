#include "writers/atomic_file.h"

#include <csignal>
#include <optional>
#include <vector>

#include <doctest/doctest.h>
#include <sys/resource.h>

#include "program/files.h"

namespace hooke {
namespace {

using test::names_in;
using test::read_file;
using test::TemporaryFolder;
using test::write_file;

/// Lets no file of this process grow beyond some bytes, as a full disk would.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_ = {};
};

std::string message_of(const std::filesystem::path& path) {
  try {
    AtomicFile file(path);
  } catch (const WriteError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("a file appears only when it is committed, and then whole") {
  const TemporaryFolder folder;
  AtomicFile file(folder / "a.txt");
  file.write("hello ");
  file.write(std::span<const char>("world", 5));
  CHECK(names_in(folder) == std::set<std::string>{"a.txt.partial"});
  file.commit();
  CHECK(names_in(folder) == std::set<std::string>{"a.txt"});
  CHECK(read_file(folder / "a.txt") == "hello world");
}

TEST_CASE("a file that is not committed leaves nothing, and leaves an older one as it was") {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "old");
  {
    AtomicFile file(folder / "a.txt");
    file.write("new");
  }
  CHECK(names_in(folder) == std::set<std::string>{"a.txt"});
  CHECK(read_file(folder / "a.txt") == "old");
  AtomicFile file(folder / "a.txt");
  file.write("new");
  file.commit();
  CHECK(read_file(folder / "a.txt") == "new");
}

TEST_CASE("bytes can be written over and writing goes on at the end") {
  const TemporaryFolder folder;
  AtomicFile file(folder / "a.txt");
  file.write("count: 0;");
  file.overwrite(7, std::span<const char>("7", 1));
  file.write(" end");
  file.commit();
  CHECK(read_file(folder / "a.txt") == "count: 7; end");
}

TEST_CASE("a file that cannot be opened is named with the reason") {
  const TemporaryFolder folder;
  const std::string missing = message_of(folder / "no_such_folder/a.txt");
  CHECK(missing.find("no_such_folder/a.txt") != std::string::npos);
  CHECK(missing.find("No such file or directory") != std::string::npos);
  write_file(folder / "plain", "");
  CHECK(message_of(folder / "plain/a.txt").find("Not a directory") != std::string::npos);
}

TEST_CASE("folders and devices are not replaced") {
  const TemporaryFolder folder;
  CHECK(message_of(folder.path()).find("not a regular file") != std::string::npos);
  CHECK(message_of("/dev/null").find("not a regular file") != std::string::npos);
}

TEST_CASE("a full disk is an error wherever it strikes, and leaves no file") {
  const TemporaryFolder folder;
  const FileSizeLimit limit(1000);
  SUBCASE("in a write") {
    AtomicFile file(folder / "a.txt");
    CHECK_THROWS_AS(file.write(std::string(100'000, 'x')), WriteError);
  }
  SUBCASE("at the end, in what was buffered") {
    AtomicFile file(folder / "a.txt");
    file.write(std::string(1001, 'x'));
    CHECK_THROWS_AS(file.commit(), WriteError);
  }
  CHECK(names_in(folder).empty());
}

}  // namespace
}  // namespace hooke
