#include "refinement/figures.h"

#include <cstdio>
#include <functional>
#include <iomanip>
#include <map>
#include <set>

namespace hooke::bench {
namespace {

std::string text_of(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Which figures a table has, and how it says how much they differ: a ratio near zero differs by any factor.
struct Wanted {
  std::string quantity;
  std::function<bool(const Figure&)> agrees;
  bool relative = quantity != "poisson";

  bool operator()(const Figure& figure) const { return figure.quantity == quantity && agrees(figure); }
};

/// A table in Markdown of the figures that are wanted: `column` says where one belongs.
template <class Column>
void write_table(std::ostream& out, const std::vector<Figure>& all, const std::string& heading,
                 const char* column_format, const Wanted& wanted, const Column& column) {
  std::set<double> columns;
  std::map<std::pair<Pattern, Mode>, std::map<double, double>> rows;
  for (const Figure& figure : all) {
    if (!wanted(figure)) continue;
    columns.insert(column(figure));
    rows[{figure.pattern, figure.mode}][column(figure)] = figure.value;
  }
  out << "| " << heading << " |";
  for (const double c : columns) out << ' ' << text_of(column_format, c) << " |";
  out << (wanted.relative ? " spread |\n|---|" : " difference |\n|---|");
  for (std::size_t i = 0; i <= columns.size(); ++i) out << "---:|";
  for (const auto& [kind, values] : rows) {
    out << "\n| " << to_string(kind.first) << ", " << to_string(kind.second) << " |";
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const double c : columns) {
      const auto found = values.find(c);
      out << ' ' << (found == values.end() ? "" : text_of("%.4f", found->second)) << " |";
      if (found == values.end()) continue;
      least = std::min(least, found->second);
      most = std::max(most, found->second);
    }
    out << ' '
        << (wanted.relative ? text_of("%.2f %%", 100.0 * (most / least - 1.0))
                            : text_of("%.4f", most - least))
        << " |";
  }
  out << "\n\n";
}

}  // namespace

void Figures::write_csv(std::ostream& out) const {
  out << "quantity,pattern,mode,angle,cells,value\n" << std::setprecision(9);
  for (const Figure& f : all_)
    out << f.quantity << ',' << to_string(f.pattern) << ',' << to_string(f.mode) << ',' << f.angle << ','
        << f.cells << ',' << f.value << '\n';
}

void Figures::write_refinement(std::ostream& out, const std::string& quantity) const {
  write_table(out, all_, "cells a side", "%.0f", {quantity, [](const Figure& f) { return f.angle == 0.0; }},
              [](const Figure& f) { return double(f.cells); });
}

void Figures::write_rotation(std::ostream& out, const std::string& quantity, Index cells) const {
  write_table(out, all_, "turned by", "%.0f deg",
              {quantity, [cells](const Figure& f) { return f.cells == cells; }},
              [](const Figure& f) { return f.angle; });
}

}  // namespace hooke::bench
