#include "scaling/row.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace hooke::bench {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::string name_of(const Configuration& configuration) {
  return std::string(to_string(configuration.mode)) + "," + std::to_string(configuration.threads) + "," +
         std::string(program::name_of(configuration.precision));
}

}  // namespace

Row make_row(const std::string& mesh, const Scene& scene, const TimedRun& run, const MachineLimits& machine) {
  Row row;
  row.mesh = mesh;
  row.particles = scene.particles.size();
  row.springs = scene.springs.size();
  row.configuration = run.configuration();
  row.repetitions = run.seconds_per_step().size();
  row.seconds = median(run.seconds_per_step());
  row.best_seconds = *std::min_element(run.seconds_per_step().begin(), run.seconds_per_step().end());
  row.cost = run.cost();
  const unsigned threads = row.configuration.threads;
  const ThreadLimits& limits = machine.of_threads.at(threads);
  const bool single = row.configuration.precision == program::Precision::single;
  row.limit =
      step_limit(row.cost, machine.caches, threads, limits, single ? limits.float_rate : limits.double_rate);
  row.checked = run.good();
  return row;
}

void write_column_names(std::ostream& out) {
  out << "mesh,particles,springs,mode,threads,precision,springs_per_second,springs_per_second_best,"
         "ns_per_particle_step,gigabytes_per_second,gigaflops,share_of_limit,limit_set_by,repetitions,"
         "checked\n";
}

void write_csv(const Row& row, std::ostream& out) {
  char figures[256];
  std::snprintf(figures, sizeof figures, "%.6g,%.6g,%.6g,%.6g,%.6g,%.4f", row.springs_per_second(),
                double(row.springs) / row.best_seconds, 1e9 * row.seconds / double(row.particles),
                1e-9 * row.cost.bytes / row.seconds, 1e-9 * row.cost.operations / row.seconds,
                row.share_of_limit());
  out << row.mesh << ',' << row.particles << ',' << row.springs << ',' << name_of(row.configuration) << ','
      << figures << ',' << row.limit.set_by << ',' << row.repetitions << ',' << (row.checked ? "yes" : "no")
      << '\n';
}

std::string in_words(const Row& row) {
  char line[256];
  std::snprintf(line, sizeof line,
                "%-13s %-9s %-7s threads:%-3u %8.1f M springs/s %5.1f %% of the limit (%s)%s",
                row.mesh.c_str(), std::string(to_string(row.configuration.mode)).c_str(),
                std::string(program::name_of(row.configuration.precision)).c_str(), row.configuration.threads,
                1e-6 * row.springs_per_second(), 100.0 * row.share_of_limit(),
                std::string(row.limit.set_by).c_str(), row.checked ? "" : "  CHECK FAILED");
  return line;
}

}  // namespace hooke::bench
