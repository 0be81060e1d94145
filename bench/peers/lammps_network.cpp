#include "lammps_network.h"

#include <Eigen/Geometry>

#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hooke::bench {
namespace {

std::filesystem::path new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "hooke-lammps-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no folder could be made for LAMMPS: " + name);
  return name;
}

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

/// Type 1 is free, type 2 pinned.
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
    const Vec3& v = network.particles.velocity[i];
    data << i + 1 << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
}

void write_masses(std::ostream& data, const std::vector<double>& masses) {
  data << "\nParticleMasses\n\n";
  for (std::size_t i = 0; i < masses.size(); ++i) data << i + 1 << ' ' << masses[i] << '\n';
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

/// What stands behind the last `label` in a text, as a number.
double number_after(const std::string& text, const std::string& label) {
  const std::size_t found = text.rfind(label);
  if (found == std::string::npos) throw std::runtime_error("LAMMPS gave no \"" + label + "\"");
  return std::strtod(text.c_str() + found + label.size(), nullptr);
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

LammpsNetwork::LammpsNetwork(LammpsPrograms programs, const Scene& network, double step)
    : programs_(std::move(programs)), folder_(new_folder()), particles_(network.particles.size()) {
  write_data(network);
  write_script(network, step);
}

LammpsNetwork::~LammpsNetwork() {
  std::error_code left_behind;
  std::filesystem::remove_all(folder_, left_behind);
}

void LammpsNetwork::write_data(const Scene& network) const {
  const BondTypes types(network.springs);
  Eigen::AlignedBox3d box;
  for (const Vec3& position : network.particles.position) box.extend(position);
  std::ofstream data(folder_ / "network.data");
  data.precision(17);
  data << "A network of springs\n\n"
       << particles_ << " atoms\n2 atom types\n"
       << network.springs.size() << " bonds\n"
       << types.stiffness_and_length.size() << " bond types\n\n";
  for (int axis = 0; axis < 3; ++axis) {
    data << box.min()[axis] - 0.01 << ' ' << box.max()[axis] + 0.01 << ' ' << "xyz"[axis] << "lo "
         << "xyz"[axis] << "hi\n";
  }
  write_atoms(data, network);
  write_bonds(data, network.springs, types);
  write_masses(data, network.particles.mass);
  if (!data.flush()) throw std::runtime_error("could not write " + (folder_ / "network.data").string());
}

void LammpsNetwork::write_script(const Scene& network, double step) const {
  const std::vector<double>& lengths = network.springs.rest_length;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  std::ofstream script(folder_ / "network.in");
  script.precision(17);
  script << "units lj\natom_style bond\natom_modify map array\nnewton on\nboundary s s s\n"
         << "special_bonds lj/coul 1 1 1\n"  // no pairs to leave out: else a list of third neighbours is made
         << "bond_style harmonic\npair_style none\n"
         << "fix masses all property/atom rmass\n"
         << "read_data network.data fix masses NULL ParticleMasses\n"
         << "neighbor " << 0.5 * longest << " bin\nneigh_modify delay 0 every 10 check yes\n"
         << "comm_modify cutoff " << 2.0 * longest
         << '\n'  // both ends of a bond, stretched by half, and skin
         << "atom_modify sort 1000 " << 2.0 * longest << '\n'  // else LAMMPS does not sort: it has no pairs
         << "group free type 1\nfix motion free nve\ntimestep " << step << '\n'
         << "thermo_style custom step etotal\nthermo 0\n"
         << "run ${untimed}\n"
         << "write_dump all custom positions.txt id x y z modify sort id format float %.17g\n"
         << "print \"energy before: $(etotal:%.17g)\"\n"
         << "run ${timed}\n"
         << "print \"energy after: $(etotal:%.17g)\"\n";
  if (!script.flush()) throw std::runtime_error("could not write " + (folder_ / "network.in").string());
}

LammpsNetwork::Run LammpsNetwork::run(unsigned processes, int untimed, std::uint64_t timed) const {
  // By variables and not options: other launchers than Open MPI's pass over them. They let root start it, and
  // as many processes as there are cores or more.
  const std::string command = "cd '" + folder_.string() +
                              "' && env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                              "OMPI_MCA_rmaps_base_oversubscribe=1 '" +
                              programs_.mpirun + "' -n " + std::to_string(processes) + " '" + programs_.lmp +
                              "' -in network.in -log network.log -screen none -var untimed " +
                              std::to_string(untimed) + " -var timed " + std::to_string(timed) +
                              " > said.txt 2>&1 < /dev/null";
  std::filesystem::remove(folder_ / "positions.txt");
  std::filesystem::remove(folder_ / "network.log");
  const int status = std::system(command.c_str());
  const std::string log = text_of(folder_ / "network.log");
  if (status != 0) throw std::runtime_error("LAMMPS failed: " + text_of(folder_ / "said.txt") + log);
  const double before = number_after(log, "\nenergy before: "), after = number_after(log, "\nenergy after: ");
  return {read_positions(), (after - before) / before, number_after(log, "\nLoop time of ")};
}

std::vector<Vec3> LammpsNetwork::read_positions() const {
  std::ifstream dump(folder_ / "positions.txt");
  std::string line;
  while (std::getline(dump, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
  }
  std::vector<Vec3> positions;
  std::size_t number;
  for (Vec3 x; dump >> number >> x.x() >> x.y() >> x.z();) positions.push_back(x);
  if (positions.size() != particles_) {
    throw std::runtime_error("LAMMPS gave " + std::to_string(positions.size()) + " positions of " +
                             std::to_string(particles_));
  }
  return positions;
}

}  // namespace hooke::bench
