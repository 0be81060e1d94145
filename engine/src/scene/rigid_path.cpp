#include <algorithm>

#include <hooke/keyframe.h>

namespace hooke {

RigidKeyframe on_path(const std::vector<RigidKeyframe>& path, double time) {
  const auto next =
      std::upper_bound(path.begin(), path.end(), time,
                       [](double t, const RigidKeyframe& keyframe) { return t < keyframe.time; });
  if (path.empty()) return {};
  if (next == path.begin()) return path.front();
  if (next == path.end()) return path.back();
  const RigidKeyframe &a = *(next - 1), &b = *next;
  const double share = (time - a.time) / (b.time - a.time);
  return {time, (1.0 - share) * a.displacement + share * b.displacement,
          (1.0 - share) * a.degrees + share * b.degrees};
}

}  // namespace hooke
