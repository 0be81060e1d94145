// What happens to a sheet if it is divided more or less finely, or in another direction? The same sheet, by
// naive springs, calibrated springs and tensile triangles: stretched, hung up, draped and swinging.
//
//   bench_refinement [--quick] [FOLDER]
//
// Writes refinement.csv and the tables of docs/refinement.md, refinement_tables.md, to the folder. Ends with
// an error where the calibrated sheets depend on their mesh by more than docs/materials.md says.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "refinement/dynamics.h"
#include "refinement/figures.h"
#include "refinement/stretch.h"

namespace hooke::bench {
namespace {

constexpr std::array patterns{Pattern::grid, Pattern::structured, Pattern::alternating, Pattern::jittered};
constexpr std::array modes{Mode::naive, Mode::springs, Mode::triangles};

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

std::vector<Index> finenesses(Index most) {
  std::vector<Index> cells;
  for (Index n = 8; n <= most; n *= 2) cells.push_back(n);
  return cells;
}

class Study {
 public:
  explicit Study(Index most) : most_(most) {}

  /// The fineness of the sheets that are turned.
  Index turned_cells() const { return std::min(most_, Index{32}); }

  void run() {
    for (const Mode mode : modes) {
      for (const Pattern pattern : patterns) {
        stretch(pattern, mode);
        hang(pattern, mode);
        swing(pattern, mode);
      }
      drape(mode);
    }
  }

  const Figures& figures() const { return figures_; }

  void check() const {
    const auto spread = [&](const std::string& quantity, Mode mode, double angle) {
      return figures_.spread([&](const Figure& f) {
        return f.quantity == quantity && f.mode == mode && (angle < 0.0 || f.angle == angle);
      });
    };
    const double all = -1.0;
    for (const char* quantity : {"young", "poisson"})
      require(spread(quantity, Mode::triangles, all) < 2e-3,
              std::string("triangles depend on their mesh: ") + quantity);
    for (const char* quantity : {"sag", "frequency"})
      require(spread(quantity, Mode::triangles, all) < 0.03,
              std::string("triangles depend on their mesh: ") + quantity);
    const double grid = figures_.spread([](const Figure& f) {
      return f.quantity == "young" && f.pattern == Pattern::grid && f.mode == Mode::springs;
    });
    require(grid < 2e-3, "a calibrated grid depends on its mesh");
    require(spread("young", Mode::naive, all) > 0.1, "naive springs do not depend on their mesh");
  }

 private:
  void add(const char* quantity, Pattern pattern, Mode mode, double angle, Index n, double value) {
    figures_.add({quantity, pattern, mode, angle, n, value});
    std::printf("%-10s %-12s %-10s %3.0f deg %4u cells %9.5f\n", quantity, to_string(pattern).data(),
                to_string(mode).data(), angle, n, value);
    std::fflush(stdout);
  }

  void stretch(Pattern pattern, Mode mode) {
    const auto measure = [&](Index n, double angle) {
      const Moduli moduli = stretched_moduli(n, pattern, mode, angle);
      add("young", pattern, mode, angle, n, moduli.young / study_material.modulus);
      add("poisson", pattern, mode, angle, n, moduli.poisson);
    };
    for (const Index n : finenesses(most_)) measure(n, 0.0);
    for (const double angle : {15.0, 30.0, 45.0}) measure(turned_cells(), angle);
  }

  void hang(Pattern pattern, Mode mode) {
    for (const Index n : finenesses(most_)) add("sag", pattern, mode, 0.0, n, relative_sag(n, pattern, mode));
  }

  void swing(Pattern pattern, Mode mode) {
    for (const Index n : finenesses(most_))
      add("frequency", pattern, mode, 0.0, n, relative_membrane_frequency(n, pattern, mode));
  }

  void drape(Mode mode) {
    for (const Index n : finenesses(most_)) add("drape", Pattern::grid, mode, 0.0, n, drape_depth(n, mode));
  }

  Index most_;
  Figures figures_;
};

void write_tables(const Study& study, std::ostream& out) {
  const Figures& figures = study.figures();
  out << "Young's modulus over the material's\n\n";
  figures.write_refinement(out, "young");
  figures.write_rotation(out, "young", study.turned_cells());
  out << "Poisson's ratio\n\n";
  figures.write_refinement(out, "poisson");
  figures.write_rotation(out, "poisson", study.turned_cells());
  out << "Sag of a strip by its own weight, over M g L / (2 E w)\n\n";
  figures.write_refinement(out, "sag");
  out << "Lowest frequency of a membrane over the continuum's\n\n";
  figures.write_refinement(out, "frequency");
  out << "Depth of a drape [m]\n\n";
  figures.write_refinement(out, "drape");
}

void run(bool quick, const std::filesystem::path& folder) {
  Study study(quick ? 8 : 128);
  study.run();
  study.check();
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  std::ofstream csv(folder / "refinement.csv"), tables(folder / "refinement_tables.md");
  study.figures().write_csv(csv);
  write_tables(study, tables);
  csv.close();
  tables.close();
  require(csv.good() && tables.good(), "cannot write to " + folder.string());
}

}  // namespace
}  // namespace hooke::bench

int main(int count, char** arguments) {
  bool quick = false;
  std::filesystem::path folder;
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(arguments[i], "--quick") == 0) {
      quick = true;
    } else if (arguments[i][0] != '-' && folder.empty()) {
      folder = arguments[i];
    } else {
      std::fprintf(stderr, "usage: bench_refinement [--quick] [FOLDER]\n");
      return 2;
    }
  }
  try {
    hooke::bench::run(quick, folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_refinement: %s\n", error.what());
    return 1;
  }
  return 0;
}
