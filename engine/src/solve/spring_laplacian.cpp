#include "solve/spring_laplacian.h"

#include <algorithm>

namespace hooke {
namespace {

/// The matrices of a scene have their values in the same places, zeros included.
using Entries = std::vector<Eigen::Triplet<double>>;

SymmetricMatrix sum_of(const Entries& entries, std::size_t unknowns) {
  const auto size = Eigen::Index(unknowns);
  SymmetricMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<double> values_of(const SymmetricMatrix& matrix) {
  return {matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros()};
}

constexpr int pinned = -1;

/// The sum of diag(own(i)) and of each spring's Laplacian times `of_spring`.
template <class Own, class OfSpring>
Entries laplacian(const Springs& springs, const Order& order, const std::vector<Index>& particles,
                  const std::vector<int>& unknown_of, const Own& own, const OfSpring& of_spring) {
  Entries entries;
  entries.reserve(particles.size() + 3 * springs.size());
  for (std::size_t u = 0; u < particles.size(); ++u) entries.emplace_back(int(u), int(u), own(particles[u]));
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const int a = unknown_of[order.engine(springs.first[s])], b = unknown_of[order.engine(springs.second[s])];
    const double value = of_spring(s);
    if (a != pinned) entries.emplace_back(a, a, value);
    if (b != pinned) entries.emplace_back(b, b, value);
    if (a != pinned && b != pinned) entries.emplace_back(std::max(a, b), std::min(a, b), -value);
  }
  return entries;
}

}  // namespace

template <class Real>
SpringLaplacian::SpringLaplacian(const Scene& scene, const Model<Real>& model) {
  std::vector<int> unknown_of(model.particles(), pinned);
  for (std::size_t i = 0; i < model.particles(); ++i) {
    if (model.pinned(i)) continue;
    unknown_of[i] = int(particles_.size());
    particles_.push_back(Index(i));
  }
  const auto assemble = [&](const auto& own, const auto& of_spring) {
    return sum_of(laplacian(scene.springs, model.order, particles_, unknown_of, own, of_spring),
                  particles_.size());
  };
  const auto none = [](std::size_t) { return 0.0; };
  const auto mass = [&](std::size_t i) { return scene.particles.mass[model.order.user(i)]; };
  const auto stiffness = [&](std::size_t s) { return scene.springs.stiffness[s]; };
  const auto damping = [&](std::size_t s) { return scene.springs.damping_of(s); };
  mass_ = values_of(assemble(mass, none));
  if (!scene.springs.damping.empty()) damping_ = values_of(assemble(none, damping));
  matrix_ = assemble(none, stiffness);
  stiffness_ = values_of(matrix_);
  weigh({1.0, 1.0}, std::vector<Real>());
}

template <class Real>
void SpringLaplacian::weigh(const DerivativeWeights<double>& weights, const std::vector<Real>& diagonal) {
  double* const values = matrix_.valuePtr();
  for (std::size_t i = 0; i < mass_.size(); ++i) values[i] = mass_[i] + weights.stiffness * stiffness_[i];
  for (std::size_t i = 0; i < damping_.size(); ++i) values[i] += weights.damping * damping_[i];
  if (diagonal.empty()) return;
  for (std::size_t u = 0; u < particles_.size(); ++u)
    values[matrix_.outerIndexPtr()[u]] += double(diagonal[particles_[u]]);
}

std::size_t SpringLaplacian::bytes() const {
  const std::size_t of_value = sizeof(double) + sizeof(int);
  return particles_.capacity() * sizeof(Index) + std::size_t(matrix_.nonZeros()) * of_value +
         (mass_.capacity() + stiffness_.capacity() + damping_.capacity()) * sizeof(double);
}

template SpringLaplacian::SpringLaplacian(const Scene&, const Model<float>&);
template SpringLaplacian::SpringLaplacian(const Scene&, const Model<double>&);
template void SpringLaplacian::weigh(const DerivativeWeights<double>&, const std::vector<float>&);
template void SpringLaplacian::weigh(const DerivativeWeights<double>&, const std::vector<double>&);

}  // namespace hooke
