// How many products with the matrix conjugate gradients need to solve an implicit step, against the length of
// the step, with the engine's own force derivative: for a sheet whose springs have no rest length, and for
// the curtain of Liu et al. 2013 in motion. Explicit substeps at their limit are h w_max / 2. Prints tables.

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Dense>

#include "implicit/curtain.h"
#include "kernels/gather_derivative.h"
#include "model/model.h"

namespace hooke::bench {
namespace {

using Vector = Eigen::VectorXd;

/// The stiffness of a scene's springs in a state, by the engine's kernels, for unit masses; zero for pins.
class Stiffness {
 public:
  explicit Stiffness(const Scene& scene)
      : executor_(make_tbb_executor(1)),
        model_(scene, Accumulation::gather, *executor_),
        state_(initial_state(scene, model_)) {
    if (slots_of(model_) == nullptr) throw std::runtime_error("there are no springs");
  }

  Eigen::Index size() const { return Eigen::Index(3 * model_.particles()); }
  bool pinned(std::size_t i) const { return model_.pinned(i); }

  Vector product(const Vector& p) {
    for (std::size_t i = 0; i < model_.particles(); ++i)
      state_.set_velocity(i, p.segment<3>(Eigen::Index(3 * i)));
    Vector result = Vector::Zero(size());
    StripForce<double> force;
    for_each_strip(0, block_count(model_.particles()), [&](std::size_t begin, std::size_t end) {
      gather_product(*slots_of(model_), state_, begin, end, {1.0, 0.0}, PressedSprings::no_push, force);
      each_free(begin, end, [&](std::size_t i, std::size_t lane) {
        result.segment<3>(Eigen::Index(3 * i)) = Vec3(force.x[lane], force.y[lane], force.z[lane]);
      });
    });
    return result;
  }

  /// The 3x3 blocks on the diagonal.
  std::vector<Eigen::Matrix3d> blocks() {
    std::vector<Eigen::Matrix3d> result(model_.particles(), Eigen::Matrix3d::Zero());
    StripBlocks<double> m;
    for_each_strip(0, block_count(model_.particles()), [&](std::size_t begin, std::size_t end) {
      gather_diagonal(*slots_of(model_), state_, begin, end, {1.0, 0.0}, PressedSprings::no_push, m);
      each_free(begin, end, [&](std::size_t i, std::size_t lane) {
        result[i] << m.xx[lane], m.xy[lane], m.xz[lane], m.xy[lane], m.yy[lane], m.yz[lane], m.xz[lane],
            m.yz[lane], m.zz[lane];
      });
    });
    return result;
  }

 private:
  template <class Visit>
  void each_free(std::size_t begin, std::size_t end, const Visit& visit) const {
    const std::size_t last = std::min(end * block_size, model_.particles());
    for (std::size_t i = begin * block_size; i < last; ++i) {
      if (!pinned(i)) visit(i, i - begin * block_size);
    }
  }

  std::shared_ptr<Executor> executor_;
  Model<double> model_;
  State<double> state_;
};

Vector random_vector(const Stiffness& stiffness) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Vector vector(stiffness.size());
  for (double& value : vector) value = normal(random);
  for (Eigen::Index i = 0; i < vector.size() / 3; ++i) {
    if (stiffness.pinned(std::size_t(i))) vector.segment<3>(3 * i).setZero();
  }
  return vector;
}

/// By power iteration.
double largest_eigenvalue(Stiffness& stiffness) {
  Vector v = random_vector(stiffness).normalized();
  double value = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Vector next = stiffness.product(v);
    value = v.dot(next);
    v = next.normalized();
  }
  return value;
}

const std::vector<double> shares = {1e-1, 1e-2, 1e-4, 1e-6};

/// Iterations of conjugate gradients for I + scale K until the residual is each of the shares of the right
/// side, which is random; preconditioned by blocks of particles, or not.
std::vector<int> iterations(Stiffness& stiffness, double scale, bool preconditioned) {
  std::vector<Eigen::Matrix3d> inverse = stiffness.blocks();
  for (Eigen::Matrix3d& block : inverse)
    block = (Eigen::Matrix3d::Identity() + scale * block).inverse().eval();
  const auto precondition = [&](const Vector& r) {
    Vector z = r;
    if (!preconditioned) return z;
    for (Eigen::Index i = 0; i < r.size() / 3; ++i)
      z.segment<3>(3 * i) = inverse[std::size_t(i)] * r.segment<3>(3 * i);
    return z;
  };
  Vector r = random_vector(stiffness), z = precondition(r), p = z;
  const double first = r.norm();
  double square = r.dot(z);
  std::vector<int> result;
  for (int i = 1; result.size() < shares.size(); ++i) {
    if (i > 20000) throw std::runtime_error("conjugate gradients do not converge");
    const Vector product = p + scale * stiffness.product(p);
    r -= square / p.dot(product) * product;
    z = precondition(r);
    const double next = r.dot(z);
    p = z + next / square * p;
    square = next;
    while (result.size() < shares.size() && r.norm() <= shares[result.size()] * first) result.push_back(i);
  }
  return result;
}

void print_table(const char* title, const Scene& scene) {
  Stiffness stiffness(scene);
  const double largest = largest_eigenvalue(stiffness), mass = scene.particles.mass[0];
  std::printf("%s: w_max = %.0f 1/s\n\n", title, std::sqrt(largest / mass));
  std::printf(
      "| h w_max | explicit substeps | CG, residual 1e-1 / 1e-2 / 1e-4 / 1e-6 | block-Jacobi CG |\n"
      "|---|---|---|---|\n");
  for (const double hw : {5.0, 10.0, 20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0}) {
    std::printf("| %.0f | %.1f |", hw, hw / 2);
    for (const bool preconditioned : {false, true}) {
      const std::vector<int> counts = iterations(stiffness, hw * hw / largest, preconditioned);
      std::printf(" %d / %d / %d / %d |", counts[0], counts[1], counts[2], counts[3]);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\n");
}

void run() {
  Scene taut = liu_curtain(9600.0);
  for (double& length : taut.springs.rest_length) length = 0.0;
  print_table("Springs without rest length, 81 x 81", taut);

  const Frame frame = curtain_frame(9600.0);
  Scene curtain = frame.scene;
  const std::vector<Vec3> positions = frame.positions();
  curtain.particles.position = positions;
  print_table("The curtain in motion", curtain);
}

}  // namespace
}  // namespace hooke::bench

int main() {
  try {
    hooke::bench::run();
  } catch (const std::exception& error) {
    std::cerr << "bench_cg_iterations: " << error.what() << std::endl;
    return 1;
  }
}
