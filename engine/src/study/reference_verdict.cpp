#include <string>

#include "study/method_choice.h"
#include "study/reference_solution.h"

namespace hooke::study {
namespace {

std::string seconds(double value) {
  return short_text(value) + " s";
}

std::string how_far(const ReferenceSolution& solution, const StudySettings& settings) {
  if (solution.reached == last_tick) return "";
  const std::string reached = seconds(solution.report.reached) + " of " + seconds(settings.horizon);
  if (solution.broke_down)
    return "A reference broke down: its steps went bad, or would have become too short, after " + reached +
           ". ";
  if (solution.stopped) return "The study was stopped when the references had reached " + reached + ". ";
  return "Within their share of the budget of " + seconds(settings.budget) + " the references reached " +
         reached + "; a larger budget or a shorter horizon would let them reach the end. ";
}

}  // namespace

std::string verdict(const ReferenceSolution& solution, const StudySettings& settings) {
  const std::string reach = how_far(solution, settings);
  if (solution.trusted == 0) {
    return reach +
           "The references do not agree to 1/100 of the tolerance at any output, so no errors of positions "
           "are shown.";
  }
  const std::string until = seconds(solution.report.trusted_until);
  const std::string smallest = short_text(solution.smallest_error(solution.trusted)) +
                               " of the scene's size, 100 times the difference of the references.";
  if (solution.trusted == solution.reached)
    return reach + "The references agree up to " + until + ". Errors of positions are shown down to " +
           smallest;
  return reach + "After " + until +
         " the references differ by more than 1/100 of the tolerance: the motion is chaotic, or too rough to "
         "be "
         "solved so well (contact). Errors of positions are shown up to this time, and down to " +
         smallest + " For what comes after it, energies are shown.";
}

}  // namespace hooke::study
