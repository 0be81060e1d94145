#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <hooke/scene.h>

#include "picture/program_pair.h"

namespace hooke::picture {

/// Balls, each a disc that faces the eye and is shaded as a ball. Positions are read from the texture that is
/// bound.
class BallLayer {
 public:
  explicit BallLayer(std::span<const Index> pins);

  void draw_pins(Seen seen, Thickness radius) const;
  void draw_particles(Seen seen, Thickness radius, std::size_t particles) const;

 private:
  using Colour = std::array<float, 3>;  ///< linear

  void draw(Seen seen, Thickness radius, std::size_t count, bool all_particles, const Colour& colour) const;

  std::size_t pins_;
  ProgramPair programs_;
  VertexArray no_vertices_;
  Buffer pin_numbers_;
  BufferTexture pin_texture_;
};

}  // namespace hooke::picture
