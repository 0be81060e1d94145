#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "aligned.h"
#include "state.h"

namespace hooke {

/// Remembers where things with a hash were stored, the latest at each place of a small table.
class HashTable {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::uint32_t& place(std::uint64_t hash) { return table_[(hash >> 40) % table_.size()]; }

  static std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
    return (hash ^ word) * 0x9E3779B97F4A7C15u;
  }

 private:
  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(4096, none);
};

/// Rows of 16 values, equal ones stored once as far as the table remembers them.
template <class Real>
class RowStore {
 public:
  /// The number of a row of these lanes.
  std::uint32_t row(const std::array<Real, block_size>& lanes) {
    std::uint64_t hash = 0;
    for (Real lane : lanes) hash = HashTable::mix(hash, std::hash<Real>{}(lane));
    std::uint32_t& known = table_.place(hash);
    if (known != HashTable::none &&
        std::equal(lanes.begin(), lanes.end(), values.data() + std::size_t(known) * block_size)) {
      return known;
    }
    known = std::uint32_t(values.size() / block_size);
    values.insert(values.end(), lanes.begin(), lanes.end());
    return known;
  }

  AlignedVector<Real> values;

 private:
  HashTable table_;
};

/// A constant of each particle in whole blocks, zero in the padding; equal blocks are stored once. In a cloth
/// of equal masses that is next to nothing to read.
template <class Real>
class BlockRows {
 public:
  BlockRows() = default;

  /// `value_of(particle)` in the engine's order.
  template <class ValueOf>
  BlockRows(std::size_t particles, const ValueOf& value_of) {
    RowStore<Real> store;
    rows_.reserve(block_count(particles));
    for (std::size_t first = 0; first < particles; first += block_size) {
      std::array<Real, block_size> lanes{};
      for (std::size_t i = first; i < std::min(first + block_size, particles); ++i)
        lanes[i - first] = value_of(i);
      rows_.push_back(store.row(lanes));
    }
    values_ = std::move(store.values);
  }

  /// The 16 values of a block.
  const Real* block(std::size_t number) const {
    return values_.data() + std::size_t(rows_[number]) * block_size;
  }
  Real operator[](std::size_t particle) const { return block(particle / block_size)[particle % block_size]; }
  std::size_t bytes() const {
    return rows_.capacity() * sizeof(std::uint32_t) + values_.capacity() * sizeof(Real);
  }

 private:
  std::vector<std::uint32_t> rows_;
  AlignedVector<Real> values_;
};

}  // namespace hooke
