#pragma once

#include <memory>
#include <tuple>
#include <vector>

#include <hooke/shapes.h>

namespace hooke {

template <class Real>
class MeshDistance;

/// The distances to the meshes of a simulation. To prepare them takes seconds for large meshes, so each is
/// prepared once for all that ask for it: a simulation that is made anew, as for a scene that has torn, is
/// given those of the one before.
class PreparedMeshes {
 public:
  /// The distances to a mesh, below `reach` [m] exact.
  template <class Real>
  std::shared_ptr<const MeshDistance<Real>> distances(const MeshShape& mesh, double reach);

  /// How many have been prepared.
  std::size_t size() const { return std::get<0>(all_).size() + std::get<1>(all_).size(); }

 private:
  template <class Real>
  struct Prepared {
    MeshShape mesh;
    double reach;
    std::shared_ptr<const MeshDistance<Real>> distances;
  };

  std::tuple<std::vector<Prepared<float>>, std::vector<Prepared<double>>> all_;
};

}  // namespace hooke
