#include "collide/prepared_mesh.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace hooke {
namespace {

/// What is in use somewhere in this process, and what it was made of.
template <class Real>
struct InUse {
  struct One {
    MeshShape mesh;
    double reach;
    std::weak_ptr<const MeshDistance<Real>> distances;

    bool is_of(const MeshShape& other, double other_reach) const {
      return reach == other_reach && mesh.scale == other.scale && mesh.triangles == other.triangles &&
             mesh.vertices == other.vertices;
    }
  };

  std::mutex mutex;
  std::vector<One> all;

  std::shared_ptr<const MeshDistance<Real>> find(const MeshShape& mesh, double reach) {
    const std::lock_guard lock(mutex);
    std::erase_if(all, [](const One& one) { return one.distances.expired(); });
    const auto found = std::ranges::find_if(all, [&](const One& one) { return one.is_of(mesh, reach); });
    return found == all.end() ? nullptr : found->distances.lock();
  }

  void add(One one) {
    const std::lock_guard lock(mutex);
    all.push_back(std::move(one));
  }
};

template <class Real>
InUse<Real>& in_use() {
  static InUse<Real> instance;
  return instance;
}

}  // namespace

template <class Real>
std::shared_ptr<const MeshDistance<Real>> prepared_mesh(const MeshShape& mesh, double reach) {
  if (auto found = in_use<Real>().find(mesh, reach)) return found;
  auto made = std::make_shared<const MeshDistance<Real>>(welded_surface(mesh), reach);
  in_use<Real>().add({mesh, reach, made});
  return made;
}

template std::shared_ptr<const MeshDistance<float>> prepared_mesh(const MeshShape&, double);
template std::shared_ptr<const MeshDistance<double>> prepared_mesh(const MeshShape&, double);

}  // namespace hooke
