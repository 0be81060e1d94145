#pragma once

#include <string>
#include <string_view>

#include "viewer/style.h"

/// What panels are made of.

namespace hooke::viewer {

/// A name of the engine's as words for people: "position tolerance".
std::string spelled(std::string_view name);

/// Words at the left of a line, in the column for names; what is drawn next is at its right and fills it.
void name_line(const std::string& name);

/// A name and what is told of it.
void tell(const std::string& name, const std::string& value, const Colour& colour = palette::text);

/// A heading that can be folded; true where it is open.
bool section(const char* title);

/// A line of small, faint text that wraps.
void remark(const std::string& text);

/// Text in a colour, that wraps.
void coloured(const Colour& colour, const std::string& text);

/// A bar over the whole line, filled up to `share` [1], with words on it at the left and at the right.
void bar(double share, const Colour& colour, const std::string& left, const std::string& right);

/// A thin bar, filled up to `share` [1] and marked at `mark` [1]; words under it at the left and at the
/// right.
void gauge(double share, const Colour& colour, double mark, const std::string& left,
           const std::string& right);

/// A number to drag or to type, with its unit; false where it was not changed.
bool drag_number(const std::string& id, double& value, const std::string& unit);

}  // namespace hooke::viewer
