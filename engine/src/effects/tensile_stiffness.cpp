#include "effects/tensile_stiffness.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace hooke {

double doubled_area(const Corners& x) {
  return side_of(x, 0).cross(side_of(x, 1)).norm();
}

Eigen::Matrix3d TensileStiffness::matrix() const {
  return b * b.transpose() + s * (2.0 * Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Ones());
}

/// It is G C G^T / 2, where G has the slopes of l^2 by the corners' places; its eigenvalues that are not zero
/// are those of the 3 x 3 matrix R^T G^T G R / 2 with C = R R^T.
double TensileStiffness::largest_at_rest(const Corners& x) const {
  Eigen::Matrix3d slopes;  // G^T G
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      slopes(Eigen::Index(i), Eigen::Index(j)) = (i == j ? 8.0 : -4.0) * side_of(x, i).dot(side_of(x, j));
  }
  const Eigen::LLT<Eigen::Matrix3d> factor(matrix());
  if (factor.info() != Eigen::Success) return 0.5 * (matrix() * slopes).trace();  // of a sliver: their sum
  const Eigen::Matrix3d root = factor.matrixL();
  const Eigen::Matrix3d same = 0.5 * root.transpose() * slopes * root;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(same, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

TensileStiffness stiffness_of(const TensileTriangles& sheet, const Corners& rest) {
  const double nu = sheet.poisson_ratio, doubled = doubled_area(rest);
  Vec3 cotangents;
  for (std::size_t i = 0; i < 3; ++i)
    cotangents[Eigen::Index(i)] = -side_of(rest, (i + 1) % 3).dot(side_of(rest, (i + 2) % 3)) / doubled;
  const double p = sheet.modulus / (1.0 - nu * nu);
  return {sheet.modulus / (1.0 + nu) / (8.0 * doubled), cotangents * std::sqrt(2.0 * p / (8.0 * doubled))};
}

Eigen::Matrix3d own_derivative(const StrainedTriangle& triangle, std::size_t corner, double stretching,
                               double turning) {
  const std::size_t a = (corner + 1) % 3, b = (corner + 2) % 3;
  const Eigen::Matrix3d c = triangle.stiffness.matrix();
  const Vec3 tension = c * triangle.stretch;
  Eigen::Matrix<double, 3, 2> slopes;
  slopes << side_of(triangle.x, a), -side_of(triangle.x, b);
  const auto i = Eigen::Index(a), j = Eigen::Index(b);
  const Eigen::Matrix2d between{{c(i, i), c(i, j)}, {c(j, i), c(j, j)}};
  const double turned = std::max(0.0, tension[i]) + std::max(0.0, tension[j]);
  return 2.0 * stretching * slopes * between * slopes.transpose() +
         turning * turned * Eigen::Matrix3d::Identity();
}

}  // namespace hooke
