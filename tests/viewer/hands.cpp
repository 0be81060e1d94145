#include "viewer/hands.h"

#include <cmath>
#include <stdexcept>

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>

namespace hooke::test {

Hands::Hands() : display_(XOpenDisplay(nullptr)) {
  if (display_ == nullptr) throw std::runtime_error("the display cannot be opened");
}

Hands::~Hands() {
  XCloseDisplay(display_);
}

void Hands::find_window() {
  Window focus = None, child = None;
  int revert = 0;
  XGetInputFocus(display_, &focus, &revert);
  if (focus == None || focus == PointerRoot) throw std::runtime_error("no window has the keyboard");
  window_ = focus;
  XTranslateCoordinates(display_, focus, DefaultRootWindow(display_), 0, 0, &left_, &top_, &child);
}

void Hands::move(double x, double y) {
  XTestFakeMotionEvent(display_, -1, left_ + int(std::lround(x)), top_ + int(std::lround(y)), CurrentTime);
  XSync(display_, False);
}

void Hands::press(unsigned button) {
  XTestFakeButtonEvent(display_, button, True, CurrentTime);
  XSync(display_, False);
}

void Hands::release(unsigned button) {
  XTestFakeButtonEvent(display_, button, False, CurrentTime);
  XSync(display_, False);
}

void Hands::turn(unsigned long key, bool down) {
  XTestFakeKeyEvent(display_, XKeysymToKeycode(display_, key), down ? True : False, CurrentTime);
  XSync(display_, False);
}

void Hands::hold(const std::string& key, bool down) {
  const KeySym symbol = XStringToKeysym(key.c_str());
  if (symbol == NoSymbol) throw std::runtime_error("there is no key " + key);
  turn(symbol, down);
}

void Hands::type(const std::string& key, bool shift) {
  if (shift) hold("Shift_L", true);
  hold(key, true);
  hold(key, false);
  if (shift) hold("Shift_L", false);
}

void Hands::close_window() {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window_;
  event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = long(XInternAtom(display_, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(display_, window_, False, NoEventMask, &event);
  XSync(display_, False);
}

}  // namespace hooke::test
