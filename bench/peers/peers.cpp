// Springs updated each second by Hooke and by other programs on the same networks, side by side in one run.
// Every run of every program is checked before it counts; one that fails is named, and makes the whole fail.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

#include "hooke_peers.h"
#include "serial_peers.h"
#ifdef HOOKE_BULLET
#include "bullet_peer.h"
#endif
#ifdef HOOKE_LMP
#include "lammps_peers.h"
#endif

namespace hooke::bench {
namespace {

struct Options {
  bool quick = false;
  int repetitions = 5;
  double seconds = 0.5;  ///< [s] of each timed run, about
  std::string file;      ///< for the figures; none: standard output
};

/// The rates [1/s] of a peer's runs.
struct Row {
  Peer peer;
  std::vector<double> rates;

  double best() const { return *std::max_element(rates.begin(), rates.end()); }
  double median() const {
    std::vector<double> sorted = rates;
    std::sort(sorted.begin(), sorted.end());
    return 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
  }
};

std::vector<Peer> peers_of(const BenchScene& bench) {
  const auto scene = std::make_shared<const CheckedScene>(bench);
  std::vector<Peer> peers = serial_peers(scene);
  for (const Peer& peer : hooke_peers(scene)) peers.push_back(peer);
#ifdef HOOKE_BULLET
  peers.push_back(bullet_peer(scene));
#endif
#ifdef HOOKE_LMP
  for (const Peer& peer : lammps_peers({HOOKE_LMP, HOOKE_MPIRUN}, *scene)) peers.push_back(peer);
#endif
  return peers;
}

/// Runs a peer; what goes wrong is told with its name.
Timing checked_run(const Peer& peer, std::uint64_t steps) {
  try {
    return peer.run(steps);
  } catch (const std::exception& fault) {
    throw std::runtime_error(peer.name + ", " + peer.precision +
                             ", threads: " + std::to_string(peer.threads) + ": " + fault.what());
  }
}

/// How many steps take `seconds` [s], from one short run.
std::uint64_t steps_for(const Peer& peer, double seconds) {
  constexpr std::uint64_t tried = 4;
  return std::max<std::uint64_t>(tried, std::uint64_t(seconds * tried / checked_run(peer, tried).seconds));
}

/// Every peer's runs in random order, so that what else the machine does meets all alike.
std::vector<Row> race(const std::vector<Peer>& peers, const Options& options, std::mt19937& random) {
  std::vector<Row> rows;
  std::vector<std::uint64_t> steps;
  std::vector<std::size_t> order;
  for (const Peer& peer : peers) {
    rows.push_back({peer, {}});
    steps.push_back(steps_for(peer, options.seconds));
    order.insert(order.end(), std::size_t(options.repetitions), rows.size() - 1);
  }
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t turn : order) rows[turn].rates.push_back(checked_run(rows[turn].peer, steps[turn]).rate());
  return rows;
}

const Row* find_row(const std::vector<Row>& rows, const std::string& name, unsigned threads) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.peer.name == name && row.peer.threads == threads;
  });
  return found == rows.end() ? nullptr : &*found;
}

void write_rows(std::ostream& out, const std::string& scene, const std::vector<Row>& rows) {
  const Row *naive = find_row(rows, "naive", 1), *lammps = find_row(rows, "lammps", 2);
  for (const Row& row : rows) {
    out << row.peer.name << ',' << scene << ',' << row.peer.threads << ',' << row.peer.precision << ','
        << row.median() << ',' << row.best() << ',' << row.median() / naive->median() << ',';
    if (lammps) out << row.median() / lammps->median();
    out << ",\"" << row.peer.check << "\"" << std::endl;
  }
}

std::vector<BenchScene> scenes(const Options& options) {
  if (options.quick) return {cloth(64)};
  std::vector<BenchScene> result{cloth(64), cloth(256), cloth(512), cloth(1024)};
  const std::string mesh = std::string(HOOKE_MESHES) + "/square26K.obj";
  if (std::filesystem::exists(mesh)) {
    result.push_back(mesh_cloth("square26K", mesh));
  } else {
    std::cerr << "skipped: square26K, as there is no " << mesh << '\n';
  }
  return result;
}

void say_what_is_skipped() {
#ifndef HOOKE_BULLET
  std::cerr << "skipped: Bullet, which was not found when this was configured (Debian: libbullet-dev)\n";
#endif
#ifndef HOOKE_LMP
  std::cerr << "skipped: LAMMPS, which was not found when this was configured (Debian: lammps, and mpirun)\n";
#endif
}

void run(const Options& options) {
  std::ofstream file;
  if (!options.file.empty()) {
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.open(options.file);
  }
  std::ostream& out = options.file.empty() ? std::cout : file;
  say_what_is_skipped();
  out << "peer,scene,threads,precision,springs_per_second_median,springs_per_second_best,ratio_to_naive,"
         "ratio_to_lammps_2,checked\n";
  std::mt19937 random(1);
  for (const BenchScene& bench : scenes(options)) {
    std::cerr << bench.name << ": " << bench.scene.springs.size() << " springs" << std::endl;
    write_rows(out, bench.name, race(peers_of(bench), options, random));
  }
}

}  // namespace
}  // namespace hooke::bench

int main(int argc, char** argv) {
  hooke::bench::Options options;
  CLI::App app("Springs updated each second by Hooke and by other programs");
  app.add_flag("--quick", options.quick, "the smallest scene, two short runs each: shows that it works");
  app.add_option("--repetitions", options.repetitions, "timed runs of each")->check(CLI::Range(1, 1000));
  app.add_option("--seconds", options.seconds, "of each timed run, about [s]")->check(CLI::PositiveNumber);
  app.add_option("--out", options.file, "CSV file for the figures");
  CLI11_PARSE(app, argc, argv);
  if (options.quick) {
    options.repetitions = 2;
    options.seconds = 0.01;
  }
  try {
    hooke::bench::run(options);
  } catch (const std::exception& failure) {
    std::cerr << "FAILED: " << failure.what() << '\n';
    return 1;
  }
}
