#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// Reads numbers that state their source. A quantity is a bare number or a table:
///
///     mass_kg  = 96.5
///     mass_kg  = { value = 96.5, source = "Xu, Ma & Kurata 2022, section 3.1" }
///     trail_mm = { value = 34, assumption = "offset - R", range = [30, 84] }
///
/// A vector has `low` and `high` (arrays) in place of `range`. A table needs a source, an
/// assumption, or both; an assumption needs its range, which holds the value.
///
/// A table may have a `distribution` (uncertainty.h), for a vector one for each axis; it has a
/// source or assumption of its own, and the value must be in its support.
class Quantities {
 public:
  explicit Quantities(config::Table table) : table_(std::move(table)) {}

  StatedQuantity number(const std::string& key, const config::Range& range,
                        std::optional<double> fallback = {});
  std::array<StatedQuantity, 3> vector(const std::string& key, const config::Range& range,
                                       std::optional<Vector3> fallback = {});
  StatedText text(const std::string& key);

  /// Its distribution has the values 0 (false) and 1 (true).
  QuantityList flag(const std::string& key, bool fallback);

  /// Numbers or flags of equal parts: an array, or one for all; a distribution is that of each part
  /// by itself. Empty if absent.
  /// @param drawn  one for each part, false: its value holds in a draw too
  QuantityList numbers(const std::string& key, const config::Range& range,
                       const std::vector<bool>& drawn);
  QuantityList flags(const std::string& key, const std::vector<bool>& drawn);

  bool is_one_for_all(const std::string& key);  ///< of numbers and flags: not an array

  /// x and y.
  std::array<StatedQuantity, 2> plane(const std::string& key, const config::Range& range);

  /// Keys in millimetres, ranges and fallbacks too.
  StatedQuantity length_mm(const std::string& key, const config::Range& range,
                           std::optional<double> fallback = {});
  std::array<StatedQuantity, 3> vector_mm(const std::string& key, const config::Range& range);

  /// Keys in degrees.
  StatedQuantity angle_deg(const std::string& key, const config::Range& range,
                           std::optional<double> fallback = {});

  /// Notes a number that is above another, or that a draw could put there: their distributions need
  /// bounds apart, or one group and the order at every probability.
  void keep_order(const std::string& lower_key, const StatedQuantity& lower,
                  const std::string& upper_key, const StatedQuantity& upper);

  config::Table& table() { return table_; }

 private:
  struct Provenance {
    std::string reason;
    bool given = false;  ///< there is a source or an assumption
    bool has_range = false;
  };

  template <std::size_t size>
  std::array<StatedQuantity, size> components(const std::string& key, const config::Range& range,
                                              std::optional<std::vector<double>> fallback);
  std::vector<StatedQuantity> read_components(const std::string& key, const config::Range& range,
                                              std::size_t size,
                                              std::optional<std::vector<double>> fallback);
  QuantityList parts(const std::string& key, config::Table& quantity, const config::Range& range,
                     const std::vector<double>& values, const std::vector<bool>& drawn, bool flags);
  QuantityList plain(const std::string& key, const std::vector<double>& values) const;
  Provenance provenance(config::Table& quantity, const std::string& key);
  void note_outside(const std::string& key, const Uncertainty& uncertainty, double value);
  StatedQuantity plain(const std::string& key, double value, const std::string& component) const;
  Assumption choice(const std::string& key, const std::string& text,
                    const std::string& reason) const;

  config::Table table_;
};

}  // namespace gurney::equipment
