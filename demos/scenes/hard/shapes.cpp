#include "scenes/hard/shapes.h"

namespace hooke::hard {

Sheet sheet(Index side, double damping) {
  Sheet made;
  made.grid = add(made.scene, ClothGrid{.columns = side,
                                        .rows = side,
                                        .spacing = 1.0 / double(side - 1),
                                        .areal_density = 0.2,
                                        .stretch = 1e3,
                                        .shear = 500.0,
                                        .bend = 0.0,
                                        .damping = damping});
  return made;
}

Sheet hung_sheet(Index side, double damping) {
  Sheet made = sheet(side, damping);
  made.scene.pin(made.grid.at(0, 0));
  made.scene.pin(made.grid.at(side - 1, 0));
  made.scene.effects = {Gravity{}};
  return made;
}

}  // namespace hooke::hard
