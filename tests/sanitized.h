#pragma once

namespace hooke::test {

/// Built with a sanitizer that makes code many times slower. What it looks for shows in the first steps, so
/// tests that repeat the same code many times do so less often.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace hooke::test
