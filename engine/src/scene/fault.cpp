#include <algorithm>
#include <utility>

#include <hooke/scene.h>

namespace hooke {
namespace {

std::string list(const std::vector<Fault>& faults) {
  constexpr std::size_t most_listed = 10;  // enough to see a pattern, few enough to read
  const std::size_t listed = std::min(faults.size(), most_listed);
  std::string text;
  for (std::size_t i = 0; i < listed; ++i) {
    if (i > 0) text += '\n';
    text += faults[i].message();
  }
  if (faults.size() > listed) text += "\n... and " + std::to_string(faults.size() - listed) + " more";
  return text;
}

}  // namespace

std::string Fault::message() const {
  return element + ": " + problem + "; " + remedy;
}

SceneError::SceneError(std::vector<Fault> faults)
    : std::invalid_argument(list(faults)), faults_(std::move(faults)) {}

}  // namespace hooke
