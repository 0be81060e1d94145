#pragma once

#include <string>
#include <vector>

#include <hooke/scene.h>

namespace hooke {

/// Where the parts of a scene that a file lists one by one stand in that file. The engine's checks number
/// elements as they are in the scene, where builders have added theirs; a user wants the place in the file.
struct ListedElements {
  std::vector<std::string> effects;  ///< place of each effect
  std::size_t particles = 0;         ///< how many are listed; they come first in the scene
  std::size_t first_spring = 0;      ///< number of the first listed spring in the scene
  std::size_t first_triangle = 0;
};

/// A fault that the engine found in one element, at `place` in the file. A problem such as "stiffness is -5
/// N/m" moves the name of the field to the place: "springs.stiffness", "is -5 N/m".
Fault at_place(Fault fault, const std::string& place);

/// A fault of validate(), at its place in the file. What comes from a builder keeps the engine's own name.
Fault in_file(Fault fault, const ListedElements& listed);

}  // namespace hooke
