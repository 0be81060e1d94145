#include "ideas/account/show.h"

#include "picture/picture_error.h"

namespace hooke::ideas {

/// Where this was built without the libraries that pictures need.
void show(const std::filesystem::path& file, const std::vector<Moment>&, const View&) {
  if (file.empty()) return;
  throw picture::PictureError(
      "no picture: this was built without them. Install libepoxy, GLFW 3.3, Dear ImGui and libpng (Debian: "
      "libepoxy-dev libglfw3-dev libimgui-dev libpng-dev libegl1 libgl1-mesa-dri), then configure again");
}

}  // namespace hooke::ideas
