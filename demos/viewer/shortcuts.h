#pragma once

#include <span>

#include "viewer/actions.h"
#include "viewer/window.h"

namespace hooke::viewer {

/// A key and what it does.
struct Shortcut {
  KeyPress key;
  Action action;
  const char* keys;  ///< as they are told to the user
  const char* what;  ///< empty: a second key for what stands before it
};

std::span<const Shortcut> shortcuts();

/// What the mouse does, told likewise.
struct MouseHint {
  const char* how;
  const char* what;
};

std::span<const MouseHint> mouse_hints();

/// Does what the keys ask for.
void obey(std::span<const KeyPress> keys, State& state);

}  // namespace hooke::viewer
