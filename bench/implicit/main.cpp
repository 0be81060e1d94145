// One frame of the curtain of Liu, Bargteil, O'Brien and Kavan 2013, solved by each implicit method with more
// and more iterations, and by explicit substeps, on one thread: what is left of the error, and what it costs.
//
//   bench_implicit [--stiffness N/m] [--quick] [FILE.csv]
//
// Two errors of positions x after the frame:
//   potential_error  (g(x) - g(x*)) / (g(x0) - g(x*)) with g what backward Euler's step minimises, x0 the
//                    positions before the step, and x* the minimum, found by Newton's method to round-off:
//                    how well the equations of the step are solved;
//   motion_error     RMS distance [m] from where the exact motion is, found by a method of order 4 with short
//                    steps: explicit substeps solve no such equations, and are compared by this.
// Ends with an error where a result is not what the method promises.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

#include "implicit/compared_methods.h"
#include "implicit/frame_run.h"
#include "implicit/incremental_potential.h"

namespace hooke::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

double rms_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / double(a.size()));
}

/// The frame with all that results are held to.
class Comparison {
 public:
  Comparison(double stiffness, std::ostream& csv)
      : frame_(curtain_frame(stiffness)), potential_(frame_), csv_(csv) {
    require(frame_.scene.springs.size() == 32158, "the curtain has not the springs of Liu et al. 2013");
    find_minimum();
    find_motion();
    csv_ << "method,precision,iterations,linear_iterations,force_evaluations,milliseconds,first_milliseconds,"
            "potential_error,motion_error\n";
  }

  template <class Real>
  void compare(const ComparedMethod& method, std::uint64_t most_iterations) {
    double before = std::numeric_limits<double>::infinity();
    for (const std::uint64_t iterations : method.iterations) {
      if (iterations > most_iterations) break;
      const FrameRun run = run_frame<Real>(frame_, method.with(iterations));
      const double error = (potential_(run.positions) - least_) / (first_ - least_);
      // XPBD need not lower the potential; the others must, as far as the precision can tell.
      require(std::isfinite(error) && error > -rounding<Real>(), method.name + " comes below the minimum");
      if (method.descends)
        require(error <= before + rounding<Real>(), method.name + " comes no nearer with more iterations");
      before = error;
      write<Real>(method.name, run, iterations, error);
    }
  }

  /// A method that divides the frame itself, and comes so near to the exact motion [m].
  template <class Real>
  void compare_substeps(const std::string& name, const Method& method, double furthest) {
    const FrameRun run = run_frame<Real>(frame_, method);
    require(rms_distance(run.positions, motion_) < furthest, name + " does not come to where the motion is");
    write<Real>(name, run, run.report.force_evaluations, nan);
  }

 private:
  /// Positions in a sheet of 1 m are rounded by this, which the potential of stiff springs feels squared.
  template <class Real>
  double rounding() const {
    const double rounding = double(std::numeric_limits<Real>::epsilon());
    double stiffness = 0.0;
    for (const double k : frame_.scene.springs.stiffness) stiffness += k;
    return 1e-9 + frame_.h * frame_.h * stiffness * rounding * rounding / (first_ - least_);
  }

  void find_minimum() {
    const FrameRun newton =
        run_frame<double>(frame_, BackwardEuler{.tolerance = 1e-12, .most_iterations = 5000});
    first_ = potential_(frame_.positions());
    least_ = potential_(newton.positions);
    const double slope =
        potential_.gradient_length(newton.positions) / potential_.gradient_length(frame_.positions());
    require(slope < 1e-6, "Newton's method does not come to the minimum");
    minimum_ = newton.positions;
    std::cout << "g(x0) = " << first_ << ", g(x*) = " << least_ << " kg m^2; gradient at x* " << slope
              << " of that at x0, after " << newton.report.solver_iterations
              << " iterations of Newton's method, " << newton.report.linear_iterations
              << " of conjugate gradients, " << newton.seconds << " s\n";
  }

  void find_motion() {
    constexpr std::uint64_t steps = 6000;
    motion_ = run_frame<double>(frame_, BlanesMoan{}, steps).positions;
    const double apart = rms_distance(motion_, run_frame<double>(frame_, BlanesMoan{}, 2 * steps).positions);
    std::cout << "exact motion: two runs, one with half the steps, " << apart << " m apart; the minimum is "
              << rms_distance(minimum_, motion_) << " m from it\n";
    require(apart < 1e-6, "the reference of the motion is not exact enough");
  }

  template <class Real>
  void write(const std::string& name, const FrameRun& run, std::uint64_t iterations, double error) {
    const char* const precision = sizeof(Real) == sizeof(float) ? "float" : "double";
    const double motion_error = rms_distance(run.positions, motion_);
    char line[256];
    std::snprintf(line, sizeof line, "%s,%s,%llu,%llu,%llu,%.4f,%.4f,%.4e,%.4e", name.c_str(), precision,
                  static_cast<unsigned long long>(iterations),
                  static_cast<unsigned long long>(run.report.linear_iterations),
                  static_cast<unsigned long long>(run.report.force_evaluations), 1e3 * run.seconds,
                  1e3 * run.first_seconds, error, motion_error);
    csv_ << line << std::endl;
    std::cout << line << std::endl;
  }

  Frame frame_;
  IncrementalPotential potential_;
  std::ostream& csv_;
  double first_ = 0.0, least_ = 0.0;  // g(x0), g(x*)
  std::vector<Vec3> minimum_, motion_;
};

struct Arguments {
  double stiffness = 9600.0;  // [N/m]
  std::uint64_t most_iterations = std::numeric_limits<std::uint64_t>::max();
  std::string csv = "/dev/null";
};

Arguments arguments_of(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--stiffness" && i + 1 < argc) {
      arguments.stiffness = std::stod(argv[++i]);
    } else if (word == "--quick") {
      arguments.most_iterations = 10;
    } else if (word.rfind("--", 0) == 0) {
      throw std::runtime_error("unknown option " + word);
    } else {
      arguments.csv = word;
    }
  }
  return arguments;
}

void run(const Arguments& arguments) {
  constexpr double tight = 1e-3, loose = 0.1;  // [m]
  std::ofstream csv(arguments.csv);
  require(csv.good(), arguments.csv + " cannot be written");
  Comparison comparison(arguments.stiffness, csv);
  for (const ComparedMethod& method : compared_methods()) {
    comparison.compare<float>(method, arguments.most_iterations);
    comparison.compare<double>(method, arguments.most_iterations);
  }
  for (const std::uint64_t substeps : {20u, 100u, 500u})
    comparison.compare_substeps<float>("XPBD, " + std::to_string(substeps) + " substeps", Xpbd{substeps, 1},
                                       loose);
  comparison.compare_substeps<float>("symplectic Euler", SymplecticEuler{}, tight);
  comparison.compare_substeps<double>("symplectic Euler", SymplecticEuler{}, tight);
  comparison.compare_substeps<float>("Verlet", Verlet{}, tight);
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  try {
    hooke::bench::run(hooke::bench::arguments_of(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "bench_implicit: " << error.what() << std::endl;
    return 1;
  }
}
