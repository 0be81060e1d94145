#include "lammps_network.h"

#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "lammps_data.h"

namespace hooke::reference {
namespace {

std::filesystem::path new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "hooke-lammps-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no folder could be made for LAMMPS: " + name);
  return name;
}

/// The command for each effect; a fix's name ends in the effect's number.
struct FixOfEffect {
  std::ostream& script;
  std::size_t number = 0;

  void operator()(const Gravity& gravity) const {
    const Vec3& g = gravity.acceleration;
    if (g.isZero(0.0)) return;  // it has no direction
    script << "fix effect" << number << " free gravity " << g.norm() << " vector " << g.x() << ' ' << g.y()
           << ' ' << g.z() << '\n';
  }
  void operator()(const Drag& drag) const {
    script << "fix effect" << number << " free viscous " << drag.coefficient << '\n';
  }
  template <class Other>
  void operator()(const Other&) const {
    throw std::invalid_argument("effects[" + std::to_string(number) + "] (" + std::string(Other::name) +
                                ") cannot be said to LAMMPS: leave it out");
  }
};

std::string setup_commands(const Scene& network, double step) {
  const std::vector<double>& lengths = network.springs.rest_length;
  const double longest = lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
  if (longest == 0.0)
    throw std::invalid_argument("LAMMPS needs a spring with a rest length > 0, to know how far bonds reach");
  std::ostringstream script;
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
         << "thermo_style custom step etotal\nthermo 0\n";
  FixOfEffect fix{script};
  for (; fix.number < network.effects.size(); ++fix.number) std::visit(fix, network.effects[fix.number]);
  return script.str();
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

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error("could not write " + path.string());
}

/// Reads on until a line that begins so; returns whether there was one.
bool find_item(std::istream& dump, const std::string& beginning) {
  std::string line;
  while (std::getline(dump, line)) {
    if (line.rfind(beginning, 0) == 0) return true;
  }
  return false;
}

const std::string dump_columns = "id x y z vx vy vz", dump_format = "sort id format float %.17g";

}  // namespace

LammpsNetwork::LammpsNetwork(LammpsPrograms programs, const Scene& network, double step)
    : programs_(std::move(programs)),
      particles_(network.particles.size()),
      setup_(setup_commands(network, step)) {
  std::ostringstream data;
  write_lammps_data(data, network);
  folder_ = new_folder();
  write_file(folder_ / "network.data", data.str());
}

LammpsNetwork::~LammpsNetwork() {
  std::error_code left_behind;
  std::filesystem::remove_all(folder_, left_behind);
}

std::string LammpsNetwork::run(unsigned processes, const std::string& commands) const {
  write_file(folder_ / "network.in", setup_ + commands);
  std::filesystem::remove(folder_ / "dump.txt");
  std::filesystem::remove(folder_ / "network.log");
  // By variables and not options: other launchers than Open MPI's pass over them. They let root start it, and
  // as many processes as there are cores or more.
  const std::string command = "cd '" + folder_.string() +
                              "' && env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                              "OMPI_MCA_rmaps_base_oversubscribe=1 '" +
                              programs_.mpirun + "' -n " + std::to_string(processes) + " '" + programs_.lmp +
                              "' -in network.in -log network.log -screen none > said.txt 2>&1 < /dev/null";
  const int status = std::system(command.c_str());
  const std::string log = text_of(folder_ / "network.log");
  if (status != 0) throw std::runtime_error("LAMMPS failed: " + text_of(folder_ / "said.txt") + log);
  return log;
}

LammpsNetwork::TimedRun LammpsNetwork::timed_run(unsigned processes, int untimed, std::uint64_t timed) const {
  const std::string log =
      run(processes, "run " + std::to_string(untimed) + "\nwrite_dump all custom dump.txt " + dump_columns +
                         " modify " + dump_format + "\nprint \"energy before: $(etotal:%.17g)\"\nrun " +
                         std::to_string(timed) + "\nprint \"energy after: $(etotal:%.17g)\"\n");
  const double before = number_after(log, "\nenergy before: "), after = number_after(log, "\nenergy after: ");
  return {read_dump().back().positions, (after - before) / before, number_after(log, "\nLoop time of ")};
}

std::vector<LammpsNetwork::Frame> LammpsNetwork::frames(std::uint64_t steps, std::uint64_t every) const {
  run(1, "dump frames all custom " + std::to_string(every) + " dump.txt " + dump_columns +
             "\ndump_modify frames " + dump_format + "\nrun " + std::to_string(steps) + '\n');
  std::vector<Frame> frames = read_dump();
  if (frames.size() != steps / every + 1)
    throw std::runtime_error("LAMMPS gave " + std::to_string(frames.size()) + " frames");
  return frames;
}

std::vector<LammpsNetwork::Frame> LammpsNetwork::read_dump() const {
  std::ifstream dump(folder_ / "dump.txt");
  std::vector<Frame> frames;
  while (find_item(dump, "ITEM: TIMESTEP")) {
    Frame frame;
    dump >> frame.step;
    find_item(dump, "ITEM: ATOMS");
    std::size_t number;
    for (Vec3 x, v; frame.positions.size() < particles_ &&
                    dump >> number >> x.x() >> x.y() >> x.z() >> v.x() >> v.y() >> v.z();) {
      frame.positions.push_back(x);
      frame.velocities.push_back(v);
    }
    if (frame.positions.size() != particles_) {
      throw std::runtime_error("LAMMPS gave " + std::to_string(frame.positions.size()) + " particles of " +
                               std::to_string(particles_));
    }
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) throw std::runtime_error("LAMMPS gave no positions");
  return frames;
}

}  // namespace hooke::reference
