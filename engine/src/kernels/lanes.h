#pragma once

/// Before a loop over the lanes of a block: no lane reads what another writes, so the loop can be vectorised
/// without a test at run time whether the arrays overlap. In short loops with a dozen arrays those tests cost
/// more than the work.
#if defined(__clang__)
#define HOOKE_INDEPENDENT_LANES _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define HOOKE_INDEPENDENT_LANES _Pragma("GCC ivdep")
#else
#define HOOKE_INDEPENDENT_LANES
#endif
