#include "program/rounded.h"

#include <sstream>

namespace hooke::program {

std::string rounded(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

}  // namespace hooke::program
