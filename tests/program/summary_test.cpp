#include "program/summary.h"

#include <sstream>

#include <doctest/doctest.h>

#include "text.h"

namespace hooke::program {
namespace {

using test::contains;

std::string summary(const RunResult& result) {
  std::ostringstream out;
  print_summary(result, out);
  return out.str();
}

RunResult result_of(std::size_t springs, std::uint64_t steps) {
  RunResult result;
  result.particles = 100;
  result.springs = springs;
  result.steps = steps;
  result.wall_seconds = 0.01;
  result.threads = 1;
  return result;
}

TEST_CASE("a summary gives the time for each spring and step, or what can be given instead") {
  CHECK(contains(summary(result_of(500, 1000)), "20 ns for each spring and step"));
  CHECK(contains(summary(result_of(0, 1000)), "100 ns for each particle and step (no springs)"));
  CHECK(contains(summary(result_of(0, 0)), "no steps were taken"));
}

TEST_CASE("a summary says when the run was interrupted") {
  RunResult result = result_of(1, 1);
  CHECK(!contains(summary(result), "interrupted"));
  result.interrupted_by = 2;
  CHECK(contains(summary(result), "interrupted"));
}

TEST_CASE("a summary says where the files are") {
  RunResult result = result_of(1, 1);
  CHECK(contains(summary(result), "none (--out DIR writes frames)"));
  result.out = "frames";
  result.entry = "frames/curtain.pvd";
  result.files = {"frames/curtain_0000.vtp", "frames/curtain.pvd"};
  CHECK(contains(summary(result), "2 in frames, to open: frames/curtain.pvd"));
}

TEST_CASE("a summary names the pictures and what drew them, if any were asked for") {
  RunResult result = result_of(1, 1);
  CHECK(!contains(summary(result), "pictures"));
  result.pictures = {"a.png", "b.mp4"};
  result.pictures_driver = "a pen";
  result.pictures_seconds = 0.5;
  CHECK(contains(summary(result), "a.png, b.mp4; drawn in 0.5 s by a pen\n"));
  result.pictures.clear();
  CHECK(contains(summary(result), "none; drawn"));
}

}  // namespace
}  // namespace hooke::program
