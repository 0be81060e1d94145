#include "solve/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernels/flush_subnormals.h"
#include "kernels/gather_derivative.h"
#include "parallel/sum.h"
#include "solve/lane_sums.h"
#include "solve/packed_copies.h"
#include "solve/particle_blocks.h"

namespace hooke {
namespace {

/// The share of the first residual that is left when a direction is found well enough: the square of the
/// progress that the last direction made, and little where the end is near, as rounding errors, of the
/// highest frequencies, may be most of the residual there.
class Forcing {
 public:
  void begin() { *this = {}; }

  void note_change(double tolerances) { far_ = tolerances > 2.0; }

  double share(double norm) {
    constexpr double least = 1e-8;
    const double most = far_ ? 0.1 : 0.01;
    const double progress = last_norm_ > 0.0 ? norm / last_norm_ : 1.0;
    last_norm_ = norm;
    return std::clamp(progress * progress, least, most);
  }

 private:
  double last_norm_ = 0.0;
  bool far_ = false;
};

/// product += block p for each of a block's particles.
template <class Real>
void add_block_product(const typename ParticleBlocks<Real>::Block& m, const Real* px, const Real* py,
                       const Real* pz, Real* x, Real* y, Real* z) {
  for (std::size_t i = 0; i < block_size; ++i) {
    x[i] += m.xx[i] * px[i] + m.xy[i] * py[i] + m.xz[i] * pz[i];
    y[i] += m.xy[i] * px[i] + m.yy[i] * py[i] + m.yz[i] * pz[i];
    z[i] += m.xz[i] * px[i] + m.yz[i] * py[i] + m.zz[i] * pz[i];
  }
}

template <class Real>
class ConjugateGradients final : public DirectionSolver<Real> {
 public:
  explicit ConjugateGradients(const SolverContext<Real>& context)
      : model_(context.model),
        forces_(context.forces),
        executor_(context.executor),
        slots_(slots_of(context.model)),
        mass_(context.model.particles(),
              [&](std::size_t i) {
                return context.model.pinned(i) ? Real(0) : Real(1) / context.model.inverse_mass[i];
              }),
        search_(context.model.particles(),
                slots_ != nullptr && slots_->any_indexed() ? Packed::positions_and_velocities : Packed::none),
        product_(context.model.particles()),
        residual_(context.model.particles()),
        preconditioned_(context.model.particles()),
        inverse_(context.model.particles()) {
    search_.memory = forces_.effects().initial_memory();
    if (forces_.effects().has_uncoupled_derivatives()) of_effects_.emplace(context.model.particles());
  }

  void begin() override { forcing_.begin(); }

  void note_change(double tolerances) override { forcing_.note_change(tolerances); }

  typename DirectionSolver<Real>::Result solve(const ImplicitStage<Real>& stage, const State<Real>& at,
                                               const ParticleVectors<Real>& residual,
                                               ParticleVectors<Real>& direction) override {
    weights_ = {Real(stage.h * stage.h), Real(stage.h)};
    double square = start(at, stage.time, residual, direction);
    const double share = forcing_.share(std::sqrt(square)), enough = share * share * square;
    const std::uint64_t most = most_iterations();
    typename DirectionSolver<Real>::Result result;
    while (square > enough && result.iterations < most) {
      ++result.iterations;
      const double curvature = multiply();
      if (!(curvature > 0.0 && std::isfinite(curvature))) break;
      const double next_square = advance(Real(square / curvature), direction);
      turn(Real(next_square / square));
      square = next_square;
    }
    return result;
  }

  std::size_t bytes() const override {
    return mass_.bytes() + search_.bytes() + product_.bytes() + residual_.bytes() + preconditioned_.bytes() +
           inverse_.bytes() + (of_effects_ ? of_effects_->bytes() : 0);
  }

 private:
  /// In exact arithmetic there are as many as unknowns.
  std::uint64_t most_iterations() const {
    constexpr std::uint64_t least = 20, most = 20000;
    return std::clamp<std::uint64_t>(6 * search_.size(), least, most);
  }

  template <class Part>
  double sum(const Part& part) {
    const auto part_of_strips = [&](std::size_t begin, std::size_t end) {
      const FlushSubnormals flush;
      LaneSums sums;
      model_.for_each_awake_strip(begin, end,
                                  [&](std::size_t first, std::size_t last) { part(first, last, sums); });
      return DotSum{sums.total()};
    };
    return sum_in_order<DotSum>(executor_, block_count(search_.size()), solved_blocks, part_of_strips, sums_)
        .value;
  }

  /// Linearises the forces, and begins with direction zero. Returns the preconditioned square of the
  /// residual.
  double start(const State<Real>& at, double time, const ParticleVectors<Real>& residual,
               ParticleVectors<Real>& direction) {
    direction.set_zero();
    residual_ = residual;
    copy_positions(at);
    sum([&](std::size_t begin, std::size_t end, LaneSums&) {
      linearise(Strip<Real>(at, begin, end), time, begin, end);
    });
    const double square =
        sum([&](std::size_t begin, std::size_t end, LaneSums& sums) { precondition(begin, end, sums); });
    std::fill(search_.vx(), search_.vx() + search_.size(), Real(0));
    std::fill(search_.vy(), search_.vy() + search_.size(), Real(0));
    std::fill(search_.vz(), search_.vz() + search_.size(), Real(0));
    turn(Real(0));
    return square;
  }

  void copy_positions(const State<Real>& at) {
    const std::size_t count = at.size();
    std::copy(at.x(), at.x() + count, search_.x());
    std::copy(at.y(), at.y() + count, search_.y());
    std::copy(at.z(), at.z() + count, search_.z());
    if (search_.packed_positions() != nullptr) {
      std::copy(at.packed_positions(), at.packed_positions() + count * packed_width,
                search_.packed_positions());
    }
    search_.memory = at.memory;
  }

  /// Finds the blocks of the effects, and the inverses of all of A's.
  void linearise(const Strip<Real>& strip, double time, std::size_t begin, std::size_t end) {
    StripBlocks<Real> springs{}, effects{};
    if (slots_ != nullptr)
      gather_diagonal(*slots_, search_, begin, end, weights_, PressedSprings::no_push, springs);
    forces_.effects().add_coupled_derivatives(strip, time, weights_, springs);
    if (of_effects_) forces_.effects().add_uncoupled_derivatives(strip, time, weights_, effects);
    for (std::size_t block = begin; block < end; ++block) {
      const Real* const mass = mass_.block(block);
      const Real* const inverse_mass = model_.inverse_mass.block(block);
      for (std::size_t i = 0; i < block_size; ++i) {
        const std::size_t lane = (block - begin) * block_size + i;
        const Symmetric3<Real> own{effects.xx[lane], effects.xy[lane], effects.xz[lane],
                                   effects.yy[lane], effects.yz[lane], effects.zz[lane]};
        const Symmetric3<Real> all{mass[i] + springs.xx[lane] + own.xx, springs.xy[lane] + own.xy,
                                   springs.xz[lane] + own.xz,           mass[i] + springs.yy[lane] + own.yy,
                                   springs.yz[lane] + own.yz,           mass[i] + springs.zz[lane] + own.zz};
        if (of_effects_) (*of_effects_)[block].set_lane(i, own);
        inverse_[block].set_lane(i, inverse_mass[i] > Real(0) ? all.inverse() : Symmetric3<Real>{});
      }
    }
  }

  /// product = A p; returns p . A p.
  double multiply() {
    const EffectList<Real>& effects = forces_.effects();
    forces_.effects().prepare_products(search_, executor_);
    return sum([&](std::size_t begin, std::size_t end, LaneSums& sums) {
      StripForce<Real> product{};
      if (slots_ != nullptr)
        gather_product(*slots_, search_, begin, end, weights_, PressedSprings::no_push, product);
      if (effects.coupled())
        effects.add_products(Strip<Real>(search_, begin, end), weights_, Curvature::convex, product);
      for (std::size_t block = begin; block < end; ++block) {
        const std::size_t place = block * block_size, lane = (block - begin) * block_size;
        const Real *px = search_.vx() + place, *py = search_.vy() + place, *pz = search_.vz() + place;
        Real *x = product.x + lane, *y = product.y + lane, *z = product.z + lane;
        const Real* const mass = mass_.block(block);
        for (std::size_t i = 0; i < block_size; ++i) {
          x[i] += mass[i] * px[i];
          y[i] += mass[i] * py[i];
          z[i] += mass[i] * pz[i];
        }
        if (of_effects_) add_block_product<Real>((*of_effects_)[block], px, py, pz, x, y, z);
        std::copy(x, x + block_size, product_.x() + place);
        std::copy(y, y + block_size, product_.y() + place);
        std::copy(z, z + block_size, product_.z() + place);
        sums.add_products(x, px, block_size);
        sums.add_products(y, py, block_size);
        sums.add_products(z, pz, block_size);
      }
    });
  }

  /// Goes `length` along p; returns the preconditioned square of the residual that is left.
  double advance(Real length, ParticleVectors<Real>& direction) {
    return sum([&](std::size_t begin, std::size_t end, LaneSums& sums) {
      const std::size_t first = begin * block_size, last = end * block_size;
      const auto along = [&](Real* x, const Real* p, Real* r, const Real* q) {
        for (std::size_t i = first; i < last; ++i) {
          x[i] += length * p[i];
          r[i] -= length * q[i];
        }
      };
      along(direction.x(), search_.vx(), residual_.x(), product_.x());
      along(direction.y(), search_.vy(), residual_.y(), product_.y());
      along(direction.z(), search_.vz(), residual_.z(), product_.z());
      precondition(begin, end, sums);
    });
  }

  /// z = the preconditioned residual; adds r . z.
  void precondition(std::size_t begin, std::size_t end, LaneSums& sums) {
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t place = block * block_size;
      const Real *rx = residual_.x() + place, *ry = residual_.y() + place, *rz = residual_.z() + place;
      Real *x = preconditioned_.x() + place, *y = preconditioned_.y() + place,
           *z = preconditioned_.z() + place;
      std::fill(x, x + block_size, Real(0));
      std::fill(y, y + block_size, Real(0));
      std::fill(z, z + block_size, Real(0));
      add_block_product<Real>(inverse_[block], rx, ry, rz, x, y, z);
      sums.add_products(x, rx, block_size);
      sums.add_products(y, ry, block_size);
      sums.add_products(z, rz, block_size);
    }
  }

  /// p = z + share p.
  void turn(Real share) {
    executor_.parallel_for(block_count(search_.size()), solved_blocks,
                           [&](std::size_t begin, std::size_t end) {
                             const FlushSubnormals flush;
                             model_.for_each_awake_run(begin, end, [&](std::size_t first, std::size_t last) {
                               turn_lanes(share, first * block_size, last * block_size);
                             });
                           });
  }

  void turn_lanes(Real share, std::size_t first, std::size_t last) {
    const auto turn_one = [&](Real* p, const Real* z) {
      for (std::size_t i = first; i < last; ++i) p[i] = z[i] + share * p[i];
    };
    turn_one(search_.vx(), preconditioned_.x());
    turn_one(search_.vy(), preconditioned_.y());
    turn_one(search_.vz(), preconditioned_.z());
    if (Real* const packed = search_.packed_velocities(); packed != nullptr)
      pack<Real>(search_.vx(), search_.vy(), search_.vz(), first, last, packed);
  }

  const Model<Real>& model_;
  Forces<Real>& forces_;
  Executor& executor_;
  const Slots<Real>* slots_;  // null where there are no springs
  BlockRows<Real> mass_;      // [kg]; 0 where pinned, and in the padding
  State<Real> search_;        // positions where forces are linearised, and p in place of velocities
  ParticleVectors<Real> product_, residual_, preconditioned_;
  ParticleBlocks<Real> inverse_;
  std::optional<ParticleBlocks<Real>> of_effects_;
  DerivativeWeights<Real> weights_{};
  Forcing forcing_;
  std::vector<DotSum> sums_;
};

}  // namespace

template <class Real>
std::unique_ptr<DirectionSolver<Real>> make_conjugate_gradients(const SolverContext<Real>& context) {
  return std::make_unique<ConjugateGradients<Real>>(context);
}

template std::unique_ptr<DirectionSolver<float>> make_conjugate_gradients(const SolverContext<float>&);
template std::unique_ptr<DirectionSolver<double>> make_conjugate_gradients(const SolverContext<double>&);

}  // namespace hooke
