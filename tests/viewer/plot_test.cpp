#include "viewer/plot.h"

#include <doctest/doctest.h>

#include <cmath>

#include "viewer/energy_plot.h"
#include "viewer/quantity.h"
#include "viewer/study_plot.h"

namespace hooke::viewer {
namespace {

AccuracyRun run(const std::string& method, double error, double seconds) {
  AccuracyRun result;
  result.choice.method = method;
  result.horizon = 1.0;
  result.largest_rms_error = error;
  result.seconds = seconds;
  return result;
}

AccuracyStudy small_study() {
  AccuracyStudy study;
  study.tolerance = 1e-3;
  study.horizons = {0.1, 1.0};
  study.smallest_errors = {1e-9, 1e-7};
  study.runs = {run("verlet", 1e-2, 0.1), run("verlet", 1e-4, 0.4), run("heun", 3e-3, 0.2)};
  AccuracyRun diverged = run("heun", not_measured, 0.01);
  diverged.diverged = true;
  AccuracyRun below = run("heun", not_measured, 5.0);
  below.below_reference = true;
  AccuracyRun shorter = run("midpoint", 1e-6, 1e-9);
  shorter.horizon = 0.1;
  study.runs.insert(study.runs.end(), {diverged, below, shorter});
  return study;
}

const Mark* mark(const Plot& plot, const std::string& label) {
  for (const Mark& one : plot.marks) {
    if (one.label == label) return &one;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("numbers are short and have a prefix") {
  CHECK(quantity(0.0123, "s") == "12.3 ms");
  CHECK(quantity(3.4e9, "") == "3.4 G");
  CHECK(quantity(999.96, "J") == "1 kJ");
  CHECK(quantity(-868e-3, "J") == "-868 mJ");
  CHECK(quantity(0.0, "J") == "0 J");
  CHECK(quantity(1e-6, "s") == "1 \u00b5s");
  CHECK(quantity(1e20, "J") == "1e+08 TJ");
  CHECK(quantity(NAN, "J") == "nan J");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1048576) == "1 048 576");
}

TEST_CASE("ticks are round, in the axis, and no more than asked for") {
  CHECK(ticks({0.0, 1.0}, 6) == std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0});
  CHECK(ticks({-3.0, 14.0}, 4) == std::vector<double>{0.0, 5.0, 10.0});
  for (const double range : {1e-12, 0.3, 7.0, 1e9}) {
    for (int most = 2; most < 9; ++most) {
      const std::vector<double> values = ticks({-0.4 * range, 0.6 * range}, most);
      CHECK(values.size() >= 1);
      CHECK(static_cast<int>(values.size()) <= most);
      for (const double value : values) CHECK_FALSE((value == 0.0 && std::signbit(value)));
    }
  }
  CHECK(ticks({1.0, 1.0}, 5).empty());
}

TEST_CASE("ticks of a logarithmic axis are powers of ten") {
  const Axis axis{1e-6, 1e2, true};
  CHECK(ticks(axis, 9).size() == 9);
  const std::vector<double> few = ticks(axis, 4);
  CHECK(few.size() <= 4);
  for (const double value : few) CHECK(std::log10(value) == doctest::Approx(std::round(std::log10(value))));
  CHECK(axis.place(1e-2) == doctest::Approx(0.5));
}

TEST_CASE("the plot of energies has those kinds that there are, and holds all that is finite") {
  std::vector<Measurement> samples(3);
  for (int i = 0; i < 3; ++i)
    samples[std::size_t(i)] = {std::uint64_t(i) + 1, 0.1 * i, {.kinetic = 2.0 * i}, 0.0};
  samples.push_back({4, 0.3, {.kinetic = INFINITY}, 0.0});
  const Plot plot = energy_plot(samples);
  REQUIRE(plot.curves.size() == 2);
  CHECK(plot.curves[0].label == "kinetic");
  CHECK(plot.curves[1].label == "total");
  CHECK(plot.x.high == doctest::Approx(0.3));
  CHECK(plot.y.high > 4.0);
  CHECK(plot.y.high < 5.0);
  CHECK(plot.x.label.find("[s]") != std::string::npos);
  CHECK(plot.y.label.find("[J]") != std::string::npos);
}

TEST_CASE("energies that do not change have an axis, too") {
  const Plot plot = energy_plot({{1, 0.0, {.kinetic = 5.0}, 0.0}, {2, 1.0, {.kinetic = 5.0}, 0.0}});
  CHECK(plot.y.low < 5.0);
  CHECK(plot.y.high > 5.0);
}

TEST_CASE("the plot of a study has a curve for each method over the longest horizon") {
  const Plot plot = study_plot(small_study());
  REQUIRE(plot.curves.size() == 2);
  CHECK(plot.curves[0].label == "verlet");
  CHECK(plot.curves[0].x == std::vector<double>{1e-2, 1e-4});
  CHECK(plot.curves[0].y == std::vector<double>{0.1, 0.4});
  CHECK(plot.curves[1].x == std::vector<double>{3e-3});
}

TEST_CASE("runs that diverged or are below the reference are at the plot's edges, within it") {
  const Plot plot = study_plot(small_study());
  REQUIRE(mark(plot, "diverged"));
  REQUIRE(mark(plot, "reference"));
  CHECK(mark(plot, "tolerance")->x == 1e-3);
  CHECK(plot.curves[1].single_x == std::vector<double>{mark(plot, "diverged")->x, 1e-7});
  CHECK(plot.curves[1].single_y == std::vector<double>{0.01, 5.0});
  for (const Curve& curve : plot.curves) {
    for (const auto* values : {&curve.x, &curve.single_x}) {
      for (const double x : *values) CHECK((plot.x.place(x) >= 0.0 && plot.x.place(x) <= 1.0));
    }
    for (const auto* values : {&curve.y, &curve.single_y}) {
      for (const double y : *values) CHECK((plot.y.place(y) >= 0.0 && plot.y.place(y) <= 1.0));
    }
  }
}

TEST_CASE("a study without runs has no curves") {
  CHECK(study_plot({}).curves.empty());
}

}  // namespace hooke::viewer
