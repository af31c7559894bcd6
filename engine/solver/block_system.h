#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gurney {

/// Linear equations K x = b of bodies that push or hold each other: a block of unknowns for each, coupled
/// in pairs. Solved by Gaussian elimination block after block, with pivoting inside a block: those on the
/// diagonal are the mass of a body with the slopes of all that holds it, and regular. A body that hangs
/// on one other and is eliminated before it leaves all other blocks as they are.
///
/// Only blocks of coupled pairs exist. Their rows are in groups of four numbers, with zeros behind the
/// last: what is done to a row is done to four at once, wherever the memory begins.
class BlockSystem {
 public:
  using Block = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>,
                           Eigen::Unaligned, Eigen::OuterStride<>>;
  using Column = Eigen::Map<Eigen::VectorXd, Eigen::Unaligned, Eigen::InnerStride<>>;

  void clear();
  /// @returns the number of the block; blocks are eliminated in the order in which they are added
  std::size_t add_block(Eigen::Index size);
  /// Once all blocks are added: matrix and right side are zero, and no blocks coupled.
  void set_zero();
  /// Gives two blocks entries in each other's rows, which are zero at first. Blocks seen before may move.
  void couple(std::size_t a, std::size_t b);
  bool coupled(std::size_t a, std::size_t b) const { return place(a, b) != kNone; }

  /// Rows of block `a`, columns of block `b`: the same, or coupled with it.
  Block block(std::size_t a, std::size_t b) {
    return {numbers_.data() + place(a, b), size_of(a), size_of(b),
            Eigen::OuterStride<>(stride(a, b))};
  }
  /// b, and after solve() x, of a block.
  Column right_side(std::size_t a) {
    return {numbers_.data() + place(a, a) + size_of(a), size_of(a),
            Eigen::InnerStride<>(stride(a, a))};
  }
  std::size_t count() const { return sizes_.size(); }
  Eigen::Index size_of(std::size_t block) const { return sizes_[block]; }

  /// Leaves the solution in right_side().
  void solve();

 private:
  static constexpr std::size_t kNone = -1;
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

  /// The right side is one more column of the block on the diagonal.
  Eigen::Index stride(std::size_t a, std::size_t b) const;
  std::size_t& place(std::size_t a, std::size_t b) { return places_[a * count() + b]; }
  std::size_t place(std::size_t a, std::size_t b) const { return places_[a * count() + b]; }
  void add_numbers(std::size_t a, std::size_t b);
  void eliminate(std::size_t block);
  template <int kSize>
  void reduce_rows(std::size_t block);

  std::vector<Eigen::Index> sizes_;  // of the blocks
  std::vector<std::size_t> places_;  // in numbers_, of pairs of blocks
  std::vector<double, Eigen::aligned_allocator<double>>
      numbers_;                     // no group of four is in two cache lines
  std::vector<std::size_t> later_;  // blocks that one is coupled to and that follow it
  std::vector<Rows> rows_;          // of these, in the rows of that one
};

}  // namespace gurney
