#pragma once

#include <string>

#include <sys/types.h>

namespace hooke::test {

/// An X server without a screen (Xvfb), on a display number of its own, for as long as it lives; DISPLAY
/// names it.
class VirtualDisplay {
 public:
  /// `reason` says why there is none, if so.
  VirtualDisplay(int width, int height);
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  bool there() const { return reason_.empty(); }
  const std::string& reason() const { return reason_; }

 private:
  pid_t process_ = -1;
  std::string reason_;
};

}  // namespace hooke::test
