#include "viewer/shortcuts.h"

#include <array>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace hooke::viewer {
namespace {

constexpr KeyPress character(char c) {
  return {static_cast<unsigned>(c), 0};
}
constexpr KeyPress key(int number) {
  return {0, number};
}

// By the character that a key gives, not by its place, so that they hold on every keyboard.
constexpr std::array table{
    Shortcut{character(' '), Action::toggle_running, "Space", "pause, go on"},
    Shortcut{character('s'), Action::step, "S, Right arrow", "a single step"},
    Shortcut{key(GLFW_KEY_RIGHT), Action::step, "", ""},
    Shortcut{character('r'), Action::reset, "R", "back to the start"},
    Shortcut{character('+'), Action::faster, "+, -", "twice, half as fast"},
    Shortcut{character('-'), Action::slower, "", ""},
    Shortcut{key(GLFW_KEY_KP_ADD), Action::faster, "", ""},
    Shortcut{key(GLFW_KEY_KP_SUBTRACT), Action::slower, "", ""},
    Shortcut{character('f'), Action::fit, "F", "show all of the scene"},
    Shortcut{character('1'), Action::toggle_surface, "1", "surface"},
    Shortcut{character('2'), Action::toggle_springs, "2", "springs, coloured by strain"},
    Shortcut{character('3'), Action::toggle_particles, "3", "particles"},
    Shortcut{character('4'), Action::toggle_pins, "4", "pins"},
    Shortcut{character('a'), Action::toggle_study, "A", "what more accuracy would cost"},
    Shortcut{character('p'), Action::save_picture, "P", "save the picture as a PNG file"},
    Shortcut{key(GLFW_KEY_TAB), Action::toggle_panels, "Tab", "hide or show the panels"},
    Shortcut{character('?'), Action::toggle_help, "?", "this help"},
    Shortcut{key(GLFW_KEY_F1), Action::toggle_help, "", ""},
    Shortcut{key(GLFW_KEY_ESCAPE), Action::leave, "Esc", "leave the help, the study, the viewer"},
    Shortcut{character('q'), Action::quit, "Q", "quit"},
};

constexpr std::array hints{
    MouseHint{"Drag a particle", "pull it by a soft spring"},
    MouseHint{"Drag beside them", "orbit (over particles with Ctrl)"},
    MouseHint{"Right or Shift drag", "move the view"},
    MouseHint{"Wheel", "nearer to what is under the mouse"},
    MouseHint{"Double click beside", "show all of the scene"},
    MouseHint{"Drag a number", "change it; Ctrl and a click: type it"},
};

unsigned lower_case(unsigned c) {
  return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
}

bool is(const KeyPress& wanted, const KeyPress& pressed) {
  if (wanted.character != 0) return wanted.character == lower_case(pressed.character);
  return wanted.key == pressed.key;
}

}  // namespace

std::span<const Shortcut> shortcuts() {
  return table;
}

std::span<const MouseHint> mouse_hints() {
  return hints;
}

void obey(std::span<const KeyPress> keys, State& state) {
  for (const KeyPress& pressed : keys) {
    for (const Shortcut& shortcut : table) {
      if (is(shortcut.key, pressed)) perform(shortcut.action, state);
    }
  }
}

}  // namespace hooke::viewer
