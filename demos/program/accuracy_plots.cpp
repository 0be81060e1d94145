#include "program/accuracy_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "program/gnuplot.h"
#include "program/rounded.h"
#include "writers/numbers.h"

namespace hooke::program {
namespace {

/// How the curve of a method looks: told apart by colour, point and dashes, so in grey, too.
struct Look {
  const char *colour, *dashes;
  int point;
};

constexpr std::array looks{Look{"#1b6ca8", "1", 7},         Look{"#d1661b", "2", 4},
                           Look{"#4c8c3f", "3", 9},         Look{"#8a4fa3", "4", 10},
                           Look{"#000000", "1", 5},         Look{"#b03050", "5", 12},
                           Look{"#5f7d00", "(2,3)", 6},     Look{"#00708a", "(12,4)", 13},
                           Look{"#7a5230", "(8,3,2,3)", 8}, Look{"#606060", "(3,6)", 11}};

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string head(const std::string& title, const std::string& x, const std::string& y) {
  std::string script =
      "set datafile separator ','\nset datafile missing 'NaN'\n"
      "set grid back linetype 1 linecolor rgb '#d8d8d8' linewidth 0.7\nset border 3\nset tics nomirror\nset "
      "tmargin 5\n"
      "set key outside right center vertical Left reverse samplen 5 width 1 spacing 1.2\nset format '%g'\n";
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Look& look = looks[i];
    script += "set style line " + std::to_string(i + 1) + " linewidth 2 pointsize 1.1 linecolor rgb '" +
              look.colour + "' dashtype " + look.dashes + " pointtype " + std::to_string(look.point) + '\n';
  }
  return script + "set title " + gnuplot_string(title) + " offset 0,2\nset xlabel " + gnuplot_string(x) +
         "\nset ylabel " + gnuplot_string(y) + '\n';
}

/// The same picture for the page and for everything else.
std::string drawn_twice(const std::string& name, const std::string& plot) {
  const auto draw = [&](const std::string& terminal, const std::string& end) {
    return "set terminal " + terminal + "\nset output '" + name + end + "'\n" + plot + "\nunset output\n";
  };
  return draw("svg size 1000,600 font 'sans,14' background 'white' noenhanced", ".svg") +
         draw("pngcairo size 1000,600 font 'sans,12' background 'white' noenhanced", ".png");
}

/// The methods that have runs, in their order.
std::vector<std::string> methods_of(const AccuracyStudy& study) {
  std::vector<std::string> methods;
  for (const AccuracyRun& run : study.runs) {
    if (methods.empty() || methods.back() != run.choice.method) methods.push_back(run.choice.method);
  }
  return methods;
}

/// The errors [1] that a picture of one horizon shows: where its axis begins and ends, and where those runs
/// are drawn that have no error to show.
struct ErrorAxis {
  double low, high, below_reference, diverged;
};

ErrorAxis error_axis(const AccuracyStudy& study, double horizon, double smallest) {
  double low = study.tolerance, high = study.tolerance, below = not_measured;
  for (const AccuracyRun& run : study.runs) {
    if (run.horizon != horizon) continue;
    if (run.below_reference) low = std::min(low, below = smallest);
    if (run.largest_rms_error > 0.0) {
      low = std::min(low, run.largest_rms_error);
      high = std::max(high, run.largest_rms_error);
    }
  }
  const double end = std::pow(10.0, std::ceil(std::log10(high) + 0.1));
  return {std::pow(10.0, std::floor(std::log10(low) - 0.1)), end * std::pow(10.0, 0.8), below,
          end * std::pow(10.0, 0.4)};
}

/// Upright lines with a word above them, where they are not over the curves; at two heights, as they may be
/// near to each other.
std::string marks(const AccuracyStudy& study, const ErrorAxis& axis) {
  const auto mark = [](double at, const std::string& word, const std::string& height, int dashes) {
    const std::string x = number(at);
    return "set arrow from " + x + ", graph 0 to " + x +
           ", graph 1 nohead linecolor rgb '#808080' dashtype " + std::to_string(dashes) + "\nset label '" +
           word + "' at " + x + ", graph " + height + " center\n";
  };
  std::string text =
      mark(study.tolerance, "tolerance", "1.07", 2) + mark(axis.diverged, "diverged", "1.03", 3);
  if (!std::isnan(axis.below_reference)) text += mark(axis.below_reference, "reference", "1.03", 4);
  return text;
}

/// The line style of a method, the same in all pictures.
std::string style_of(const std::vector<std::string>& methods, const std::string& method) {
  const auto at = std::find(methods.begin(), methods.end(), method) - methods.begin();
  return "linestyle " + std::to_string(static_cast<std::size_t>(at) % looks.size() + 1);
}

/// For each method its curve, and its runs without an error to show as points at the marks. Each is in the
/// key, also where it has no curve.
std::string error_curves(const AccuracyStudy& study, double horizon, const ErrorAxis& axis,
                         const std::string& cost) {
  const std::vector<std::string> methods = methods_of(study);
  std::string plot;
  for (const std::string& method : methods) {
    const std::string style = style_of(methods, method);
    const std::string mine =
        "strcol('method') eq '" + method + "' && column('horizon_s') == " + number(horizon);
    const auto points = [&](const std::string& where, const std::string& x, const std::string& with) {
      return ", \\\n     '" + std::string(runs_file) + "' using (" + mine + where + " ? " + x +
             " : NaN):(column('" + cost + "')) with " + with + " " + style + " notitle";
    };
    plot += std::string(plot.empty() ? "plot " : ", \\\n     ") + "keyentry with linespoints " + style +
            " title '" + method + "'" + points("", "column('largest_rms_error')", "linespoints") +
            points(" && column('diverged') == 1", number(axis.diverged), "points");
    if (!std::isnan(axis.below_reference))
      plot += points(" && column('below_reference') == 1", number(axis.below_reference), "points");
  }
  return plot;
}

Plot error_plot(const AccuracyReport& report, std::size_t h, const std::string& which,
                const std::string& cost, const std::string& cost_label) {
  const AccuracyStudy& study = report.study;
  const double horizon = study.horizons[h];
  const ErrorAxis axis = error_axis(study, horizon, study.smallest_errors[h]);
  Plot plot;
  plot.name = "error_" + which + (h + 1 == study.horizons.size() ? "" : "_short");
  plot.caption = "Error against " + cost_label + ", over " + rounded(horizon) +
                 " s of simulated time. Down and left is better. Runs that diverged are drawn at the right "
                 "edge, at the cost at which they did; errors below " +
                 rounded(study.smallest_errors[h]) +
                 " are smaller than the references can tell, and runs with such are drawn there.";
  const std::string settings =
      head(report.study.scene + ": what accuracy costs over " + rounded(horizon) + " s",
           "largest RMS position error / scene size [1]", cost_label) +
      "set logscale xy\nset xrange [" + number(axis.low) + ":" + number(axis.high) + "]\n" +
      marks(study, axis);
  plot.script = settings + drawn_twice(plot.name, error_curves(study, horizon, axis, cost));
  return plot;
}

/// The energies [J] that the picture over time shows: those of the reference, and a margin.
std::pair<double, double> energy_range(const AccuracyStudy& study) {
  double low = study.reference.energy.front().energy.total(), high = low;
  for (const EnergySample& sample : study.reference.energy) {
    low = std::min(low, sample.energy.total());
    high = std::max(high, sample.energy.total());
  }
  double margin = study.energy_scale + 1e-9 * std::abs(high);
  if (margin == 0.0) margin = 1.0;  // nothing has any energy, and a picture needs a range
  return {low - margin, high + margin};
}

/// A curve for each method, of a column of the file of energies.
std::string energy_curves(const AccuracyStudy& study, const std::string& value, bool with_reference) {
  const auto curve = [&](const std::string& method, const std::string& style, const std::string& title) {
    return "'" + std::string(energies_file) + "' using (strcol('method') eq '" + method +
           "' ? column('time_s') : NaN):(" + value + ") with " + style + " title " + gnuplot_string(title);
  };
  const std::vector<std::string> methods = methods_of(study);
  std::string plot;
  if (with_reference)
    plot = "plot " + curve("reference", "lines linewidth 6 linecolor rgb '#c8c8c8'", "reference");
  for (std::size_t m = 0; m < study.energies.size(); ++m) {
    const MethodChoice& choice = study.energies[m].choice;
    const std::string every = " pointinterval " + std::to_string(20 + 2 * m);  // so that points lie apart
    plot +=
        (plot.empty() ? "plot " : ", \\\n     ") +
        curve(choice.method, "linespoints " + style_of(methods, choice.method) + every, to_string(choice));
  }
  return plot;
}

Plot energy_plot(const AccuracyReport& report) {
  const AccuracyStudy& study = report.study;
  const auto [low, high] = energy_range(study);
  Plot plot;
  plot.name = "energy";
  plot.caption =
      "Total energy over time, of one run of each method and of the reference. A curve that leaves the "
      "picture is of a run that diverges.";
  plot.script = head(study.scene + ": total energy", "time [s]", "kinetic + elastic + external energy [J]") +
                "set yrange [" + number(low) + ":" + number(high) +
                "]\nset xrange [0:" + number(study.horizon) + "]\n" +
                drawn_twice(plot.name, energy_curves(study, "column('total_J')", true));
  return plot;
}

Plot energy_difference_plot(const AccuracyReport& report) {
  const AccuracyStudy& study = report.study;
  Plot plot;
  plot.name = "energy_difference";
  plot.caption =
      "How far the total energy of the same runs is from the reference's, as a share of the energy "
      "that moves (" +
      rounded(study.energy_scale) + " J).";
  plot.script = head(study.scene + ": energy compared with the reference", "time [s]",
                     "difference of energy / energy that moves [1]") +
                "set logscale y\nset xrange [0:" + number(study.horizon) + "]\n" +
                drawn_twice(plot.name, energy_curves(study, "abs(column('difference'))", false));
  return plot;
}

/// Whether a logarithm can be drawn of any run's difference.
bool has_energy_differences(const AccuracyStudy& study) {
  for (const AccuracyRun& run : study.runs) {
    if (run.energy_error > 0.0) return true;
  }
  return false;
}

}  // namespace

std::vector<Plot> accuracy_plots(const AccuracyReport& report) {
  std::vector<Plot> plots;
  if (!report.study.runs.empty()) {
    for (std::size_t h = report.study.horizons.size(); h-- > 0;) {
      plots.push_back(error_plot(report, h, "time", "seconds", "wall time [s]"));
      plots.push_back(error_plot(report, h, "evaluations", "force_evaluations", "force evaluations [1]"));
    }
  }
  if (!report.study.reference.energy.empty()) plots.push_back(energy_plot(report));
  if (has_energy_differences(report.study)) plots.push_back(energy_difference_plot(report));
  return plots;
}

}  // namespace hooke::program
