#include <ostream>

#include "program/exit_code.h"
#include "program/view.h"

namespace hooke::program {

int view(const Arguments&, const ViewOptions&, std::ostream&, std::ostream& problems) {
  problems
      << "hooke: this hooke was built without the viewer: install libepoxy, GLFW 3.3, Dear ImGui and libpng "
         "(Debian: libepoxy-dev libglfw3-dev libimgui-dev libpng-dev pkg-config), then run cmake again\n";
  return exit_bad_input;
}

}  // namespace hooke::program
