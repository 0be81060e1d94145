#include "hung_sheet.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "bench_scenes.h"

namespace hooke::bench {

bool HungSheet::in_plane(std::size_t spring) const {
  return scene.springs.rest_length[spring] < 1.7 / particles_a_side;  // between sqrt(2) and 2 spacings
}

HungSheet hung_sheet(Index particles_a_side, double step) {
  BenchScene bench = cloth(particles_a_side);
  const double stable = 2.0 * bench.step;  // of the cloth as it comes; w goes with the root of stiffness
  const double stiffer = std::pow(0.9 * stable / step, 2);
  for (double& stiffness : bench.scene.springs.stiffness) stiffness *= stiffer;
  const std::vector<double>& mass = bench.scene.particles.mass;
  const double inner_mass = *std::max_element(mass.begin(), mass.end());
  for (Effect& effect : bench.scene.effects) {
    if (auto* drag = std::get_if<Drag>(&effect)) drag->coefficient = drag_rate * inner_mass;
  }
  return {particles_a_side, std::move(bench.scene)};
}

Strain strain_of(const HungSheet& sheet, const std::vector<Vec3>& positions) {
  const Springs& springs = sheet.scene.springs;
  std::vector<double> strains;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (!sheet.in_plane(s)) continue;
    const double length = (positions[springs.second[s]] - positions[springs.first[s]]).norm();
    const double strain = std::abs(length - springs.rest_length[s]) / springs.rest_length[s];
    if (!std::isfinite(strain)) throw std::runtime_error("spring " + std::to_string(s) + " has no length");
    strains.push_back(strain);
  }
  std::sort(strains.begin(), strains.end());
  const auto at = [&](double share) { return strains[std::size_t(share * double(strains.size() - 1))]; };
  return {strains.back(), at(0.99), at(0.5)};
}

void write_points(const std::filesystem::path& file, const HungSheet& sheet,
                  const std::vector<Vec3>& positions) {
  std::ofstream points(file);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    points << positions[i].x() << ' ' << positions[i].y() << ' ' << positions[i].z() << '\n';
    if ((i + 1) % sheet.particles_a_side == 0) points << '\n';
  }
  if (!points.flush()) throw std::runtime_error("could not write " + file.string());
}

}  // namespace hooke::bench
