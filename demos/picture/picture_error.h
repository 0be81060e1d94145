#pragma once

#include <stdexcept>

namespace hooke::picture {

/// Thrown where no picture can be made: the message says why and what to install or to change.
class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hooke::picture
