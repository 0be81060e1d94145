#include "program/child_process.h"

#include <csignal>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include "program/files.h"

namespace hooke::program {
namespace {

using test::names_in;
using test::read_file;
using test::TemporaryFolder;

std::span<const std::byte> bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

TEST_CASE("what is written to a program is its input, and its end is waited for") {
  const TemporaryFolder folder;
  ChildProcess child({"sh", "-c", "cat > got; echo done >> got"}, folder.path(), -1);
  CHECK(child.found());
  const std::string text(1'000'000, 'x');  // more than a pipe holds
  CHECK(child.write(bytes(text)));
  CHECK(child.wait());
  CHECK(read_file(folder / "got") == text + "done\n");
}

TEST_CASE("what a program says goes to the log, and its failure is told") {
  const TemporaryFolder folder;
  const int log = open((folder / "log").c_str(), O_WRONLY | O_CREAT, 0600);
  ChildProcess child({"sh", "-c", "echo out; echo error >&2; exit 3"}, {}, log);
  close(log);
  CHECK(child.found());
  CHECK(!child.wait());
  CHECK(read_file(folder / "log") == "out\nerror\n");
}

TEST_CASE("a program that there is not is not found") {
  ChildProcess child({"no_such_program_of_hooke"}, {}, -1);
  CHECK(!child.found());
  CHECK(!child.write(bytes("x")));
  CHECK(!child.wait());
}

TEST_CASE("writing to a program that takes no more is an error, not a signal, and SIGPIPE is as before") {
  ChildProcess child({"true"}, {}, -1);
  const std::string text(1'000'000, 'x');
  CHECK(!child.write(bytes(text)));
  CHECK(child.wait());
  struct sigaction action = {};
  sigaction(SIGPIPE, nullptr, &action);
  const bool is_default = action.sa_handler == SIG_DFL;
  CHECK(is_default);
}

TEST_CASE("a program that is not waited for is ended") {
  const TemporaryFolder folder;
  {
    ChildProcess child({"sh", "-c", "cat; echo late > late"}, folder.path(), -1);
    CHECK(child.write(bytes("x")));
  }
  CHECK(names_in(folder).empty());
}

TEST_CASE("Ctrl-C in the terminal does not reach it") {
  const TemporaryFolder folder;
  ChildProcess child({"sh", "-c", "cut -d \" \" -f 5 /proc/$$/stat > group"}, folder.path(), -1);
  REQUIRE(child.wait());
  CHECK(std::stol(read_file(folder / "group")) != static_cast<long>(getpgrp()));
}

}  // namespace
}  // namespace hooke::program
