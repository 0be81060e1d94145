#include "viewer/live/energy_history.h"

namespace hooke::viewer {
namespace {

constexpr std::size_t most_samples = 1024;

/// Drops every second sample.
void thin_out(std::vector<Measurement>& samples) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.size(); i += 2) samples[kept++] = samples[i];
  samples.resize(kept);
}

}  // namespace

void EnergyHistory::add(const std::vector<Measurement>& measurements) {
  for (const Measurement& measurement : measurements) {
    if (measurement.number <= last_number_) continue;
    last_number_ = measurement.number;
    append(measurement);
  }
}

void EnergyHistory::append(const Measurement& measurement) {
  if (!samples_.empty() && measurement.time < samples_.back().time) {
    samples_.clear();
    spacing_ = 0.0;
  }
  // The newest sample is always kept; the one before makes room where the two are too near.
  const bool crowded =
      samples_.size() > 1 && measurement.time - samples_[samples_.size() - 2].time < spacing_;
  const bool same_time = !samples_.empty() && measurement.time == samples_.back().time;
  if (crowded || same_time) samples_.pop_back();
  samples_.push_back(measurement);
  if (samples_.size() < most_samples) return;
  thin_out(samples_);
  spacing_ = (samples_.back().time - samples_.front().time) / static_cast<double>(samples_.size() - 1);
}

}  // namespace hooke::viewer
