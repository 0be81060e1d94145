#pragma once

#include <string>

struct _XDisplay;

namespace hooke::test {

/// Moves the mouse and presses keys as a user would: real events of the X server (XTest), which reach the
/// window that is there.
class Hands {
 public:
  Hands();
  ~Hands();
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  void move(double x, double y);  ///< [pixels] of the screen
  void press(unsigned button);
  void release(unsigned button);
  /// A key by the name that X gives it, such as "space" or "r"; with shift where its character needs it.
  void type(const std::string& key, bool shift = false);
  /// Holds a key down, such as "Control_L", or lets it go.
  void hold(const std::string& key, bool down);
  /// Asks the window that has the keyboard to close, as the cross in its frame does.
  void close_window();
  /// Where the window that has the keyboard begins on the screen [pixels].
  void find_window();

 private:
  void turn(unsigned long key, bool down);

  _XDisplay* display_;
  unsigned long window_ = 0;
  int left_ = 0, top_ = 0;
};

}  // namespace hooke::test
