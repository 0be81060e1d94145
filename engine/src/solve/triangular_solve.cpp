#include "solve/triangular_solve.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solve/triangular_solve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hooke {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t sides_at_once = 4;

#if HWY_TARGET == HWY_SCALAR

template <class One, class Wide>
HWY_INLINE hn::Vec<Wide> repeat_row(Wide, hn::Vec<One> row) {
  return row;
}

template <class One, class Wide>
HWY_INLINE hn::Vec<One> sum_rows(Wide, hn::Vec<Wide> v) {
  return v;
}

#else

/// A vector of as many copies of one row as there is room for.
template <class One, class Wide>
HWY_INLINE hn::Vec<Wide> repeat_row([[maybe_unused]] Wide d, hn::Vec<One> row) {
  if constexpr (hn::MaxLanes(Wide()) == hn::MaxLanes(One())) {
    return row;
  } else {
    const auto half = repeat_row<One>(hn::Half<Wide>(), row);
    return hn::Combine(d, half, half);
  }
}

/// The sum of the rows in a vector.
template <class One, class Wide>
HWY_INLINE hn::Vec<One> sum_rows(Wide, hn::Vec<Wide> v) {
  if constexpr (hn::MaxLanes(Wide()) == hn::MaxLanes(One())) {
    return v;
  } else {
    const hn::Half<Wide> half;
    return sum_rows<One>(half, hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  }
}

#endif

/// Vectors of the four sides of as many rows as there is room for: `rows` of them. Where a vector holds fewer
/// values than four, so many vectors (`passes`) stand for a row, and all is done once for each of them.
template <class Real>
struct Sides {
  using D = hn::CappedTag<Real, 64 / sizeof(Real)>;
  using V = hn::Vec<D>;
  static constexpr std::size_t lanes = hn::MaxLanes(D());
  static constexpr std::size_t rows = lanes <= sides_at_once ? 1 : lanes / sides_at_once;
  static constexpr std::size_t passes = lanes >= sides_at_once ? 1 : sides_at_once / lanes;
  using One = hn::CappedTag<Real, lanes / rows>;  ///< of one row
  using OneV = hn::Vec<One>;

  /// The values of `rows` rows that follow each other.
  static HWY_INLINE V load(const Real* sides) { return hn::LoadU(D(), sides); }

  /// Values first[0], first[1], ..., each in all four lanes of its row.
  static HWY_INLINE V spread(const Real* first) {
    if constexpr (rows == 1) {
      return hn::Set(D(), *first);
    } else {
      const hn::RebindToSigned<D> indices;
      const auto row_of_lane = hn::ShiftRight<2>(hn::Iota(indices, 0));
      return hn::TableLookupLanes(hn::LoadDup128(D(), first), hn::IndicesFromVec(D(), row_of_lane));
    }
  }

  static HWY_INLINE V repeat(OneV row) { return repeat_row<One>(D(), row); }

  /// The sum of the rows.
  static HWY_INLINE OneV sum(V v) { return sum_rows<One>(D(), v); }

  /// Of a node's columns, those behind the last whole vector, with zeros for what is behind the node.
  static HWY_INLINE V last(const Real* own, std::size_t columns) {
    const std::size_t inside = columns / rows * rows;
    return hn::IfThenElseZero(hn::FirstN(D(), (columns - inside) * sides_at_once),
                              load(own + inside * sides_at_once));
  }

  /// Stores the first `count` rows of the vector, or all of them where there are fewer.
  static HWY_INLINE void store_first(V v, std::size_t count, Real* sides) {
    if (count >= rows) {
      hn::StoreU(v, D(), sides);
    } else {
      hn::BlendedStore(v, hn::FirstN(D(), count * sides_at_once), D(), sides);
    }
  }
};

/// `count` products of rows of a block, `columns` wide, with `sides`; behind `until` all of them are zero.
/// `last` is what S::last() gives.
template <std::size_t count, class Real, class S = Sides<Real>>
HWY_INLINE void multiply_rows(const Real* block, std::size_t columns, std::size_t until, typename S::V last,
                              const Real* sides, typename S::OneV* HWY_RESTRICT products) {
  typename S::V sum[count];
  for (std::size_t r = 0; r < count; ++r) sum[r] = hn::Zero(typename S::D());
  std::size_t c = 0;
  for (; c < until && c + S::rows <= columns; c += S::rows) {
    const auto side = S::load(sides + c * sides_at_once);
    for (std::size_t r = 0; r < count; ++r)
      sum[r] = hn::MulAdd(S::spread(block + r * columns + c), side, sum[r]);
  }
  if (c < until) {
    for (std::size_t r = 0; r < count; ++r)
      sum[r] = hn::MulAdd(S::spread(block + r * columns + c), last, sum[r]);
  }
  for (std::size_t r = 0; r < count; ++r) products[r] = S::sum(sum[r]);
}

/// Calls take(first, constant) for runs of four rows of [0, count), and then for one row at a time, from the
/// last on.
template <class Take>
HWY_INLINE void for_rows_from_last(std::size_t count, const Take& take) {
  std::size_t end = count;
  for (; end % 4 != 0; --end) take(end - 1, std::integral_constant<std::size_t, 1>());
  for (; end != 0; end -= 4) take(end - 4, std::integral_constant<std::size_t, 4>());
}

/// Solves L y = b for a node's columns and takes what they give from the rows below.
template <class Real>
HWY_INLINE void go_down(const Supernode& node, const std::uint32_t* rows, const Real* block, Real* sides) {
  using S = Sides<Real>;
  const typename S::One one;
  const std::size_t columns = node.columns;
  Real* const own = sides + std::size_t(node.first_column) * sides_at_once;
  // A row of the inverse of a triangle needs only rows above it, so those below may be overwritten.
  auto last = S::last(own, columns);
  for_rows_from_last(columns, [&](std::size_t row, auto count) HWY_ATTR {
    typename S::OneV products[count()];
    multiply_rows<count()>(block + row * columns, columns, row + count(), last, own, products);
    for (std::size_t r = 0; r < count(); ++r) hn::StoreU(products[r], one, own + (row + r) * sides_at_once);
  });
  last = S::last(own, columns);
  const Real* const below = block + columns * columns;
  for_rows_from_last(node.rows, [&](std::size_t row, auto count) HWY_ATTR {
    typename S::OneV products[count()];
    multiply_rows<count()>(below + row * columns, columns, columns, last, own, products);
    for (std::size_t r = 0; r < count(); ++r) {
      Real* const other = sides + std::size_t(rows[row + r]) * sides_at_once;
      hn::StoreU(hn::Sub(hn::LoadU(one, other), products[r]), one, other);
    }
  });
}

/// The product of `vectors` vectors of columns, from column `first` on, with `count` sides, of which the i-th
/// is side_of(i). Four sums at least run at once, as each addition waits for the one before.
template <std::size_t vectors, class Real, class SideOf, class S = Sides<Real>>
HWY_INLINE void multiply_columns(const Real* block, std::size_t columns, std::size_t count,
                                 const SideOf& side_of, typename S::V* HWY_RESTRICT products) {
  constexpr std::size_t at_once = 4 / vectors;
  typename S::V sum[at_once][vectors];
  for (auto& some : sum) {
    for (auto& one : some) one = hn::Zero(typename S::D());
  }
  std::size_t row = 0;
  const auto add = [&](std::size_t r) HWY_ATTR {
    const auto side = S::repeat(side_of(row));
    for (std::size_t v = 0; v < vectors; ++v)
      sum[r][v] = hn::MulAdd(S::spread(block + row * columns + v * S::rows), side, sum[r][v]);
    ++row;
  };
  while (row + at_once <= count) {
    for (std::size_t r = 0; r < at_once; ++r) add(r);
  }
  while (row < count) add(0);
  for (std::size_t v = 0; v < vectors; ++v) {
    products[v] = sum[0][v];
    for (std::size_t r = 1; r < at_once; ++r) products[v] = hn::Add(products[v], sum[r][v]);
  }
}

/// Calls take(first, constant) for runs of four, two and one vectors of columns of [0, columns).
template <std::size_t rows, class Take>
HWY_INLINE void for_column_vectors(std::size_t columns, const Take& take) {
  std::size_t first = 0;
  for (; first + 2 * rows < columns; first += 4 * rows) take(first, std::integral_constant<std::size_t, 4>());
  for (; first + rows < columns; first += 2 * rows) take(first, std::integral_constant<std::size_t, 2>());
  for (; first < columns; first += rows) take(first, std::integral_constant<std::size_t, 1>());
}

/// Solves L^T u = y for a node's columns, with those of the rows below solved.
template <class Real>
HWY_INLINE void go_up(const Supernode& node, const std::uint32_t* rows, const Real* block, Real* sides) {
  using S = Sides<Real>;
  const typename S::One one;
  const std::size_t columns = node.columns;
  Real* const own = sides + std::size_t(node.first_column) * sides_at_once;
  const auto store = [&](auto v, std::size_t column) HWY_ATTR {
    if (column < columns) S::store_first(v, columns - column, own + column * sides_at_once);
  };
  const Real* const below = block + columns * columns;
  for_column_vectors<S::rows>(columns, [&](std::size_t first, auto vectors) HWY_ATTR {
    const auto side_of = [&](std::size_t row) HWY_ATTR {
      return hn::LoadU(one, sides + std::size_t(rows[row]) * sides_at_once);
    };
    typename S::V products[vectors()];
    multiply_columns<vectors()>(below + first, columns, node.rows, side_of, products);
    for (std::size_t v = 0; v < vectors(); ++v) {
      const std::size_t column = first + v * S::rows;
      store(hn::Sub(S::load(own + column * sides_at_once), products[v]), column);
    }
  });
  // A column of the inverse of a triangle needs only rows from its own on, so those before may be
  // overwritten.
  for_column_vectors<S::rows>(columns, [&](std::size_t first, auto vectors) HWY_ATTR {
    const auto side_of = [&](std::size_t row)
                             HWY_ATTR { return hn::LoadU(one, own + (first + row) * sides_at_once); };
    typename S::V products[vectors()];
    multiply_columns<vectors()>(block + first * columns + first, columns, columns - first, side_of, products);
    for (std::size_t v = 0; v < vectors(); ++v) store(products[v], first + v * S::rows);
  });
}

template <class Real>
void solve(const BlockFactor<Real>& factor, Real* sides) {
  const Supernodes& supernodes = factor.supernodes;
  const auto visit = [&](const Supernode& node, const auto& go) HWY_ATTR {
    go(node, supernodes.rows.data() + node.first_row, factor.values.data() + node.block);
  };
  for (std::size_t pass = 0; pass < Sides<Real>::passes; ++pass) {
    Real* const part = sides + pass * Sides<Real>::lanes;
    const auto down = [&](const Supernode& node, const std::uint32_t* rows, const Real* block)
                          HWY_ATTR { go_down(node, rows, block, part); };
    const auto up = [&](const Supernode& node, const std::uint32_t* rows, const Real* block)
                        HWY_ATTR { go_up(node, rows, block, part); };
    const auto end_of = [&](const AwakeBlocks::Run& run) {
      return std::min(run.end, supernodes.nodes.size());
    };
    for (const AwakeBlocks::Run& run : factor.awake.runs()) {
      for (std::size_t n = run.begin; n < end_of(run); ++n) visit(supernodes.nodes[n], down);
    }
    for (std::size_t r = factor.awake.runs().size(); r-- > 0;) {
      const AwakeBlocks::Run& run = factor.awake.runs()[r];
      for (std::size_t n = end_of(run); n-- > run.begin;) visit(supernodes.nodes[n], up);
    }
  }
}

}  // namespace

void solve_float(const BlockFactor<float>& factor, float* sides) {
  solve(factor, sides);
}
void solve_double(const BlockFactor<double>& factor, double* sides) {
  solve(factor, sides);
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
void solve_triangles(const BlockFactor<float>& factor, float* sides) {
  HWY_DYNAMIC_DISPATCH(solve_float)(factor, sides);
}

template <>
void solve_triangles(const BlockFactor<double>& factor, double* sides) {
  HWY_DYNAMIC_DISPATCH(solve_double)(factor, sides);
}

}  // namespace hooke
#endif
