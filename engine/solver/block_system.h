#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gurney {

/// Linear equations K x = b of bodies that push or hold each other: a block of unknowns for each, coupled
/// in pairs. Factors by Gaussian elimination block after block, with pivoting inside a block: those on the
/// diagonal are the mass of a body with the slopes of all that holds it, and regular. A body that hangs
/// on one other and is eliminated before it leaves all other blocks as they are. The factors serve any
/// number of right sides.
///
/// Only blocks of coupled pairs exist. Their rows are in groups of four numbers, with zeros behind the
/// last: what is done to a row is done to four at once, wherever the memory begins.
class BlockSystem {
 public:
  using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>,
                           Eigen::Unaligned, Eigen::OuterStride<>>;
  using Column = Eigen::Map<Eigen::VectorXd>;

  void clear() { sizes_.clear(); }
  /// @returns the number of the block; blocks are eliminated in the order in which they are added
  std::size_t add_block(Eigen::Index size);
  /// Once all blocks are added: matrix and right side are zero, and no blocks coupled.
  void set_zero();
  /// Gives two blocks entries in each other's rows, which are zero at first. Blocks seen before may move.
  void couple(std::size_t a, std::size_t b);
  bool coupled(std::size_t a, std::size_t b) const { return place(a, b) != kNone; }

  /// Rows of block `a`, columns of block `b`: the same, or coupled with it.
  Block block(std::size_t a, std::size_t b) {
    return {numbers_.data() + place(a, b), size_of(a), size_of(b), Eigen::OuterStride<>(stride(b))};
  }
  /// b, and after solve() x, of a block.
  Column right_side(std::size_t a) { return {&sides_[side_places_[a]], size_of(a)}; }
  std::size_t count() const { return sizes_.size(); }
  Eigen::Index size_of(std::size_t block) const { return sizes_[block]; }

  /// Replaces the matrix by its factors.
  void factor();
  /// After factor(), as often as there are right sides: leaves the solution in right_side().
  void solve();

 private:
  static constexpr std::size_t kNone = -1;
  using Numbers = std::vector<double, Eigen::aligned_allocator<double>>;

  /// Rows of a block.
  struct Rows {
    double* first;
    Eigen::Index stride;

    double* row(Eigen::Index i) const { return first + i * stride; }
    void swap(Eigen::Index i, Eigen::Index k) const;
    void multiply(Eigen::Index i, double factor) const;
    /// Takes a multiple of row `from` from row `i`.
    void subtract(double factor, Eigen::Index from, Eigen::Index i) const;
  };

  Eigen::Index stride(std::size_t b) const;
  std::size_t& place(std::size_t a, std::size_t b) { return places_[a * count() + b]; }
  std::size_t place(std::size_t a, std::size_t b) const { return places_[a * count() + b]; }
  void add_numbers(std::size_t a, std::size_t b);
  void eliminate(std::size_t block);
  template <int kSize>
  void reduce_rows(std::size_t block);
  /// Blocks that one is coupled to and that follow it.
  auto later(std::size_t block) const;
  /// Takes K_mn x_n from y.
  void subtract_product(std::size_t m, std::size_t n, double* y) const;

  std::vector<Eigen::Index> sizes_;             // of the blocks
  std::vector<std::size_t> places_;             // in numbers_, of pairs of blocks
  Numbers numbers_, sides_, own_;               // no group of four is in two cache lines
  std::vector<std::size_t> side_places_;        // in sides_, of blocks
  std::vector<std::size_t> later_, later_end_;  // of each block in turn
  std::vector<Rows> rows_;                      // of these, in the rows of the one
  std::vector<Eigen::Index> pivots_;
};

}  // namespace gurney
