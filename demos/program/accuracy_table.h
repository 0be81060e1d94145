#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <hooke/study.h>

#include "program/text_table.h"

namespace hooke::program {

/// The runs of a study up to one of its horizons [s], a row each below a row of headings.
std::vector<TableRow> run_rows(const AccuracyStudy& study, double horizon);

/// Energies after the end of trust, likewise; empty where positions are trusted to the end.
std::vector<TableRow> long_run_rows(const AccuracyStudy& study);

/// Prints a study for people: its runs up to the longest horizon, what was left out, and the answer.
void print_study(const AccuracyStudy& study, std::ostream& out);

}  // namespace hooke::program
