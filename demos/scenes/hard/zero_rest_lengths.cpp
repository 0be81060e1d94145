#include <algorithm>

#include <Eigen/Eigenvalues>

#include "scenes/hard/asked_method.h"
#include "scenes/hard/cases.h"
#include "scenes/hard/common_criteria.h"
#include "scenes/hard/shapes.h"

/// Springs without rest length make a network linear, however far it moves. Then it is a sum of modes that do
/// not change, and a method moves each of them as it moves a single oscillator of that frequency.

namespace hooke::hard {
namespace {

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

constexpr int steps = 12;

Scene make(Extent extent) {
  const Index side = extent == Extent::whole ? 12 : 6;
  Sheet made = sheet(side);
  Noise noise(2);
  for (Vec3& position : made.scene.particles.position) position = noise.vector();
  for (std::size_t i = 0; i < made.scene.particles.size(); ++i)
    made.scene.particles.velocity.push_back(3.0 * noise.vector());
  for (double& length : made.scene.springs.rest_length) length = 0.0;
  for (double& stiffness : made.scene.springs.stiffness) stiffness *= 0.01;  // swings over some steps
  return made.scene;
}

/// What becomes of (q, p) of a mode: q' = a q + b p.
struct ModeMap {
  double a = 1.0, b = 0.0;
};

/// That of the exact motion over the time t [s], with frequency w [1/s].
ModeMap exact_map(double w, double t) {
  return w * t < 1e-6 ? ModeMap{1.0, t} : ModeMap{std::cos(w * t), std::sin(w * t) / w};
}

/// What the method itself makes of an oscillator of frequency w [1/s] in the same steps.
ModeMap map_of_method(const Settings& settings, double w, std::uint64_t count) {
  if (w * settings.step * double(count) < 1e-6) return exact_map(w, settings.step * double(count));
  Scene oscillator;
  oscillator.add_particle(1.0, {1.0, 0.0, 0.0}, {0.0, w, 0.0});
  oscillator.add_particle(1.0, Vec3::Zero());
  oscillator.add_spring(0, 1, w * w, 0.0);
  oscillator.pin(1);
  WatchedRun<double> run(oscillator, settings);
  run.take(count);
  const Vec3 end = run.positions()[0];
  return {end.x(), end.y() / w};
}

class Modes {
 public:
  explicit Modes(const Scene& scene) : root_mass_(Eigen::Index(scene.particles.size())) {
    const Eigen::Index count = root_mass_.size();
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      const Index a = scene.springs.first[s], b = scene.springs.second[s];
      const double k = scene.springs.stiffness[s];
      laplacian(a, a) += k;
      laplacian(b, b) += k;
      laplacian(a, b) -= k;
      laplacian(b, a) -= k;
    }
    for (Eigen::Index i = 0; i < count; ++i) root_mass_[i] = std::sqrt(scene.particles.mass[std::size_t(i)]);
    const Eigen::VectorXd inverse = root_mass_.cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(inverse.asDiagonal() * laplacian *
                                                                inverse.asDiagonal());
    shapes_ = solver.eigenvectors();
    frequencies_ = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  }

  /// The scene's positions after map(w) of each mode.
  template <class Map>
  std::vector<Vec3> moved(const Scene& scene, const Map& map) const {
    Columns q(root_mass_.size(), 3), p(root_mass_.size(), 3);
    for (Eigen::Index i = 0; i < q.rows(); ++i) {
      q.row(i) = scene.particles.position[std::size_t(i)];
      p.row(i) = scene.particles.velocity[std::size_t(i)];
    }
    q = shapes_.transpose() * root_mass_.asDiagonal() * q;
    p = shapes_.transpose() * root_mass_.asDiagonal() * p;
    for (Eigen::Index mode = 0; mode < q.rows(); ++mode) {
      const ModeMap one = map(frequencies_[mode]);
      q.row(mode) = (one.a * q.row(mode) + one.b * p.row(mode)).eval();
    }
    q = (root_mass_.cwiseInverse().asDiagonal() * (shapes_ * q)).eval();
    std::vector<Vec3> result(scene.particles.size());
    for (Eigen::Index i = 0; i < q.rows(); ++i) result[std::size_t(i)] = q.row(i);
    return result;
  }

 private:
  Eigen::VectorXd root_mass_, frequencies_;
  Eigen::MatrixXd shapes_;
};

/// The root of the mean square of distances [m].
double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / double(a.size()));
}

Result run(const Method& method, Extent extent) {
  const Scene scene = make(extent);
  const Settings settings = asked_of(method, scene, frame);
  const auto compare = [&](WatchedRun<double>& run, Judge& judge) {
    run.take(steps);
    const std::uint64_t parts = run.simulation().plan().substeps;
    Settings alone = settings;
    alone.step = frame / double(parts);
    alone.unstable_step = UnstableStep::take;  // it bears that in the network, so it does here
    const Modes modes(scene);
    const auto own = modes.moved(scene, [&](double w) { return map_of_method(alone, w, steps * parts); });
    // A method that chooses its steps takes others for each mode, but then it is near the exact motion.
    const auto exact = modes.moved(scene, [&](double w) { return exact_map(w, steps * frame); });
    const std::vector<Vec3> end = run.positions();
    judge.at_most("distance from the sum of the modes, as a share of the size",
                  std::min(distance(end, own), distance(end, exact)), 1e-6);
  };
  return judged(scene, settings, steps, compare);
}

}  // namespace

const HardCase zero_rest_lengths{2,
                                 "zero_rest_lengths",
                                 "A free cloth of 12 x 12 particles (quick: 6 x 6), all rest lengths 0, 10 "
                                 "N/m and 5 N/m, at random places in a "
                                 "cube of 2 m and with random velocities up to 3 m/s. 12 steps of 1/60 s.",
                                 "Such a network is linear: it must move as the sum of its modes, each as "
                                 "the method moves a single oscillator "
                                 "of that frequency (or as it moves exactly), to 1e-6 of the size.",
                                 "How near the method is to the exact motion is a matter of its order and "
                                 "step: `hooke accuracy` shows that.",
                                 frame,
                                 make,
                                 run};

}  // namespace hooke::hard
