#include "solve/vertex_sweeps.h"

#include <algorithm>

namespace hooke {
namespace {

/// Blocks of particles copied by one thread at a time.
constexpr std::size_t copied_blocks = 256;

/// Strips that one thread takes at a time: some microseconds of work.
constexpr std::size_t strips_at_once = 4;

/// Calls visit(begin, end) for strips of the blocks in which the particles [first, last) are; what they share
/// with others is a strip of its own.
template <class Visit>
void for_each_part(std::size_t first, std::size_t last, const Visit& visit) {
  const std::size_t begin = first / block_size, end = block_count(last);
  const std::size_t whole_begin = block_count(first), whole_end = last / block_size;
  if (whole_begin >= whole_end) {
    for_each_strip(begin, end, visit);
    return;
  }
  if (begin < whole_begin) visit(begin, whole_begin);
  for_each_strip(whole_begin, whole_end, visit);
  if (whole_end < end) visit(whole_end, end);
}

template <class Real>
const Model<Real>& with_motions_of(const Model<Real>& other, Model<Real>& model) {
  if (model.frames != nullptr) model.frames->share_motions_of(*other.frames);
  return model;
}

}  // namespace

template <class Real>
VertexSweeps<Real>::VertexSweeps(const SolverContext<Real>& context)
    : VertexSweeps(context, Adjacency(context.scene.springs, context.model.particles())) {}

template <class Real>
VertexSweeps<Real>::VertexSweeps(const SolverContext<Real>& context, const Adjacency& adjacency)
    : VertexSweeps(context, adjacency,
                   colour_vertices(context.scene.springs, adjacency, context.model.order)) {}

template <class Real>
VertexSweeps<Real>::VertexSweeps(const SolverContext<Real>& context, const Adjacency& adjacency,
                                 VertexColours colours)
    : executor_(context.executor),
      model_(context.scene, adjacency, std::move(colours.order), Accumulation::gather, context.executor,
             context.model.holds_like_pins, context.model.meshes),
      forces_(context.scene, with_motions_of(context.model, model_)),
      coupled_(model_, forces_),
      from_(model_.particles()),
      now_(model_.particles(), packed_for(model_)) {
  model_.share_islands(context.model);
  now_.memory = forces_.effects().initial_memory();
  now_.pairs.resize(forces_.effects().pair_lists());
  cut_into_strips(colours.begin);
  engine_.reserve(model_.particles());
  for (std::size_t i = 0; i < model_.particles(); ++i)
    engine_.push_back(context.model.order.engine(model_.order.user(i)));
}

template <class Real>
void VertexSweeps<Real>::cut_into_strips(const std::vector<std::size_t>& colour_begin) {
  for (std::size_t c = 0; c + 1 < colour_begin.size(); ++c) {
    const std::size_t first = colour_begin[c], last = colour_begin[c + 1], first_strip = strips_.size();
    for_each_part(first, last, [&](std::size_t begin, std::size_t end) {
      strips_.push_back({begin, end, std::max(first, begin * block_size), std::min(last, end * block_size)});
    });
    const auto together =
        std::stable_partition(strips_.begin() + std::ptrdiff_t(first_strip), strips_.end(),
                              [&](const VertexStrip& strip) { return !overlaps(strip, first, last); });
    colours_.push_back({first_strip, std::size_t(together - strips_.begin()), strips_.size()});
  }
  changes_.resize(strips_.size());
}

/// Whether vectors that are loaded for a strip reach particles of [first, last) that are not in it.
template <class Real>
bool VertexSweeps<Real>::overlaps(const VertexStrip& strip, std::size_t first, std::size_t last) const {
  const Slots<Real>* const slots = slots_of(model_);
  const auto reaches = [&](std::int64_t begin, std::size_t count) {
    return begin < std::int64_t(last) && begin + std::int64_t(count) > std::int64_t(first);
  };
  for (std::size_t block = strip.begin; slots != nullptr && block < strip.end; ++block) {
    const auto& list = slots->list(block);
    const std::size_t own = block * block_size;
    for (std::uint32_t s = list.first_shift; s < list.first_indexed; ++s) {
      if (reaches(std::int64_t(own) + slots->slots[s].shift, block_size)) return true;
    }
    for (std::uint32_t s = list.first_indexed; s < list.end; ++s) {
      for (std::size_t lane = 0; lane < block_size; ++lane) {
        const std::size_t other = slots->neighbour(block, slots->slots[s], lane);
        if (other != own + lane && reaches(std::int64_t(other), 1)) return true;
      }
    }
  }
  return false;
}

template <class Real>
bool VertexSweeps<Real>::follow_islands() {
  if (!model_.follow_islands()) return false;
  awake_.choose(strips_.size(),
                [&](std::size_t s) { return model_.awake.any(strips_[s].begin, strips_[s].end); });
  std::fill(changes_.begin(), changes_.end(), 0.0);
  return true;
}

/// visit(first, last) for runs of particles in blocks that are awake.
template <class Real>
template <class Visit>
void VertexSweeps<Real>::for_each_awake(const Visit& visit) const {
  executor_.parallel_for(block_count(engine_.size()), copied_blocks, [&](std::size_t begin, std::size_t end) {
    model_.for_each_awake_run(begin, end, [&](std::size_t first, std::size_t last) {
      visit(first * block_size, std::min(last * block_size, engine_.size()));
    });
  });
}

template <class Real>
void VertexSweeps<Real>::load(const ImplicitStage<Real>& stage, const State<Real>& guess) {
  h_ = Real(stage.h);
  time_ = stage.time;
  now_.memory = stage.from.memory;
  now_.pairs = stage.from.pairs;
  if (model_.frames != nullptr) forces_.effects().frames_changed();  // the host may have moved some
  const auto load_run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index e = engine_[i];
      from_.set_position(i, stage.from.position(e));
      from_.set_velocity(i, stage.from.velocity(e));
      now_.set_position(i, guess.position(e));
      now_.set_velocity(i, guess.velocity(e));
    }
  };
  // What sleeps is where it is felt from now on, too.
  if (follow_islands()) load_run(0, engine_.size());
  for_each_awake(load_run);
}

template <class Real>
double VertexSweeps<Real>::sweep(Real least_across) {
  const VertexEquations<Real> equations{slots_of(model_), model_.inverse_mass, from_, h_, least_across};
  if (coupled_.any()) coupled_.take(now_, time_, {h_ * h_, h_}, executor_);
  const auto solve = [&](std::size_t first, std::size_t last) {
    awake_.for_each_run(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) changes_[s] = solve_awake(equations, strips_[s]);
    });
  };
  for (const Colour& colour : colours_) {
    executor_.parallel_for(
        colour.together - colour.first, strips_at_once,
        [&](std::size_t begin, std::size_t end) { solve(colour.first + begin, colour.first + end); });
    solve(colour.together, colour.last);
  }
  double sum = 0.0;
  for (const double change : changes_) sum += change;
  return sum;
}

template <class Real>
double VertexSweeps<Real>::solve_awake(const VertexEquations<Real>& equations, const VertexStrip& strip) {
  double change = 0.0;
  model_.awake.for_each_run(strip.begin, strip.end, [&](std::size_t begin, std::size_t end) {
    change += solve_strip(equations, {begin, end, std::max(strip.first, begin * block_size),
                                      std::min(strip.last, end * block_size)});
  });
  return change;
}

template <class Real>
double VertexSweeps<Real>::solve_strip(const VertexEquations<Real>& equations, const VertexStrip& strip) {
  const Strip<Real> particles(now_, strip.begin, strip.end);
  StripForce<Real> force{};
  StripBlocks<Real> blocks{};
  forces_.effects().add_uncoupled_forces(particles, time_, force);
  forces_.effects().add_uncoupled_derivatives(particles, time_, {h_ * h_, h_}, blocks);
  coupled_.add(strip.begin, strip.end, force, blocks);
  return solve_vertices(equations, strip, force, blocks, now_);
}

template <class Real>
void VertexSweeps<Real>::store(State<Real>& next) const {
  for_each_awake([&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      next.set_position(engine_[i], now_.position(i));
      next.set_velocity(engine_[i], now_.velocity(i));
    }
  });
}

template <class Real>
std::size_t VertexSweeps<Real>::bytes() const {
  const Slots<Real>* const slots = slots_of(model_);
  return model_.order.bytes() + model_.inverse_mass.bytes() + (slots == nullptr ? 0 : slots->bytes()) +
         coupled_.bytes() + engine_.capacity() * sizeof(Index) + strips_.capacity() * sizeof(VertexStrip) +
         colours_.capacity() * sizeof(Colour) + changes_.capacity() * sizeof(double) + from_.bytes() +
         now_.bytes();
}

template class VertexSweeps<float>;
template class VertexSweeps<double>;

}  // namespace hooke
