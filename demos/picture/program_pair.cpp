#include "picture/program_pair.h"

#include "picture/frame_uniforms.h"

namespace hooke::picture {

Program linked(const ShaderText& text) {
  Program program(text.vertex, text.fragment);
  program.block("Frame", frame_block);
  program.sampler("positions", position_unit);
  program.sampler("items", item_unit);
  program.sampler("rest_lengths", rest_length_unit);
  program.sampler("shadow_map", shadow_unit);
  return program;
}

}  // namespace hooke::picture
