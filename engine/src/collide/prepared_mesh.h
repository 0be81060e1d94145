#pragma once

#include <memory>

#include <hooke/shapes.h>

#include "collide/mesh_distance.h"

namespace hooke {

/// The distances to a mesh, below `reach` [m] exact. To prepare them takes seconds for large meshes, so those
/// that are in use already are shared: a simulation that is made anew, as for a scene that has torn, has them
/// at once.
template <class Real>
std::shared_ptr<const MeshDistance<Real>> prepared_mesh(const MeshShape& mesh, double reach);

}  // namespace hooke
