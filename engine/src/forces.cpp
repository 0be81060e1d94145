#include "forces.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "parallel/sum.h"

namespace hooke {
namespace {

/// Blocks whose springs one thread takes at a time: long enough to hide the cost of handing them out.
constexpr std::size_t scattered_blocks = 128;

std::string percent(double share) {
  std::ostringstream text;
  text << std::setprecision(3) << 100.0 * share << " %";
  return text.str();
}

}  // namespace

template <class Real>
Forces<Real>::Forces(const Scene& scene, const Model<Real>& model)
    : model_(model),
      springs_(model.linear_springs),
      slots_(slots_of(model)),
      batches_(std::get_if<SpringBatches<Real>>(&model.spring_layout)),
      sums_(batches_ != nullptr ? model.particles() : 0, batches_ != nullptr && slots_->any_indexed()),
      effects_(scene, model) {}

template <class Real>
void Forces<Real>::prepare(const State<Real>& state, double time, Executor& executor) {
  if (scatters()) scatter(state, executor);
  effects_.prepare(state, time, executor);
}

template <class Real>
void Forces<Real>::scatter(const State<Real>& state, Executor& executor) {
  const std::size_t grain = std::max<std::size_t>(1, scattered_blocks / batches_->batch_blocks);
  // One thread shares nothing.
  const bool atomic = !batches_->shared.empty() && executor.threads() > 1;
  const std::uint8_t* const shared = atomic ? batches_->shared.data() : nullptr;
  for (std::size_t colour = 0; colour < batches_->colours(); ++colour) {
    const std::uint32_t* const batches = batches_->batches.data() + batches_->colour_begin[colour];
    const std::size_t count = batches_->colour_begin[colour + 1] - batches_->colour_begin[colour];
    executor.parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        const std::size_t first = batches_->begin(batches[b]), last = batches_->end(batches[b]);
        if (model_.awake.any(first, last)) scatter_springs(*slots_, state, first, last, shared, sums_);
      }
    });
  }
}

template <class Real>
SpringMeasure Forces<Real>::measure_springs(const State<Real>& state, Executor& executor) const {
  if (slots_ == nullptr) return {};
  return sum_in_order<SpringMeasure>(executor, block_count(state.size()), block_run,
                                     [&](std::size_t begin, std::size_t end) {
                                       SpringMeasure sum;
                                       for (std::size_t b = begin; b < end; ++b)
                                         sum.add(measure_gathered(*slots_, state, b));
                                       return sum;
                                     });
}

template <class Real>
Stage Forces<Real>::spring_stage() const {
  std::vector<std::string> reads = {"position"};
  if (slots_->damped) reads.push_back("velocity");
  if (batches_ == nullptr) return {"springs (gather)", "", std::move(reads), {"force"}, slots_->bytes()};
  const std::string name = batches_->shared.empty() ? "springs (coloured)" : "springs (atomic)";
  return {name, "", std::move(reads), {"force"}, batches_->bytes() + sums_.bytes()};
}

template <class Real>
std::string Forces<Real>::spring_layout() const {
  if (slots_ == nullptr) return "";
  const SlotCount count = count_slots(*slots_, springs_);
  const std::string slots = std::to_string(count.slots) + " slots of 16, " + percent(count.shift_share()) +
                            " of them shifts, " + percent(count.empty_share()) + " of the lanes empty";
  if (batches_ == nullptr) return slots;
  const std::string batches = std::to_string(batches_->batches.size()) + " batches, ";
  if (batches_->shared.empty()) return std::to_string(batches_->colours()) + " colours of " + batches + slots;
  const auto shared = double(std::count(batches_->shared.begin(), batches_->shared.end(), 1));
  return batches + percent(shared / double(batches_->shared.size())) + " of the blocks shared, " + slots;
}

template <class Real>
std::vector<Stage> Forces<Real>::preparation_stages() const {
  std::vector<Stage> stages = effects_.preparation_stages();
  if (scatters()) stages.insert(stages.begin(), spring_stage());
  return stages;
}

template <class Real>
std::vector<Stage> Forces<Real>::strip_stages() const {
  std::vector<Stage> stages;
  if (slots_ != nullptr && batches_ == nullptr) stages.push_back(spring_stage());
  for (Stage& stage : effects_.strip_stages()) stages.push_back(std::move(stage));
  return stages;
}

template class Forces<float>;
template class Forces<double>;

}  // namespace hooke
