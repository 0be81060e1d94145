#include "picture/ball_layer.h"

#include "picture/frame_uniforms.h"

namespace hooke::picture {

BallLayer::BallLayer(std::span<const Index> pins)
    : pins_(pins.size()),
      programs_(ball_shaders(), ball_shadow_shaders()),
      pin_texture_(pin_numbers_, GL_R32UI) {
  pin_numbers_.set(GL_TEXTURE_BUFFER, pins);
}

void BallLayer::draw_pins(Seen seen, Thickness radius) const {
  draw(seen, radius, pins_, false, {0.020f, 0.026f, 0.045f});
}

void BallLayer::draw_particles(Seen seen, Thickness radius, std::size_t particles) const {
  draw(seen, radius, particles, true, {0.030f, 0.210f, 0.260f});
}

void BallLayer::draw(Seen seen, Thickness radius, std::size_t count, bool all_particles,
                     const Colour& colour) const {
  if (count == 0) return;
  const Program& program = programs_.use(seen);
  glUniform3f(program.uniform("radius"), radius.metres, radius.least_pixels, radius.most_pixels);
  glUniform1i(program.uniform("all_particles"), all_particles);
  glUniform3fv(program.uniform("tone"), 1, colour.data());
  pin_texture_.bind(item_unit);
  glBindVertexArray(no_vertices_.name());
  // The coverage of a disc's edge becomes samples.
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(6 * count));
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

}  // namespace hooke::picture
