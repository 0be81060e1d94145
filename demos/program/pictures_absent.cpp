#include "picture/picture_error.h"
#include "program/pictures.h"

namespace hooke::program {

std::unique_ptr<Pictures> make_pictures(const PictureOptions&, const SceneFile&) {
  throw picture::PictureError(
      "this program was built without pictures; install their libraries (Debian: sudo apt-get install "
      "pkg-config "
      "libepoxy-dev libglfw3-dev libimgui-dev libpng-dev libegl1 libgl1-mesa-dri ffmpeg) and configure and "
      "build "
      "it again");
}

}  // namespace hooke::program
