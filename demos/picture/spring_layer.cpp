#include "picture/spring_layer.h"

#include "picture/frame_uniforms.h"

namespace hooke::picture {

SpringLayer::SpringLayer(const Subject& subject)
    : count_(GLsizei(subject.springs.size())),
      programs_(spring_shaders(), spring_shadow_shaders()),
      end_texture_(ends_, GL_RG32UI),
      rest_length_texture_(rest_lengths_, GL_R32F) {
  ends_.set(GL_TEXTURE_BUFFER, std::span<const std::array<Index, 2>>(subject.springs));
  rest_lengths_.set(GL_TEXTURE_BUFFER, std::span<const float>(subject.rest_lengths));
}

void SpringLayer::draw(Seen seen, Thickness radius, double full_strain) const {
  if (count_ == 0) return;
  const Program& program = programs_.use(seen);
  glUniform3f(program.uniform("radius"), radius.metres, radius.least_pixels, radius.most_pixels);
  glUniform1f(program.uniform("full_strain"), float(full_strain));
  end_texture_.bind(item_unit);
  rest_length_texture_.bind(rest_length_unit);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 6 * count_);
}

}  // namespace hooke::picture
