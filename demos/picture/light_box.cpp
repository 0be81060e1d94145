#include "picture/light_box.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace hooke::picture {

LightBox light_box(const Bounds& bounds, double margin, const Eigen::Vector3d& to_light, int texels) {
  const double least = 1e-6 * (1e-6 + bounds.centre().norm());  // below this, floats cannot tell places apart
  const double needed = 1.1 * std::max(0.5 * bounds.diagonal() + margin, least);
  const double radius = std::pow(1.25, std::ceil(std::log(needed) / std::log(1.25)));
  const double texel = 2.0 * radius / texels;
  Eigen::Matrix3d axes;
  axes.row(2) = to_light.normalized();
  axes.row(0) = axes.row(2).unitOrthogonal();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  Eigen::Vector3d centre = axes * bounds.centre();
  for (int k = 0; k < 2; ++k) centre[k] = texel * std::round(centre[k] / texel);

  Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
  clip.block<3, 3>(0, 0) = axes / radius;
  clip.block<3, 1>(0, 3) = -centre / radius;
  clip.row(2) = -clip.row(2);  // depth grows away from the light
  clip(3, 3) = 1.0;
  Eigen::Matrix4d shadow = 0.5 * clip;
  for (int k = 0; k < 3; ++k) shadow(k, 3) += 0.5;
  shadow.row(3) = Eigen::RowVector4d(0, 0, 0, 1);
  return {clip.cast<float>(), shadow.cast<float>(), texel};
}

}  // namespace hooke::picture
