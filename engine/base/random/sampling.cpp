#include "engine/base/random/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/random/sobol.hpp>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"

namespace gurney {
namespace {

// Streams of their own: plain draws of the same variable must not come again.
constexpr std::uint64_t kCells = 0x6c61746963656c6c, kPlaces = 0x6c6174706c616365,
                        kShifts = 0x736f626f6c736866;
constexpr int kRounds = 8;
constexpr int kBits = 52;  // so that the middle of a cell is a double
const double kBelowOne = std::nextafter(1.0, 0.0);

/// A permutation of 0 to 4^half - 1.
std::uint64_t feistel(std::uint64_t seed, std::uint64_t stream, std::uint64_t x, int half) {
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  std::uint64_t left = x >> half, right = x & mask;
  for (int round = 0; round < kRounds; ++round) {
    const std::uint64_t counter = (static_cast<std::uint64_t>(round) << 40) | right;
    const double u = uniform_draw(seed, stream, counter);
    const auto mixed = static_cast<std::uint64_t>(std::ldexp(u, half));
    const std::uint64_t next = left ^ mixed;
    left = right;
    right = next;
  }
  return (left << half) | right;
}

/// The direction numbers of one dimension, most significant bit first (Bratley & Fox 1988, ACM
/// TOMS 14(1), 88-100, section 2).
std::array<std::uint64_t, kBits> directions(std::uint64_t dimension) {
  using Table = boost::random::default_sobol_table;
  std::array<std::uint64_t, kBits> m{};
  if (dimension == 0) {
    m.fill(1);
  } else {
    const auto row = static_cast<std::size_t>(dimension - 1);
    const unsigned polynomial = Table::polynomial(row);
    const auto degree = static_cast<std::size_t>(std::bit_width(polynomial) - 1);
    for (std::size_t k = 0; k < m.size(); ++k) {
      if (k < degree) {
        m[k] = Table::minit(row, k);
        continue;
      }
      m[k] = m[k - degree];
      for (std::size_t j = 0; j < degree; ++j)
        if ((polynomial >> j) & 1) m[k] ^= m[k - (degree - j)] << (degree - j);
    }
  }
  for (std::size_t k = 0; k < m.size(); ++k) m[k] <<= m.size() - 1 - k;
  return m;
}

}  // namespace

double latin_hypercube_draw(std::uint64_t seed, std::uint64_t variable, std::uint64_t i,
                            std::uint64_t n) {
  require(i < n, fmt::format("draw {} must be below the number of draws, {}", i, n));
  require(n <= std::uint64_t{1} << 40, fmt::format("{} draws are too many", n));
  const int half = (std::bit_width(n - 1) + 1) / 2;
  std::uint64_t cell = i;
  if (n > 1) {
    do cell = feistel(seed, variable ^ kCells, cell, half);
    while (cell >= n);
  }
  const double place = uniform_draw(seed, variable ^ kPlaces, i);
  return std::min((static_cast<double>(cell) + place) / static_cast<double>(n), kBelowOne);
}

double sobol_draw(std::uint64_t seed, std::uint64_t dimension, std::uint64_t i) {
  require(dimension < kSobolDimensions,
          fmt::format("variable {} is too many for Sobol points: at most {}", dimension + 1,
                      kSobolDimensions));
  require(i < std::uint64_t{1} << kBits, fmt::format("Sobol point {} is too far", i));
  const auto direction = directions(dimension);
  auto x = static_cast<std::uint64_t>(std::ldexp(uniform_draw(seed, kShifts, dimension), kBits));
  const std::uint64_t gray = i ^ (i >> 1);
  for (std::size_t k = 0; k < direction.size(); ++k)
    if ((gray >> k) & 1) x ^= direction[k];
  return std::ldexp(static_cast<double>(x) + 0.5, -kBits);
}

double saltelli_draw(std::uint64_t seed, std::uint64_t inputs, std::uint64_t input,
                     const SaltelliRow& row) {
  require(2 * inputs <= kSobolDimensions,
          fmt::format("{} inputs are too many for a Saltelli design: at most {}", inputs,
                      kSobolDimensions / 2));
  require(input < inputs, fmt::format("input {} must be below {}", input, inputs));
  return sobol_draw(seed, row.from_b(input) ? inputs + input : input, row.point);
}

}  // namespace gurney
