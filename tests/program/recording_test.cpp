#include "program/recording.h"

#include <array>
#include <vector>

#include <doctest/doctest.h>

#include "program/files.h"
#include "writers/atomic_file.h"

namespace hooke::program {
namespace {

std::vector<float> copy(std::span<const float> values) {
  return {values.begin(), values.end()};
}

TEST_CASE("a recording gives back what it got, in any order, and takes more afterwards") {
  const test::TemporaryFolder folder;
  Recording recording(2, folder.path());
  CHECK(recording.size() == 0);
  std::vector<std::vector<float>> moments;
  for (int i = 0; i < 100; ++i) {
    const auto x = static_cast<float>(i);
    moments.push_back({x, x + 0.25F, -x, 1e30F * x, x / 3.0F, 7.0F});
    recording.add(0.5 * i, moments.back());
    if (i == 50) CHECK(copy(recording.positions(3)) == moments[3]);
  }
  CHECK(recording.size() == 100);
  for (const std::size_t i : {99U, 0U, 50U, 51U, 98U}) {
    CHECK(copy(recording.positions(i)) == moments[i]);
    CHECK(recording.time(i) == 0.5 * static_cast<double>(i));
  }
}

TEST_CASE("a recording takes moments with more particles than the first ones") {
  const test::TemporaryFolder folder;
  Recording recording(1, folder.path());
  const std::vector<float> one{1.0F, 2.0F, 3.0F}, two{4.0F, 5.0F, 6.0F, 7.0F, 8.0F, 9.0F};
  recording.add(0.0, one);
  recording.add(1.0, two);
  recording.add(2.0, two);
  CHECK(copy(recording.positions(1)) == two);
  CHECK(copy(recording.positions(0)) == one);
  CHECK(copy(recording.positions(2)) == two);
}

TEST_CASE("a recording leaves no file behind, whatever happens to the process") {
  const test::TemporaryFolder folder;
  Recording recording(1, folder.path());
  recording.add(0.0, std::array{1.0F, 2.0F, 3.0F});
  CHECK(test::names_in(folder).empty());
}

TEST_CASE("a recording that cannot be kept is refused") {
  CHECK_THROWS_WITH_AS(Recording(1, "/no/such/folder"), doctest::Contains("/no/such/folder"), WriteError);
  const test::TemporaryFolder folder;
  Recording recording(2, folder.path());
  CHECK_THROWS_AS(recording.add(0.0, std::array{1.0F, 2.0F, 3.0F}), std::invalid_argument);
  CHECK(recording.size() == 0);
}

}  // namespace
}  // namespace hooke::program
