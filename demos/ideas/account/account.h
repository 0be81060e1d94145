#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include <hooke/simulation.h>
#include "program/stopwatch.h"

namespace hooke::ideas {

/// The account that a demo gives: what it was asked for, which of its claims are true, and what its steps
/// cost.
class Account {
 public:
  Account(std::filesystem::path picture, double longest) : picture_(std::move(picture)), longest_(longest) {}

  /// The PNG to draw; empty: none.
  const std::filesystem::path& picture() const { return picture_; }

  /// How long to simulate [s]: `usual`, or less where the command line says so.
  double seconds(double usual) const { return usual < longest_ ? usual : longest_; }

  /// Whether the demo runs as long as it would by itself. What takes time to come true is claimed only then.
  bool runs_in_full(double usual) const { return usual <= longest_; }

  /// Prints what the demo claims (as by printf), and remembers if it is not true.
  [[gnu::format(printf, 3, 4)]] void claim(bool is_true, const char* format, ...);

  /// Takes steps by calling `steps`, which returns their report, and measures them. Throws std::runtime_error
  /// where a step goes bad.
  template <class Steps>
  Report measure(Steps&& steps) {
    const program::Stopwatch watch;
    const Report report = steps();
    seconds_ += watch.seconds();
    steps_ += report.steps_taken;
    if (!report.ok()) throw std::runtime_error(report.message());
    return report;
  }

  /// Prints what a step cost. The gallery reads this line.
  template <class Real>
  void print_cost(const Simulation<Real>& simulation) const {
    print_cost(simulation.particle_count(), simulation.spring_count(), simulation.threads());
  }
  void print_cost(std::size_t particles, std::size_t springs, unsigned threads) const;

  double milliseconds_a_step() const;  ///< [ms] of wall time
  bool all_true() const { return all_true_; }

 private:
  std::filesystem::path picture_;
  double longest_;  ///< [s]
  double seconds_ = 0.0;
  std::uint64_t steps_ = 0;
  bool all_true_ = true;
};

/// Whether a demo can be told to end early.
enum class Length { as_asked, fixed };

/// The main() of every demo: reads `--picture FILE.png` and `--seconds S`, prints the title, runs the demo.
/// Returns 0 where all that it claims is true, 1 where something is not or went wrong, 2 for bad arguments.
int give_account(int argc, char** argv, const char* title, void (*demo)(Account&),
                 Length length = Length::as_asked);

}  // namespace hooke::ideas
