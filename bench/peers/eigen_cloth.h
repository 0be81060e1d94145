#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include <hooke/scene.h>

namespace hooke::bench {

/// A step written with matrices: the incidence matrix D (springs x particles, -1 and +1 in each row) times
/// the positions gives every spring's vector, whole-column expressions its pull, and D^T their sums.
template <class Real>
class EigenCloth {
 public:
  EigenCloth(const Scene& scene, double step) : step_(Real(step)) {
    read_particles(scene);
    read_springs(scene);
    Vec3 gravity = Vec3::Zero();
    for (const Effect& effect : scene.effects) {
      if (const auto* named = std::get_if<Gravity>(&effect)) gravity = named->acceleration;
      if (const auto* named = std::get_if<Drag>(&effect)) drag_ = Real(named->coefficient);
    }
    const Eigen::Map<const Eigen::VectorXd> mass(scene.particles.mass.data(), positions_.rows());
    weights_ = (mass * gravity.transpose()).template cast<Real>();
  }

  void step() {
    spans_.noalias() = incidence_ * positions_;
    pulls_ = stiffness_ * (Real(1) - rest_lengths_ / spans_.rowwise().norm().array());
    spans_.array().colwise() *= pulls_;
    forces_ = weights_ - drag_ * velocities_;
    forces_.noalias() -= incidence_transposed_ * spans_;
    velocities_.array() += forces_.array().colwise() * kicks_;
    positions_ += step_ * velocities_;
  }

  Vec3 position(std::size_t particle) const {
    return positions_.row(Eigen::Index(particle)).transpose().template cast<double>();
  }
  std::size_t particles() const { return std::size_t(positions_.rows()); }

 private:
  /// Row-major: the three coordinates of a particle lie together, as the product with a row of D wants them.
  using Points = Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor>;
  using Column = Eigen::Array<Real, Eigen::Dynamic, 1>;
  using Sparse = Eigen::SparseMatrix<Real, Eigen::RowMajor>;

  void read_particles(const Scene& scene) {
    const auto count = Eigen::Index(scene.particles.size());
    positions_.resize(count, 3);
    velocities_.resize(count, 3);
    kicks_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto particle = std::size_t(i);
      positions_.row(i) = scene.particles.position[particle].transpose().template cast<Real>();
      velocities_.row(i) = scene.particles.velocity_of(particle).transpose().template cast<Real>();
      kicks_[i] = step_ / Real(scene.particles.mass[particle]);
    }
    for (const Pin& pin : scene.pins) kicks_[pin.particle] = Real(0);
  }

  void read_springs(const Scene& scene) {
    const auto count = Eigen::Index(scene.springs.size());
    std::vector<Eigen::Triplet<Real>> entries;
    entries.reserve(2 * scene.springs.size());
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      entries.emplace_back(int(s), int(scene.springs.first[s]), Real(-1));
      entries.emplace_back(int(s), int(scene.springs.second[s]), Real(1));
    }
    incidence_.resize(count, positions_.rows());
    incidence_.setFromTriplets(entries.begin(), entries.end());
    incidence_transposed_ = incidence_.transpose();
    stiffness_ = column(scene.springs.stiffness);
    rest_lengths_ = column(scene.springs.rest_length);
  }

  static Column column(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::ArrayXd>(values.data(), Eigen::Index(values.size())).cast<Real>();
  }

  Real step_, drag_ = Real(0);
  Points positions_, velocities_, forces_, weights_, spans_;
  Column kicks_;  ///< step / mass, and zero where a particle is pinned
  Column stiffness_, rest_lengths_, pulls_;
  Sparse incidence_, incidence_transposed_;
};

}  // namespace hooke::bench
