#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gurney {

/// Linear equations of bodies that push or hold each other: a block of unknowns for each, coupled in
/// pairs. Solved by Gaussian elimination block after block, with pivoting inside a block: those on the
/// diagonal are the mass of a body with the slopes of all that holds it, and regular. A body that hangs
/// on one other and is eliminated before it leaves all other blocks as they are.
class BlockSystem {
 public:
  void clear() { begin_.assign(1, 0); }
  /// @returns the number of the block; blocks are eliminated in the order in which they are added
  std::size_t add_block(Eigen::Index size) {
    begin_.push_back(begin_.back() + size);
    return begin_.size() - 2;
  }
  /// Makes matrix and right side zero, once all blocks are added.
  void set_zero();

  /// K and b of K x = b.
  Eigen::Map<Eigen::MatrixXd> matrix() { return {matrix_.data(), size(), size()}; }
  Eigen::Map<Eigen::VectorXd> right_side() { return {right_side_.data(), size()}; }
  /// Unknowns of all blocks so far: where the next one begins.
  Eigen::Index size() const { return begin_.back(); }
  /// Notes that entries between two blocks are written: the others stay zero.
  void couple(std::size_t a, std::size_t b) { coupled(a, b) = coupled(b, a) = 1; }

  /// Leaves the solution in right_side().
  void solve();

 private:
  std::size_t count() const { return begin_.size() - 1; }
  Eigen::Index size_of(std::size_t block) const { return begin_[block + 1] - begin_[block]; }
  char& coupled(std::size_t a, std::size_t b) { return coupled_[a * count() + b]; }
  void eliminate(std::size_t block);
  void reduce_rows(std::size_t block);

  std::vector<Eigen::Index> begin_{0};  // of each block, and the end
  /// Eigen works on entries up to its next boundary of alignment one by one, and on those after it in packets, whose
  /// rounding is another: without a boundary at the start, bits would depend on where the memory is.
  using Aligned = std::vector<double, Eigen::aligned_allocator<double>>;
  Aligned matrix_, right_side_;     // by columns
  std::vector<char> coupled_;       // of pairs of blocks
  std::vector<double> rows_;        // of the block that is eliminated, one after the other
  std::vector<std::size_t> later_;  // blocks that one is coupled to and that follow it
};

}  // namespace gurney
