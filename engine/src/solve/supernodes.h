#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/SparseCore>

namespace hooke {

/// Consecutive columns of a Cholesky factor whose rows below them are the same, so that they are one dense
/// block: what is done with it reads a row's number once for all its columns.
struct Supernode {
  std::uint32_t first_column, columns;
  std::uint32_t first_row, rows;  ///< below its columns: a range of Supernodes::rows
  std::size_t block;  ///< its values begin there: columns x columns on the diagonal, then rows x columns
};

struct Supernodes {
  std::vector<Supernode> nodes;     ///< in the order of their columns
  std::vector<std::uint32_t> rows;  ///< of the factor; of each node in increasing order
  std::size_t values = 0;           ///< of all blocks
};

/// The supernodes of a factor: lower triangle by columns, with its diagonal, rows in increasing order. Where
/// few zeros have to be stored for it, a node is merged with the one that follows, if it depends on that
/// (relaxed supernodes, Ashcraft and Grimes 1989).
Supernodes find_supernodes(const Eigen::SparseMatrix<double>& factor);

}  // namespace hooke
