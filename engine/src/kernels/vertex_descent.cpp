#include "kernels/vertex_descent.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/vertex_descent.cpp"
#include <hwy/foreach_target.h>

#include "kernels/flush_subnormals.h"
#include "kernels/slot_reader-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

template <class V>
struct Symmetric3 {
  V xx, xy, xz, yy, yz, zz;
};

/// Sums over the springs of a particle: their force, and h^2 K + h C as across I + along.
template <class V>
struct SpringSums {
  Vector3<V> force;
  V across;
  Symmetric3<V> along;
};

template <class V>
struct Weights {
  V of_stiffness, of_damping, least_across;  ///< h^2, h
};

/// With r = 2 / l and u = r d: k l0 / l = half_pull r, and C = c d d^T / l^2 = quarter_damping u u^T. Of ends
/// at one place nothing is known but that they do not pull, so they do not hold each other either; lanes
/// without a spring are such.
template <bool damped, class D, class Ends, class V = hn::Vec<D>>
HWY_INLINE void add_spring(D d, const Ends& own, const Ends& other, const SpringRows<V>& rows,
                           const Weights<V>& weights, SpringSums<V>& sums) {
  using Real = hn::TFromD<D>;
  const Vector3<V> apart = own.position - other.position;
  const V tiny = hn::Set(d, std::numeric_limits<Real>::min());
  const V square =
      hn::MulAdd(apart.x, apart.x, hn::MulAdd(apart.y, apart.y, hn::MulAdd(apart.z, apart.z, tiny)));
  const TwiceReciprocalRoot<V> root = twice_reciprocal_root(d, square);
  const V twice_inverse = hn::Mul(root.estimate, root.correction);
  const V pull = hn::NegMulAdd(rows.half_pull, twice_inverse, rows.stiffness);
  const V held = hn::Max(pull, hn::Mul(weights.least_across, rows.stiffness));
  const V across = hn::IfThenElseZero(hn::Gt(square, tiny), held);
  V along = hn::Mul(hn::Mul(hn::Set(d, Real(0.25)), weights.of_stiffness), hn::Sub(rows.stiffness, across));
  V factor = pull;
  if constexpr (damped) {
    along = hn::MulAdd(weights.of_damping, rows.quarter_damping, along);
    const V speed = hn::Mul(dot(own.velocity - other.velocity, apart), twice_inverse);
    factor = hn::MulAdd(hn::Mul(rows.quarter_damping, speed), twice_inverse, factor);
  }
  const Vector3<V> u = {hn::Mul(apart.x, twice_inverse), hn::Mul(apart.y, twice_inverse),
                        hn::Mul(apart.z, twice_inverse)};
  const V x = hn::Mul(along, u.x), y = hn::Mul(along, u.y), z = hn::Mul(along, u.z);
  sums.force = {hn::NegMulAdd(factor, apart.x, sums.force.x), hn::NegMulAdd(factor, apart.y, sums.force.y),
                hn::NegMulAdd(factor, apart.z, sums.force.z)};
  sums.across = hn::Add(sums.across, across);
  Symmetric3<V>& s = sums.along;
  s = {hn::MulAdd(x, u.x, s.xx), hn::MulAdd(x, u.y, s.xy), hn::MulAdd(x, u.z, s.xz),
       hn::MulAdd(y, u.y, s.yy), hn::MulAdd(y, u.z, s.yz), hn::MulAdd(z, u.z, s.zz)};
}

/// Solves a x = r for a = I + something positive, as L D L^T: no element of D is less than 1 but by rounding.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> solve3(D d, const Symmetric3<V>& a, const Vector3<V>& r) {
  const V one = hn::Set(d, hn::TFromD<D>(1));
  const V inverse_x = hn::Div(one, a.xx);
  const V yx = hn::Mul(a.xy, inverse_x), zx = hn::Mul(a.xz, inverse_x);
  const V inverse_y = hn::Div(one, hn::Max(hn::NegMulAdd(yx, a.xy, a.yy), one));
  const V rest_yz = hn::NegMulAdd(yx, a.xz, a.yz);
  const V zy = hn::Mul(rest_yz, inverse_y);
  const V rest_zz = hn::NegMulAdd(zy, rest_yz, hn::NegMulAdd(zx, a.xz, a.zz));
  const V y = hn::NegMulAdd(yx, r.x, r.y);
  const V z = hn::NegMulAdd(zy, y, hn::NegMulAdd(zx, r.x, r.z));
  const V solved_z = hn::Div(z, hn::Max(rest_zz, one));
  const V solved_y = hn::NegMulAdd(zy, solved_z, hn::Mul(y, inverse_y));
  const V solved_x = hn::NegMulAdd(yx, solved_y, hn::NegMulAdd(zx, solved_z, hn::Mul(r.x, inverse_x)));
  return {solved_x, solved_y, solved_z};
}

/// Writes vectors to the state, lane by lane where not all of them are the strip's.
template <class Real>
class StripWriter {
 public:
  using D = hn::CappedTag<Real, block_size>;
  using V = hn::Vec<D>;

  StripWriter(const VertexStrip& strip, State<Real>& state) : strip_(strip), state_(state) {}

  HWY_INLINE bool whole(std::size_t first) const {
    return first >= strip_.first && first + hn::Lanes(D()) <= strip_.last;
  }

  HWY_INLINE void write(std::size_t first, const Vector3<V>& position, const Vector3<V>& velocity) const {
    const D d;
    if (whole(first)) {
      store(d, position, state_.x() + first, state_.y() + first, state_.z() + first);
      store(d, velocity, state_.vx() + first, state_.vy() + first, state_.vz() + first);
      pack(d, position, first, state_.packed_positions());
      pack(d, velocity, first, state_.packed_velocities());
      return;
    }
    HWY_ALIGN Real x[6][hn::MaxLanes(D())];
    store(d, position, x[0], x[1], x[2]);
    store(d, velocity, x[3], x[4], x[5]);
    const std::size_t begin = std::max(first, strip_.first);
    const std::size_t end = std::min(first + hn::Lanes(d), strip_.last);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t lane = i - first;
      state_.set_position(i, {x[0][lane], x[1][lane], x[2][lane]});
      state_.set_velocity(i, {x[3][lane], x[4][lane], x[5][lane]});
    }
  }

 private:
  HWY_INLINE static void store(D d, const Vector3<V>& values, Real* x, Real* y, Real* z) {
    hn::Store(values.x, d, x);
    hn::Store(values.y, d, y);
    hn::Store(values.z, d, z);
  }

  HWY_INLINE static void pack(D d, const Vector3<V>& values, std::size_t first, Real* packed) {
    if (packed != nullptr) store_packed(d, values.x, values.y, values.z, packed + first * packed_width);
  }

  const VertexStrip& strip_;
  State<Real>& state_;
};

/// Solves vectors of particles one by one, once the sums over their springs are known.
template <class Real>
class VertexSolver {
 public:
  using D = hn::CappedTag<Real, block_size>;
  using V = hn::Vec<D>;

  VertexSolver(const VertexEquations<Real>& equations, const VertexStrip& strip,
               const StripForce<Real>& force, const StripBlocks<Real>& blocks, State<Real>& now)
      : equations_(equations),
        strip_(strip),
        force_(force),
        blocks_(blocks),
        now_(now),
        writer_(strip, now) {}

  /// The vector from particle `first` on, `lane` lanes behind its block's first. Not inlined: it is long, and
  /// called from many places.
  HWY_NOINLINE void solve(std::size_t first, std::size_t lane, const SpringSums<V>& springs) {
    const D d;
    const Real* const masses = equations_.inverse_mass.block((first - lane) / block_size) + lane;
    const V inverse_mass = hn::Load(d, masses), h = hn::Set(d, equations_.h);
    const std::size_t in_strip = first - strip_.begin * block_size;
    const Symmetric3<V> a = matrix(d, inverse_mass, hn::Mul(h, h), springs, in_strip);
    const Vector3<V> v = load3(d, now_.vx() + first, now_.vy() + first, now_.vz() + first);
    const Vector3<V> dv = solve3(d, a, residual(d, hn::Mul(h, inverse_mass), v, springs, first, in_strip));
    // Pinned particles and padding stay as they are; so do lanes of other colours.
    const auto free = hn::Gt(inverse_mass, hn::Zero(d));
    const Vector3<V> change = {hn::IfThenElseZero(free, dv.x), hn::IfThenElseZero(free, dv.y),
                               hn::IfThenElseZero(free, dv.z)};
    const Vector3<V> velocity = {hn::Add(v.x, change.x), hn::Add(v.y, change.y), hn::Add(v.z, change.z)};
    const Vector3<V> x = load3(d, now_.x() + first, now_.y() + first, now_.z() + first);
    const State<Real>& from = equations_.from;
    const Vector3<V> at = load3(d, from.x() + first, from.y() + first, from.z() + first);
    writer_.write(first,
                  {hn::IfThenElse(free, hn::MulAdd(h, velocity.x, at.x), x.x),
                   hn::IfThenElse(free, hn::MulAdd(h, velocity.y, at.y), x.y),
                   hn::IfThenElse(free, hn::MulAdd(h, velocity.z, at.z), x.z)},
                  velocity);
    count(d, first, dot(change, change));
  }

  double sum() const { return sum_; }

 private:
  HWY_INLINE Symmetric3<V> matrix(D d, V inverse_mass, V of_stiffness, const SpringSums<V>& springs,
                                  std::size_t in_strip) const {
    const V across = hn::Mul(of_stiffness, springs.across), one = hn::Set(d, Real(1));
    const Symmetric3<V>& s = springs.along;
    const auto diagonal = [&](V along, const Real* effects) HWY_ATTR {
      return hn::MulAdd(inverse_mass, hn::Add(hn::Add(along, across), hn::Load(d, effects + in_strip)), one);
    };
    const auto beside = [&](V along, const Real* effects) HWY_ATTR {
      return hn::Mul(inverse_mass, hn::Add(along, hn::Load(d, effects + in_strip)));
    };
    return {diagonal(s.xx, blocks_.xx), beside(s.xy, blocks_.xy), beside(s.xz, blocks_.xz),
            diagonal(s.yy, blocks_.yy), beside(s.yz, blocks_.yz), diagonal(s.zz, blocks_.zz)};
  }

  HWY_INLINE Vector3<V> residual(D d, V of_force, const Vector3<V>& v, const SpringSums<V>& springs,
                                 std::size_t first, std::size_t in_strip) const {
    const State<Real>& from = equations_.from;
    const Vector3<V> before = load3(d, from.vx() + first, from.vy() + first, from.vz() + first) - v;
    const Vector3<V> effects = load3(d, force_.x + in_strip, force_.y + in_strip, force_.z + in_strip);
    return {hn::MulAdd(of_force, hn::Add(springs.force.x, effects.x), before.x),
            hn::MulAdd(of_force, hn::Add(springs.force.y, effects.y), before.y),
            hn::MulAdd(of_force, hn::Add(springs.force.z, effects.z), before.z)};
  }

  HWY_INLINE void count(D d, std::size_t first, V squares) {
    if (writer_.whole(first)) {
      sum_ += double(hn::GetLane(hn::SumOfLanes(d, squares)));
      return;
    }
    HWY_ALIGN Real lanes[hn::MaxLanes(D())];
    hn::Store(squares, d, lanes);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      if (first + lane >= strip_.first && first + lane < strip_.last) sum_ += double(lanes[lane]);
    }
  }

  const VertexEquations<Real>& equations_;
  const VertexStrip& strip_;
  const StripForce<Real>& force_;
  const StripBlocks<Real>& blocks_;
  State<Real>& now_;
  StripWriter<Real> writer_;
  double sum_ = 0.0;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE SpringSums<V> no_springs(D d) {
  const V zero = hn::Zero(d);
  return {{zero, zero, zero}, zero, {zero, zero, zero, zero, zero, zero}};
}

template <bool damped, class Real>
HWY_INLINE void solve_jointly(const VertexEquations<Real>& equations, const VertexStrip& strip,
                              const State<Real>& now, VertexSolver<Real>& solver) {
  using V = typename VertexSolver<Real>::V;
  const typename VertexSolver<Real>::D d;
  const V h = hn::Set(d, equations.h);
  const Weights<V> weights = {hn::Mul(h, h), h, hn::Set(d, equations.least_across)};
  with_reader_of<damped, damped>(*equations.slots, now, [&](const auto& reader) HWY_ATTR {
    const auto solve_list = [&]<std::size_t vectors>(const auto& list, std::size_t first,
                                                     std::size_t lane) HWY_ATTR {
      SpringSums<V> sums[vectors];
      for (std::size_t v = 0; v < vectors; ++v) sums[v] = no_springs(d);
      const auto add = [&](std::size_t v, const auto& own, const auto& other, const auto& rows)
                           HWY_ATTR { add_spring<damped>(d, own, other, rows, weights, sums[v]); };
      for_each_spring<vectors>(reader, list, first, lane, add);
      for (std::size_t v = 0; v < vectors; ++v) solver.solve(first + v * block_size, lane, sums[v]);
    };
    for_each_vector_of_blocks(*equations.slots, strip.begin, strip.end, solve_list);
  });
}

template <class Real>
double solve_strip(const VertexEquations<Real>& equations, const VertexStrip& strip,
                   const StripForce<Real>& force, const StripBlocks<Real>& blocks, State<Real>& now) {
  const FlushSubnormals flush;
  VertexSolver<Real> solver(equations, strip, force, blocks, now);
  const typename VertexSolver<Real>::D d;
  if (equations.slots == nullptr) {
    for (std::size_t first = strip.begin * block_size; first < strip.end * block_size; first += hn::Lanes(d))
      solver.solve(first, first % block_size, no_springs(d));
  } else if (equations.slots->damped) {
    solve_jointly<true>(equations, strip, now, solver);
  } else {
    solve_jointly<false>(equations, strip, now, solver);
  }
  return solver.sum();
}

}  // namespace

double solve_float(const VertexEquations<float>& equations, const VertexStrip& strip,
                   const StripForce<float>& force, const StripBlocks<float>& blocks, State<float>& now) {
  return solve_strip(equations, strip, force, blocks, now);
}

double solve_double(const VertexEquations<double>& equations, const VertexStrip& strip,
                    const StripForce<double>& force, const StripBlocks<double>& blocks, State<double>& now) {
  return solve_strip(equations, strip, force, blocks, now);
}

}  // namespace HWY_NAMESPACE
}  // namespace hooke
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hooke {
namespace {

HWY_EXPORT(solve_float);
HWY_EXPORT(solve_double);

}  // namespace

template <>
double solve_vertices(const VertexEquations<float>& equations, const VertexStrip& strip,
                      const StripForce<float>& force, const StripBlocks<float>& blocks, State<float>& now) {
  return HWY_DYNAMIC_DISPATCH(solve_float)(equations, strip, force, blocks, now);
}

template <>
double solve_vertices(const VertexEquations<double>& equations, const VertexStrip& strip,
                      const StripForce<double>& force, const StripBlocks<double>& blocks,
                      State<double>& now) {
  return HWY_DYNAMIC_DISPATCH(solve_double)(equations, strip, force, blocks, now);
}

}  // namespace hooke
#endif
