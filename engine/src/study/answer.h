#pragma once

#include <hooke/study.h>

namespace hooke::study {

/// The cheapest run of a study whose errors are within the tolerance at every output up to the longest
/// horizon, and the cheapest of another method.
Answer answer_of(const AccuracyStudy& study);

}  // namespace hooke::study
