#include "ideas/account/plot.h"

#include <cstdio>
#include <fstream>
#include <sstream>

#include "picture/picture_error.h"
#include "program/gnuplot.h"
#include "writers/temporary_folder.h"

namespace hooke::ideas {
namespace {

/// Colours and lines of every plot.
constexpr const char* head =
    "set terminal pngcairo size 960,540 font 'sans,11' background 'white' noenhanced\n"
    "set border 3 linecolor rgb '#505050'\nset tics nomirror\n"
    "set grid back linetype 1 linecolor rgb '#e4e4e4' linewidth 0.7\n"
    "set key Left reverse samplen 2 spacing 1.25\n";

/// The points of all curves as gnuplot's data blocks.
std::string data_blocks(const std::vector<Panel>& panels) {
  std::ostringstream data;
  data.precision(9);
  int block = 0;
  for (const Panel& panel : panels) {
    for (const Curve& curve : panel.curves) {
      data << "$d" << ++block << " << EOD\n";
      for (const auto& [x, y] : curve.points) data << x << ' ' << y << '\n';
      data << "EOD\n";
    }
  }
  return data.str();
}

/// For each panel the command that plots its blocks.
std::string plot_commands(const std::vector<Panel>& panels) {
  std::ostringstream commands;
  int block = 0;
  for (const Panel& panel : panels) {
    commands << "set title " << program::gnuplot_string(panel.title) << "\nplot ";
    for (const Curve& curve : panel.curves) {
      commands << (&curve == &panel.curves.front() ? "" : ", \\\n  ") << "$d" << ++block << " with "
               << curve.style
               << (curve.title.empty() ? " notitle" : " title " + program::gnuplot_string(curve.title));
    }
    commands << '\n';
  }
  return commands.str();
}

}  // namespace

void plot(const std::filesystem::path& file, const std::string& settings, const std::vector<Panel>& panels,
          int columns) {
  if (file.empty()) return;
  const TemporaryFolder folder;
  const int rows = (int(panels.size()) + columns - 1) / columns;
  std::ofstream(folder.path() / "plot.gp")
      << data_blocks(panels) << head << settings << "\nset output "
      << program::gnuplot_string(std::filesystem::absolute(file).string()) << "\nset multiplot layout "
      << rows << ',' << columns
      << (panels.size() > 1 ? " margins 0.09,0.97,0.06,0.95 spacing 0.1,0.085\n" : "\n")
      << plot_commands(panels) << "unset multiplot\nunset output\n";
  const program::Drawing drawing = program::draw(folder.path(), "plot.gp");
  if (drawing == program::Drawing::no_gnuplot)
    throw picture::PictureError("no picture: there is no gnuplot. Install it (Debian: gnuplot-nox)");
  if (drawing == program::Drawing::failed)
    throw picture::PictureError("no picture: gnuplot could not draw " + file.string() +
                                ": can it be written?");
  std::printf("  picture: %s\n", file.c_str());
}

}  // namespace hooke::ideas
