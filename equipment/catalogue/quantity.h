#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// Reads numbers that say where they come from. A quantity is a bare number or a table:
///
///     mass_kg  = 96.5
///     mass_kg  = { value = 96.5, source = "Xu, Ma & Kurata 2022, section 3.1" }
///     trail_mm = { value = 34, assumption = "offset - R", range = [30, 84] }
///
/// A vector has `low` and `high` (arrays) in place of `range`. A table needs a source, an
/// assumption, or both; an assumption needs its range, which holds the value. Every assumption
/// read goes to the list given, with the key and value as the file has them. The results are SI.
///
/// A table may have a `distribution` (uncertainty.h), for a vector one for each axis; it has a
/// source or assumption of its own, and the value must be in its support. Where the document has a
/// draw, the result is drawn and goes to the list; else it is the value.
class Quantities {
 public:
  Quantities(config::Table table, std::vector<Assumption>& assumptions)
      : table_(std::move(table)), assumptions_(&assumptions) {}

  double number(const std::string& key, const config::Range& range,
                std::optional<double> fallback = {});
  Vector3 vector(const std::string& key, const config::Range& range,
                 std::optional<Vector3> fallback = {});
  std::string text(const std::string& key, std::optional<std::string> fallback = {});

  /// Its distribution has the values 0 (false) and 1 (true).
  bool flag(const std::string& key, bool fallback);

  /// Numbers or flags of equal parts: an array, or one for all; a distribution is that of each part
  /// by itself. Empty if absent.
  /// @param drawn  one for each part, false: its value holds in a draw too
  std::vector<double> numbers(const std::string& key, const config::Range& range,
                              const std::vector<bool>& drawn);
  std::vector<bool> flags(const std::string& key, const std::vector<bool>& drawn);

  bool is_one_for_all(const std::string& key);  ///< of numbers and flags: not an array

  /// What `number` read for this key, before any draw; 0 if it did not.
  double stated(const std::string& key) const;

  /// x and y.
  std::vector<double> plane(const std::string& key, const config::Range& range,
                            const std::vector<double>& fallback);

  /// Keys in millimetres, ranges and fallbacks too; the result in metres.
  double length_mm(const std::string& key, const config::Range& range,
                   std::optional<double> fallback = {});
  Vector3 vector_mm(const std::string& key, const config::Range& range,
                    std::optional<Vector3> fallback = {});

  /// Notes a number that is above another, or that a draw could put there: their distributions need
  /// bounds apart, or one group and the order at every probability.
  void keep_order(const std::string& lower_key, double lower, const std::string& upper_key,
                  double upper);

  config::Table& table() { return table_; }

 private:
  struct Provenance {
    std::string reason;
    bool given = false;  ///< there is a source or an assumption
    bool has_range = false;
  };

  /// What a value rests on; no reason: a source.
  struct Basis {
    std::string reason;
    double low, high;
  };

  std::vector<double> components(const std::string& key, const config::Range& range,
                                 std::size_t size, std::optional<std::vector<double>> fallback);
  std::vector<double> parts(const std::string& key, config::Table& quantity,
                            const config::Range& range, std::vector<double> values,
                            const std::vector<bool>& drawn, bool flags);
  Provenance provenance(config::Table& quantity, const std::string& key);
  void note_outside(const std::string& key, const Uncertainty& uncertainty, double value);

  /// The value, or what the document's draw makes of it, with its entry in the list.
  double settle(const std::string& name, double value,
                const std::optional<Uncertainty>& uncertainty, const Basis& basis);
  void choose(const std::string& key, const std::string& choice, const std::string& reason);

  config::Table table_;
  std::map<std::string, Uncertainty> uncertain_;  ///< numbers read so far
  std::map<std::string, double> stated_;
  std::vector<Assumption>* assumptions_;
};

}  // namespace gurney::equipment
