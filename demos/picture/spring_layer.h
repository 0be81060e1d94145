#pragma once

#include <span>

#include "picture/program_pair.h"
#include "picture/subject.h"

namespace hooke::picture {

/// Springs, coloured by strain: each a strip that faces the eye, as lines of OpenGL are one pixel wide.
/// Positions are read from the texture that is bound.
class SpringLayer {
 public:
  explicit SpringLayer(const Subject& subject);

  void draw(Seen seen, Thickness radius, double full_strain) const;

 private:
  GLsizei count_;
  ProgramPair programs_;
  VertexArray no_vertices_;
  Buffer ends_, rest_lengths_;
  BufferTexture end_texture_, rest_length_texture_;
};

}  // namespace hooke::picture
