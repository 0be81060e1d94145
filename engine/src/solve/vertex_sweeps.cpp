#include "solve/vertex_sweeps.h"

namespace hooke {
namespace {

/// Particles copied by one thread at a time.
constexpr std::size_t copied_particles = 4096;

/// Strips that one thread takes at a time: some microseconds of work.
constexpr std::size_t strips_at_once = 4;

/// Each colour's particles cut into strips. Colours may begin and end inside a block.
std::vector<VertexStrip> cut_into_strips(const std::vector<std::size_t>& colour_begin,
                                         std::vector<std::size_t>& strips_begin) {
  std::vector<VertexStrip> strips;
  for (std::size_t colour = 0; colour + 1 < colour_begin.size(); ++colour) {
    strips_begin.push_back(strips.size());
    const std::size_t first = colour_begin[colour], last = colour_begin[colour + 1];
    if (first == last) continue;
    for_each_strip(first / block_size, block_count(last), [&](std::size_t begin, std::size_t end) {
      strips.push_back({begin, end, std::max(first, begin * block_size), std::min(last, end * block_size)});
    });
  }
  strips_begin.push_back(strips.size());
  return strips;
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
      model_(context.scene, adjacency, std::move(colours.order), Accumulation::gather, context.executor),
      forces_(context.scene, model_),
      strips_(cut_into_strips(colours.begin, colour_begin_)),
      changes_(strips_.size()),
      from_(model_.particles()),
      now_(model_.particles(), packed_for(model_)) {
  engine_.reserve(model_.particles());
  for (std::size_t i = 0; i < model_.particles(); ++i)
    engine_.push_back(context.model.order.engine(model_.order.user(i)));
}

template <class Real>
void VertexSweeps<Real>::load(const ImplicitStage<Real>& stage, const State<Real>& guess) {
  h_ = Real(stage.h);
  time_ = stage.time;
  executor_.parallel_for(engine_.size(), copied_particles, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index e = engine_[i];
      from_.set_position(i, stage.from.position(e));
      from_.set_velocity(i, stage.from.velocity(e));
      now_.set_position(i, guess.position(e));
      now_.set_velocity(i, guess.velocity(e));
    }
  });
}

template <class Real>
double VertexSweeps<Real>::sweep(Real least_across) {
  const VertexEquations<Real> equations{slots_of(model_), model_.inverse_mass, from_, h_, least_across};
  for (std::size_t colour = 0; colour < colours(); ++colour) {
    const std::size_t first = colour_begin_[colour];
    executor_.parallel_for(colour_begin_[colour + 1] - first, strips_at_once,
                           [&](std::size_t begin, std::size_t end) {
                             for (std::size_t s = first + begin; s < first + end; ++s)
                               changes_[s] = solve_strip(equations, strips_[s]);
                           });
  }
  double sum = 0.0;
  for (const double change : changes_) sum += change;
  return sum;
}

template <class Real>
double VertexSweeps<Real>::solve_strip(const VertexEquations<Real>& equations, const VertexStrip& strip) {
  const Strip<Real> particles(now_, strip.begin, strip.end);
  StripForce<Real> force{};
  StripBlocks<Real> blocks{};
  forces_.add_effects(particles, time_, force);
  forces_.add_effect_derivatives(particles, {h_ * h_, h_}, blocks);
  return solve_vertices(equations, strip, force, blocks, now_);
}

template <class Real>
void VertexSweeps<Real>::store(State<Real>& next) const {
  executor_.parallel_for(engine_.size(), copied_particles, [&](std::size_t begin, std::size_t end) {
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
         engine_.capacity() * sizeof(Index) + strips_.capacity() * sizeof(VertexStrip) +
         colour_begin_.capacity() * sizeof(std::size_t) + changes_.capacity() * sizeof(double) +
         from_.bytes() + now_.bytes();
}

template class VertexSweeps<float>;
template class VertexSweeps<double>;

}  // namespace hooke
