#include "driver_clock.h"

#include <ctime>
#include <type_traits>

#include <epoxy/gl.h>

namespace hooke::bench {
namespace {

double driver_seconds = 0.0;
unsigned long driver_calls = 0;

struct Counted {
  ~Counted() {
    driver_seconds += thread_seconds() - start;
    ++driver_calls;
  }
  double start = thread_seconds();
};

/// Stands for one function of OpenGL, which libepoxy holds as a pointer at `slot`.
template <auto slot>
struct Interposed;

template <class Result, class... Arguments, Result (**slot)(Arguments...)>
struct Interposed<slot> {
  static inline Result (*original)(Arguments...) = nullptr;

  static Result call(Arguments... arguments) {
    const Counted counted;
    return original(arguments...);
  }

  static void set(bool counting) {
    if (counting) {
      original = *slot;
      *slot = &call;
    } else {
      *slot = original;
    }
  }
};

template <auto... slots>
void set_all(bool counting) {
  (Interposed<slots>::set(counting), ...);
}

/// All functions that Renderer::upload and draw call.
void set_counting(bool counting) {
  set_all<&epoxy_glActiveTexture, &epoxy_glBindBuffer, &epoxy_glBindBufferBase, &epoxy_glBindFramebuffer,
          &epoxy_glBindTexture, &epoxy_glBindVertexArray, &epoxy_glBufferData, &epoxy_glClear,
          &epoxy_glColorMask, &epoxy_glDepthFunc, &epoxy_glDepthMask, &epoxy_glDisable, &epoxy_glDrawArrays,
          &epoxy_glDrawElements, &epoxy_glEnable, &epoxy_glGetFramebufferAttachmentParameteriv,
          &epoxy_glGetIntegerv, &epoxy_glGetUniformLocation, &epoxy_glPolygonOffset, &epoxy_glUniform1f,
          &epoxy_glUniform1i, &epoxy_glUniform3f, &epoxy_glUniform3fv, &epoxy_glUniform4f,
          &epoxy_glUseProgram, &epoxy_glViewport>(counting);
}

}  // namespace

double thread_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

DriverClock::DriverClock() {
  driver_seconds = 0.0;
  driver_calls = 0;
  set_counting(true);
}

DriverClock::~DriverClock() {
  set_counting(false);
}

double DriverClock::seconds() const {
  return driver_seconds;
}

unsigned long DriverClock::calls() const {
  return driver_calls;
}

}  // namespace hooke::bench
