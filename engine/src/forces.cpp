#include "forces.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "parallel/sum.h"

namespace hooke {
namespace {

/// Springs that one thread takes at a time: long enough to hide the cost of handing them out.
constexpr std::size_t spring_grain = 4096;

std::string percent(double share) {
  std::ostringstream text;
  text << std::setprecision(3) << 100.0 * share << " %";
  return text.str();
}

}  // namespace

template <class Real>
Forces<Real>::Forces(const Scene& scene, const Model<Real>& model, Accumulation accumulation)
    : springs_(model.springs),
      slots_(std::get_if<Slots<Real>>(&model.spring_layout)),
      list_(std::get_if<SpringList<Real>>(&model.spring_layout)),
      adds_(accumulation == Accumulation::atomic ? Adds::atomic : Adds::plain),
      sums_(list_ != nullptr ? model.particles() : 0) {
  const EffectContext context{scene, model.order};
  for (const Effect& effect : scene.effects) {
    std::visit([&](const auto& data) { effects_.push_back(compile_effect<Real>(data, context)); }, effect);
  }
}

template <class Real>
bool Forces<Real>::calls_user() const {
  return std::any_of(effects_.begin(), effects_.end(),
                     [](const auto& effect) { return effect->calls_user(); });
}

template <class Real>
void Forces<Real>::scatter(const State<Real>& state, Executor& executor) {
  for (std::size_t batch = 0; batch < list_->batches(); ++batch) {
    const std::size_t first = list_->batch_begin[batch], count = list_->batch_begin[batch + 1] - first;
    const auto run = [&](std::size_t begin, std::size_t end) {
      scatter_springs(*list_, first + begin, first + end, state, adds_, sums_);
    };
    const bool serial = list_->last_batch_serial && batch + 1 == list_->batches();
    if (serial) {
      run(0, count);
    } else {
      executor.parallel_for(count, spring_grain, run);
    }
  }
}

template <class Real>
void Forces<Real>::clear() {
  for (AlignedVector<Real>* sums : {&sums_.x, &sums_.y, &sums_.z})
    std::fill(sums->begin(), sums->end(), Real(0));
}

template <class Real>
SpringMeasure Forces<Real>::measure_springs(const State<Real>& state, Executor& executor) const {
  if (slots_ != nullptr) {
    return sum_in_order<SpringMeasure>(executor, block_count(state.size()), block_run,
                                       [&](std::size_t begin, std::size_t end) {
                                         SpringMeasure sum;
                                         for (std::size_t b = begin; b < end; ++b)
                                           sum.add(measure_gathered(*slots_, state, b));
                                         return sum;
                                       });
  }
  if (list_ == nullptr) return {};
  return sum_in_order<SpringMeasure>(
      executor, list_->size(), spring_grain,
      [&](std::size_t begin, std::size_t end) { return measure_listed(*list_, begin, end, state); });
}

template <class Real>
double Forces<Real>::effect_energy(const Strip<Real>& strip) const {
  double sum = 0.0;
  for (const StripEffectPointer<Real>& effect : effects_) sum += effect->energy(strip);
  return sum;
}

template <class Real>
Stage Forces<Real>::spring_stage() const {
  std::vector<std::string> reads = {"position"};
  const bool damped = slots_ != nullptr ? slots_->damped : !list_->damping.empty();
  if (damped) reads.push_back("velocity");
  if (slots_ != nullptr) return {"springs (gather)", "", std::move(reads), {"force"}, slots_->bytes()};
  const std::string name = adds_ == Adds::atomic ? "springs (atomic)" : "springs (coloured)";
  return {name, "", std::move(reads), {"force"}, list_->bytes() + sums_.bytes()};
}

template <class Real>
std::string Forces<Real>::spring_layout() const {
  if (slots_ != nullptr) {
    const SlotCount count = count_slots(*slots_, springs_);
    return std::to_string(count.slots) + " slots of 16, " + percent(count.shift_share()) +
           " of them shifts, " + percent(count.empty_share()) + " of the lanes empty";
  }
  if (list_ == nullptr) return "";
  if (adds_ == Adds::atomic) return "one list";
  return std::to_string(list_->batches()) + " colours" +
         (list_->last_batch_serial ? ", the last on one thread" : "");
}

template <class Real>
std::vector<Stage> Forces<Real>::strip_stages() const {
  std::vector<Stage> stages;
  if (slots_ != nullptr) stages.push_back(spring_stage());
  for (const StripEffectPointer<Real>& effect : effects_) {
    stages.push_back(effect->stage());
    stages.back().writes = {"force"};
  }
  return stages;
}

template class Forces<float>;
template class Forces<double>;

}  // namespace hooke
