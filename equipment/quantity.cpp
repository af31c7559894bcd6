#include "equipment/quantity.h"

#include <fmt/format.h>

#include <array>

#include "engine/base/units.h"

namespace gurney {

using config::Range;
using config::Table;

double Quantities::number(const std::string& key, const Range& range,
                          std::optional<double> fallback) {
  if (!table_.is_table(key)) return table_.number(key, range, fallback);
  Table quantity = *table_.table(key);
  const double value = quantity.number("value", range);
  const Provenance found = provenance(quantity, key);
  if (!found.has_range && found.reason.empty()) return value;
  const std::size_t mistakes = table_.document().mistakes();
  const std::vector<double> ends = quantity.numbers("range", range, 2);
  if (table_.document().mistakes() > mistakes) return value;
  if (!(ends[0] <= value && value <= ends[1] && ends[0] < ends[1]))
    quantity.note("range", fmt::format(" = [{}, {}]: must be [low, high] with low < high around {}",
                                       ends[0], ends[1], value));
  if (!found.reason.empty()) assume(key, value, ends[0], ends[1], found.reason);
  return value;
}

Vector3 Quantities::vector(const std::string& key, const Range& range,
                           std::optional<Vector3> fallback) {
  if (!table_.is_table(key)) return table_.vector(key, range, fallback);
  Table quantity = *table_.table(key);
  const Vector3 value = quantity.vector("value", range);
  const Provenance found = provenance(quantity, key);
  if (found.reason.empty()) return value;
  const std::size_t mistakes = table_.document().mistakes();
  const Vector3 low = quantity.vector("low", range), high = quantity.vector("high", range);
  if (table_.document().mistakes() > mistakes) return value;
  if (!((low.array() <= value.array()).all() && (value.array() <= high.array()).all() &&
        (low.array() < high.array()).any()))
    quantity.note("low",
                  ": low <= value <= high must hold for each number, and low < high for one");
  static constexpr std::array kAxes = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i)
    if (low[i] < high[i])
      assume(fmt::format("{}.{}", key, kAxes[i]), value[i], low[i], high[i], found.reason);
  return value;
}

std::string Quantities::text(const std::string& key, std::optional<std::string> fallback) {
  if (!table_.is_table(key)) return table_.text(key, fallback);
  Table quantity = *table_.table(key);
  const std::string value = quantity.text("value");
  const Provenance found = provenance(quantity, key);
  if (!found.reason.empty()) {
    Assumption assumption;
    assumption.key = table_.name_of(key);
    assumption.choice = value;
    assumption.reason = found.reason;
    assumption.file = table_.document().path();
    assumptions_->push_back(assumption);
  }
  return value;
}

double Quantities::length_mm(const std::string& key, const Range& range,
                             std::optional<double> fallback) {
  return number(key, range, fallback) / kMillimetersPerMeter;
}

Vector3 Quantities::vector_mm(const std::string& key, const Range& range,
                              std::optional<Vector3> fallback) {
  return vector(key, range, fallback) / kMillimetersPerMeter;
}

Quantities::Provenance Quantities::provenance(Table& quantity, const std::string& key) {
  const std::string source = quantity.text("source", "");
  Provenance found{quantity.text("assumption", ""), quantity.has("range")};
  if (source.empty() && found.reason.empty())
    table_.note(key, ": must have a source, an assumption with its range, or both");
  return found;
}

void Quantities::assume(const std::string& key, double value, double low, double high,
                        const std::string& reason) {
  assumptions_->push_back(
      {table_.name_of(key), "", value, low, high, reason, table_.document().path()});
}

}  // namespace gurney
