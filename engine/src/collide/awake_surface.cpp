#include "collide/awake_surface.h"

#include <algorithm>

namespace hooke {
namespace {

/// Islands asleep are taken that are so many times the reach away, so that the next steps need not choose
/// again.
constexpr double ample = 8.0;

Bounds<double> bounds_of(const AxisBox& box) {
  return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
}

Bounds<double> bounds_within(AxisBox box, double distance) {
  box.grow(distance);
  return bounds_of(box);
}

bool meets(const BoundsList<double>& list, const Bounds<double>& box) {
  return next_meeting(list, box, 0) < list.size();
}

}  // namespace

template <class Real>
AwakeSurface<Real>::AwakeSurface(Surface whole, const Model<Real>& model, double reach)
    : model_(model), reach_(reach), part_(std::move(whole)) {
  if (model.islands == nullptr) return;
  whole_ = part_;
  corners_ = IslandMembers(*model.islands, model.order, whole_.corners);
  around_.resize(model.islands->size());
  taken_.assign(model.islands->size(), 1);
}

template <class Real>
bool AwakeSurface<Real>::choose(const StepResult<Real>& result) {
  if (model_.islands == nullptr) return false;
  const bool changed = model_.islands_changed(islands_seen_);
  if (!changed && left_out_.size() == 0) return false;
  look(result, changed);
  if (!changed && !is_any_left_out_near()) return false;
  const std::vector<char> before = taken_;
  find_near();
  if (taken_ == before) return false;
  take_part();
  return true;
}

/// Where islands are in a step; those that sleep stay.
template <class Real>
void AwakeSurface<Real>::look(const StepResult<Real>& result, bool asleep_too) {
  for (Index island = 0; island < around_.size(); ++island) {
    if (model_.islands->sleeps(island) && !asleep_too) continue;
    AxisBox& around = around_[island] = {};
    for (const Index corner : corners_.of(island)) {
      around.widen(Vec3(result.start.position(corner).template cast<double>()));
      around.widen(Vec3(result.next.position(corner).template cast<double>()));
    }
  }
}

template <class Real>
bool AwakeSurface<Real>::is_any_left_out_near() const {
  for (Index island = 0; island < around_.size(); ++island) {
    if (!model_.islands->sleeps(island) && meets(left_out_, bounds_of(around_[island]))) return true;
  }
  return false;
}

template <class Real>
void AwakeSurface<Real>::find_near() {
  const Islands& islands = *model_.islands;
  BoundsList<double> awake;
  for (Index island = 0; island < islands.size(); ++island) {
    if (!islands.sleeps(island)) awake.add(bounds_of(around_[island]));
  }
  left_out_ = {};
  any_sleeps_ = false;
  for (Index island = 0; island < islands.size(); ++island) {
    taken_[island] = !islands.sleeps(island) || meets(awake, bounds_within(around_[island], ample * reach_));
    any_sleeps_ = any_sleeps_ || (taken_[island] != 0 && islands.sleeps(island));
    if (taken_[island] == 0) left_out_.add(bounds_within(around_[island], reach_));
  }
}

template <class Real>
void AwakeSurface<Real>::take_part() {
  const auto is_taken = [&](Index particle) { return taken_[island_of(particle)] != 0; };
  part_ = {};
  std::ranges::copy_if(whole_.triangles, std::back_inserter(part_.triangles),
                       [&](const Triangle& triangle) { return is_taken(triangle[0]); });
  std::ranges::copy_if(whole_.edges, std::back_inserter(part_.edges),
                       [&](const Edge& edge) { return is_taken(edge.first); });
  std::ranges::copy_if(whole_.corners, std::back_inserter(part_.corners), is_taken);
}

template <class Real>
std::size_t AwakeSurface<Real>::bytes() const {
  return corners_.bytes() + around_.capacity() * sizeof(AxisBox) + taken_.capacity() + left_out_.bytes();
}

template class AwakeSurface<float>;
template class AwakeSurface<double>;

}  // namespace hooke
