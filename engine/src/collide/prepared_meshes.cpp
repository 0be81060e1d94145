#include "collide/prepared_meshes.h"

#include <algorithm>

#include "collide/mesh_distance.h"

namespace hooke {
namespace {

bool are_same(const MeshShape& a, const MeshShape& b) {
  return a.scale == b.scale && a.triangles == b.triangles && a.vertices == b.vertices;
}

}  // namespace

template <class Real>
std::shared_ptr<const MeshDistance<Real>> PreparedMeshes::distances(const MeshShape& mesh, double reach) {
  auto& all = std::get<std::vector<Prepared<Real>>>(all_);
  const auto found = std::ranges::find_if(
      all, [&](const auto& one) { return one.reach == reach && are_same(one.mesh, mesh); });
  if (found != all.end()) return found->distances;
  all.push_back({mesh, reach, std::make_shared<const MeshDistance<Real>>(welded_surface(mesh), reach)});
  return all.back().distances;
}

template std::shared_ptr<const MeshDistance<float>> PreparedMeshes::distances(const MeshShape&, double);
template std::shared_ptr<const MeshDistance<double>> PreparedMeshes::distances(const MeshShape&, double);

}  // namespace hooke
