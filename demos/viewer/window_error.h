#pragma once

#include <stdexcept>

namespace hooke::viewer {

/// Thrown where no window can be opened; what() says why, and what to do.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hooke::viewer
