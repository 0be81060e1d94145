#include "lammps_data.h"

#include <Eigen/Geometry>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hooke::reference {
namespace {

/// LAMMPS keeps stiffness and rest length for types of bonds. For each spring its type, counted from 1, and
/// the types.
struct BondTypes {
  std::vector<std::size_t> of_spring;
  std::vector<std::pair<double, double>> stiffness_and_length;

  explicit BondTypes(const Springs& springs) {
    std::map<std::pair<double, double>, std::size_t> numbers;
    for (std::size_t s = 0; s < springs.size(); ++s) {
      const std::pair key(springs.stiffness[s], springs.rest_length[s]);
      const auto [entry, is_new] = numbers.try_emplace(key, numbers.size() + 1);
      if (is_new) stiffness_and_length.push_back(key);
      of_spring.push_back(entry->second);
    }
  }
};

void require_harmonic(const Scene& network) {
  for (std::size_t s = 0; s < network.springs.size(); ++s) {
    if (network.springs.damping_of(s) != 0.0) {
      throw std::invalid_argument("spring " + std::to_string(s) +
                                  " is damped, and LAMMPS' harmonic bonds are not: give it no damping");
    }
  }
  for (const Pin& pin : network.pins) {
    if (pin.path.empty()) continue;
    throw std::invalid_argument("the pin of particle " + std::to_string(pin.particle) +
                                " moves, and the atoms that LAMMPS holds do not: give it no path");
  }
}

void write_counts(std::ostream& data, const Scene& network, const BondTypes& types) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : network.particles.position) box.extend(position);
  data << "A network of springs\n\n"
       << network.particles.size() << " atoms\n2 atom types\n"
       << network.springs.size() << " bonds\n"
       << types.stiffness_and_length.size() << " bond types\n\n";
  for (int axis = 0; axis < 3; ++axis) {
    data << box.min()[axis] - 0.01 << ' ' << box.max()[axis] + 0.01 << ' ' << "xyz"[axis] << "lo "
         << "xyz"[axis] << "hi\n";
  }
}

void write_atoms(std::ostream& data, const Scene& network) {
  std::vector<int> type(network.particles.size(), 1);
  for (const Pin& pin : network.pins) type[pin.particle] = 2;
  data << "\nAtoms # bond\n\n";  // number, molecule, type, place
  for (std::size_t i = 0; i < type.size(); ++i) {
    const Vec3& x = network.particles.position[i];
    data << i + 1 << " 1 " << type[i] << ' ' << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
  }
  data << "\nVelocities\n\n";
  for (std::size_t i = 0; i < type.size(); ++i) {
    const Vec3 v = type[i] == 2 ? Vec3::Zero() : network.particles.velocity_of(i);
    data << i + 1 << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
}

void write_bonds(std::ostream& data, const Springs& springs, const BondTypes& types) {
  data << "\nBond Coeffs\n\n";  // E = K (r - r0)^2, so K is half of the stiffness
  for (std::size_t t = 0; t < types.stiffness_and_length.size(); ++t) {
    const auto [stiffness, length] = types.stiffness_and_length[t];
    data << t + 1 << ' ' << 0.5 * stiffness << ' ' << length << '\n';
  }
  data << "\nBonds\n\n";
  for (std::size_t s = 0; s < springs.size(); ++s) {
    data << s + 1 << ' ' << types.of_spring[s] << ' ' << springs.first[s] + 1 << ' ' << springs.second[s] + 1
         << '\n';
  }
}

void write_masses(std::ostream& data, const std::vector<double>& masses) {
  data << "\nParticleMasses\n\n";
  for (std::size_t i = 0; i < masses.size(); ++i) data << i + 1 << ' ' << masses[i] << '\n';
}

}  // namespace

void write_lammps_data(std::ostream& data, const Scene& network) {
  require_harmonic(network);
  const BondTypes types(network.springs);
  data.precision(17);
  write_counts(data, network, types);
  write_atoms(data, network);
  write_bonds(data, network.springs, types);
  write_masses(data, network.particles.mass);
}

}  // namespace hooke::reference
