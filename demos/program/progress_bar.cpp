#include "program/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>

namespace hooke::program {
namespace {

constexpr std::chrono::milliseconds redraw_every{100};

std::string two_digits(std::uint64_t value) {
  return (value < 10 ? "0" : "") + std::to_string(value);
}

std::string duration(double seconds) {
  constexpr double longest = 359'999.0;  // [s] 99:59:59
  const auto whole = static_cast<std::uint64_t>(std::ceil(std::min(seconds, longest)));
  const std::string minutes_seconds = two_digits(whole / 60 % 60) + ":" + two_digits(whole % 60);
  return whole < 3600 ? minutes_seconds : std::to_string(whole / 3600) + ":" + minutes_seconds;
}

}  // namespace

std::string progress_line(double fraction, double elapsed) {
  constexpr std::size_t width = 40;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(done * width);
  std::string line = "[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] ";
  line += std::to_string(static_cast<int>(done * 100.0)) + " %";
  if (done > 0.0) line += ", " + duration(elapsed * (1.0 - done) / done) + " left";
  return line;
}

ProgressBar::ProgressBar(std::ostream& out, bool shown) : out_(out), shown_(shown) {}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::update(double fraction) {
  const Time::time_point now = Time::now();
  if (!shown_ || now - last_drawn_ < redraw_every) return;
  const std::chrono::duration<double> elapsed = now - start_;
  out_ << '\r' << progress_line(fraction, elapsed.count()) << "\x1b[K" << std::flush;
  last_drawn_ = now;
  drawn_ = true;
}

void ProgressBar::clear() {
  if (drawn_) out_ << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

}  // namespace hooke::program
