#pragma once

#include "picture/gl_objects.h"
#include "picture/shaders.h"

namespace hooke::picture {

/// What is drawn twice: for the eye, and into the shadow map.
enum class Seen { by_eye, by_light };

/// A size on the picture: so many metres, within limits in pixels.
struct Thickness {
  float metres, least_pixels, most_pixels;
};

/// Makes a program that finds its textures and its block of uniforms.
Program linked(const ShaderText& text);

/// A program for the eye and one for the light.
class ProgramPair {
 public:
  ProgramPair(const ShaderText& for_eye, const ShaderText& for_light)
      : for_eye_(linked(for_eye)), for_light_(linked(for_light)) {}

  /// The program, now in use.
  const Program& use(Seen seen) const {
    const Program& program = seen == Seen::by_eye ? for_eye_ : for_light_;
    program.use();
    return program;
  }

 private:
  Program for_eye_, for_light_;
};

}  // namespace hooke::picture
