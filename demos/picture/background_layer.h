#pragma once

#include "picture/program_pair.h"

namespace hooke::picture {

/// What is behind everything: a light that grows upwards.
class BackgroundLayer {
 public:
  BackgroundLayer();
  void draw() const;

 private:
  Program program_;
  VertexArray no_vertices_;
};

}  // namespace hooke::picture
