#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/config/table.h"
#include "equipment/assumption.h"

namespace gurney {

/// Reads numbers that say where they come from. A quantity is a bare number or a table:
///
///     mass_kg  = 96.5
///     mass_kg  = { value = 96.5, source = "Xu, Ma & Kurata 2022, section 3.1" }
///     trail_mm = { value = 34, assumption = "offset - R", range = [30, 84] }
///
/// A vector has `low` and `high` (arrays) in place of `range`. A table needs a source, an
/// assumption, or both; an assumption needs its range, which holds the value. Every assumption
/// read goes to the list given, with the key and value as the file has them. The results are SI.
class Quantities {
 public:
  Quantities(config::Table table, std::vector<Assumption>& assumptions)
      : table_(std::move(table)), assumptions_(&assumptions) {}

  double number(const std::string& key, const config::Range& range,
                std::optional<double> fallback = {});
  Vector3 vector(const std::string& key, const config::Range& range,
                 std::optional<Vector3> fallback = {});
  std::string text(const std::string& key, std::optional<std::string> fallback = {});

  /// Keys in millimetres, ranges and fallbacks too; the result in metres.
  double length_mm(const std::string& key, const config::Range& range,
                   std::optional<double> fallback = {});
  Vector3 vector_mm(const std::string& key, const config::Range& range,
                    std::optional<Vector3> fallback = {});

  config::Table& table() { return table_; }

 private:
  struct Provenance {
    std::string reason;
    bool has_range = false;
  };

  Provenance provenance(config::Table& quantity, const std::string& key);
  void assume(const std::string& key, double value, double low, double high,
              const std::string& reason);

  config::Table table_;
  std::vector<Assumption>* assumptions_;
};

}  // namespace gurney
