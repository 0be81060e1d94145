#include "picture/background_layer.h"

namespace hooke::picture {

BackgroundLayer::BackgroundLayer() : program_(linked(background_shaders())) {}

void BackgroundLayer::draw() const {
  program_.use();
  glBindVertexArray(no_vertices_.name());
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
}

}  // namespace hooke::picture
