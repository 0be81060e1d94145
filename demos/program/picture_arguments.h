#pragma once

#include "program/picture_options.h"

namespace CLI {
class App;
}

namespace hooke::program {

/// The options that say which pictures of a run to make.
void add_picture_options(CLI::App& command, PictureOptions& pictures);

}  // namespace hooke::program
