#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace hooke {

/// While it lives, this thread's arithmetic takes subnormal numbers (below 1e-38 in float, 1e-308 in double)
/// as zero.
///
/// Processors compute with them up to a hundred times slower, and they are common: in a cloth that hangs in
/// one plane, the distances out of it fade away to nothing. Every thread of every loop sets it, so the bits
/// do not depend on the host's own setting. On other processors than x86 and 64-bit Arm nothing is done.
class FlushSubnormals {
 public:
#if defined(__SSE2__)
  FlushSubnormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | flush_to_zero | denormals_are_zero);
  }
  ~FlushSubnormals() {
    _mm_setcsr(before_);
  }

 private:
  static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;  // bits of MXCSR
  unsigned before_;
#elif defined(__aarch64__)
  FlushSubnormals() : before_(read()) {
    write(before_ | flush_to_zero);
  }
  ~FlushSubnormals() {
    write(before_);
  }

 private:
  static constexpr unsigned long flush_to_zero = 1ul << 24;  // a bit of FPCR; inputs and results alike
  static unsigned long read() {
    unsigned long value;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
  static void write(unsigned long value) {
    asm volatile("msr fpcr, %0" : : "r"(value));
  }
  unsigned long before_;
#else
  FlushSubnormals() {}
  ~FlushSubnormals() {}

 private:
#endif

 public:
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;
};

}  // namespace hooke
