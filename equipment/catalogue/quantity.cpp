#include "equipment/catalogue/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/units.h"

namespace gurney::equipment {

using config::Range;
using config::Table;

namespace {

constexpr std::array kAxes = {"x", "y", "z"};
constexpr int kOrderChecks = 1000;

bool moves_with(const CorrelationGroup& a, const CorrelationGroup& b) {
  return !a.name.empty() && a.name == b.name && a.correlation == 1 && b.correlation == 1;
}

}  // namespace

double Quantities::number(const std::string& key, const Range& range,
                          std::optional<double> fallback) {
  if (!table_.is_table(key)) return stated_[key] = table_.number(key, range, fallback);
  Table quantity = *table_.table(key);
  const std::size_t mistakes = table_.document().mistakes();
  const double value = stated_[key] = quantity.number("value", range);
  const Provenance found = provenance(quantity, key);
  Basis basis{found.reason, value, value};
  if (found.has_range || !found.reason.empty()) {
    const std::vector<double> ends = quantity.numbers("range", range, 2);
    basis.low = ends[0];
    basis.high = ends[1];
    if (table_.document().mistakes() == mistakes &&
        !(ends[0] <= value && value <= ends[1] && ends[0] < ends[1]))
      quantity.note("range",
                    fmt::format(" = [{}, {}]: must be [low, high] with low < high around {}",
                                ends[0], ends[1], value));
  }
  std::optional<Uncertainty> uncertainty;
  if (quantity.has("distribution")) uncertainty = read_uncertainty(quantity, "distribution", range);
  if (table_.document().mistakes() > mistakes) return value;
  if (uncertainty) {
    note_outside(key, *uncertainty, value);
    if (!found.given)
      basis = {uncertainty->reason, uncertainty->distribution.low(),
               uncertainty->distribution.high()};
    uncertain_.insert_or_assign(key, *uncertainty);
  }
  return settle(key, value, uncertainty, basis);
}

Vector3 Quantities::vector(const std::string& key, const Range& range,
                           std::optional<Vector3> fallback) {
  std::optional<std::vector<double>> list;
  if (fallback) list = std::vector<double>(fallback->begin(), fallback->end());
  const std::vector<double> values = components(key, range, 3, list);
  return Vector3(values[0], values[1], values[2]);
}

std::vector<double> Quantities::plane(const std::string& key, const Range& range,
                                      const std::vector<double>& fallback) {
  return components(key, range, 2, fallback);
}

std::vector<double> Quantities::components(const std::string& key, const Range& range,
                                           std::size_t size,
                                           std::optional<std::vector<double>> fallback) {
  if (!table_.is_table(key)) return table_.numbers(key, range, size, fallback);
  Table quantity = *table_.table(key);
  const std::size_t mistakes = table_.document().mistakes();
  std::vector<double> values = quantity.numbers("value", range, size);
  const Provenance found = provenance(quantity, key);
  std::vector<double> low = values, high = values;
  if (!found.reason.empty()) {
    low = quantity.numbers("low", range, size);
    high = quantity.numbers("high", range, size);
    bool ordered = true;
    for (std::size_t i = 0; i < size; ++i)
      ordered = ordered && low[i] <= values[i] && values[i] <= high[i];
    if (table_.document().mistakes() == mistakes && !(ordered && low != high))
      quantity.note("low",
                    ": low <= value <= high must hold for each number, and low < high for one");
  }
  std::vector<std::optional<Uncertainty>> uncertainty(size);
  if (auto axes = quantity.table("distribution"))
    for (std::size_t i = 0; i < size; ++i) {
      if (axes->has(kAxes[i]))
        uncertainty[i] = read_uncertainty(*axes, kAxes[i], range);
      else if (!found.given)
        quantity.note("distribution", std::string(".") + kAxes[i] +
                                          ": missing; the value needs a source or an assumption");
    }
  if (table_.document().mistakes() > mistakes) return values;
  for (std::size_t i = 0; i < size; ++i) {
    Basis basis{low[i] < high[i] ? found.reason : "", low[i], high[i]};
    const std::string name = fmt::format("{}.{}", key, kAxes[i]);
    if (uncertainty[i]) {
      note_outside(key, *uncertainty[i], values[i]);
      if (!found.given)
        basis = {uncertainty[i]->reason, uncertainty[i]->distribution.low(),
                 uncertainty[i]->distribution.high()};
    }
    values[i] = settle(name, values[i], uncertainty[i], basis);
  }
  return values;
}

std::string Quantities::text(const std::string& key, std::optional<std::string> fallback) {
  if (!table_.is_table(key)) return table_.text(key, fallback);
  Table quantity = *table_.table(key);
  const std::string value = quantity.text("value");
  if (quantity.has("distribution")) quantity.note("distribution", ": a text cannot be drawn");
  choose(key, value, provenance(quantity, key).reason);
  return value;
}

bool Quantities::flag(const std::string& key, bool fallback) {
  if (!table_.is_table(key)) return table_.boolean(key, fallback);
  Table quantity = *table_.table(key);
  const bool value = quantity.boolean("value");
  return parts(key, quantity, Range::any(), {value ? 1.0 : 0.0}, {true}, true)[0] != 0;
}

std::vector<double> Quantities::numbers(const std::string& key, const Range& range,
                                        const std::vector<bool>& drawn) {
  const std::size_t size = drawn.size();
  if (table_.is_array(key)) return table_.numbers(key, range, size);
  if (!table_.has(key)) return {};
  if (!table_.is_table(key)) return std::vector<double>(size, table_.number(key, range));
  Table quantity = *table_.table(key);
  std::vector<double> values = quantity.is_array("value")
                                   ? quantity.numbers("value", range, size)
                                   : std::vector<double>(size, quantity.number("value", range));
  return parts(key, quantity, range, std::move(values), drawn, false);
}

std::vector<bool> Quantities::flags(const std::string& key, const std::vector<bool>& drawn) {
  const std::size_t size = drawn.size();
  if (table_.is_array(key)) return table_.booleans(key, size);
  if (!table_.has(key)) return {};
  if (!table_.is_table(key)) return std::vector<bool>(size, table_.boolean(key));
  Table quantity = *table_.table(key);
  const std::vector<bool> flags = quantity.is_array("value")
                                      ? quantity.booleans("value", size)
                                      : std::vector<bool>(size, quantity.boolean("value"));
  const std::vector<double> values = parts(
      key, quantity, Range::any(), std::vector<double>(flags.begin(), flags.end()), drawn, true);
  std::vector<bool> settled;
  for (const double value : values) settled.push_back(value != 0);
  return settled;
}

bool Quantities::is_one_for_all(const std::string& key) {
  return !table_.is_array(key) && !(table_.is_table(key) && table_.table(key)->is_array("value"));
}

double Quantities::stated(const std::string& key) const {
  const auto found = stated_.find(key);
  return found == stated_.end() ? 0 : found->second;
}

/// Parts of one quantity, each drawn by itself; what the values rest on is one entry for all.
std::vector<double> Quantities::parts(const std::string& key, Table& quantity, const Range& range,
                                      std::vector<double> values, const std::vector<bool>& drawn,
                                      bool flags) {
  const std::size_t mistakes = table_.document().mistakes();
  const Provenance found = provenance(quantity, key);
  std::optional<Uncertainty> uncertainty;
  if (quantity.has("distribution")) uncertainty = read_uncertainty(quantity, "distribution", range);
  if (table_.document().mistakes() > mistakes) return values;
  if (!uncertainty || !table_.document().draw())
    choose(key, fmt::format("{}", fmt::join(values, ", ")),
           found.given ? found.reason : uncertainty->reason);
  if (!uncertainty) return values;
  const std::vector<double>& choices = uncertainty->distribution.values();
  const auto is_flag = [](double x) { return x == 0 || x == 1; };
  if (flags && !(choices.size() > 0 && std::all_of(choices.begin(), choices.end(), is_flag)))
    quantity.note("distribution", ": must be discrete, with the values 0 (false) and 1 (true)");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!drawn[i]) continue;
    if (table_.document().mistakes() == mistakes) note_outside(key, *uncertainty, values[i]);
    const std::string name = values.size() == 1 ? key : fmt::format("{}[{}]", key, i);
    values[i] = settle(name, values[i], uncertainty, {});
  }
  return values;
}

double Quantities::length_mm(const std::string& key, const Range& range,
                             std::optional<double> fallback) {
  return number(key, range, fallback) / kMillimetersPerMeter;
}

Vector3 Quantities::vector_mm(const std::string& key, const Range& range,
                              std::optional<Vector3> fallback) {
  return vector(key, range, fallback) / kMillimetersPerMeter;
}

void Quantities::keep_order(const std::string& lower_key, double lower,
                            const std::string& upper_key, double upper) {
  if (!(lower <= upper)) {
    table_.note(lower_key, fmt::format(" = {}: must be <= {}, {}", lower, upper_key, upper));
    return;
  }
  const auto low = uncertain_.find(lower_key), high = uncertain_.find(upper_key);
  const Distribution* below = low == uncertain_.end() ? nullptr : &low->second.distribution;
  const Distribution* above = high == uncertain_.end() ? nullptr : &high->second.distribution;
  if (below == nullptr && above == nullptr) return;
  bool ordered = (below ? below->high() : lower) <= (above ? above->low() : upper);
  if (!ordered && below && above && moves_with(low->second.group, high->second.group)) {
    ordered = true;
    for (int i = 1; i < kOrderChecks; ++i) {
      const double p = static_cast<double>(i) / kOrderChecks;
      ordered = ordered && below->quantile(p) <= above->quantile(p);
    }
  }
  if (!ordered)
    table_.note(lower_key, fmt::format(": a draw could make it larger than {}: the bounds must be "
                                       "apart, or both in one group and in order",
                                       upper_key));
}

Quantities::Provenance Quantities::provenance(Table& quantity, const std::string& key) {
  const std::string source = quantity.text("source", "");
  Provenance found{quantity.text("assumption", ""), false, quantity.has("range")};
  found.given = !source.empty() || !found.reason.empty();
  if (!found.given && !quantity.has("distribution"))
    table_.note(key, ": must have a source, an assumption with its range, or both");
  return found;
}

void Quantities::note_outside(const std::string& key, const Uncertainty& uncertainty,
                              double value) {
  const Distribution& distribution = uncertainty.distribution;
  if (!distribution.contains(value))
    table_.note(key, fmt::format(": the value {:g} must be one that its distribution can give ({})",
                                 value, distribution.text()));
}

double Quantities::settle(const std::string& name, double value,
                          const std::optional<Uncertainty>& uncertainty, const Basis& basis) {
  const std::optional<Draw>& draw = table_.document().draw();
  const std::string path = table_.name_of(name), file = table_.document().path();
  if (uncertainty && draw) {
    const Distribution& distribution = uncertainty->distribution;
    const std::string variable = table_.document().variable_name(path);
    value = distribution.quantile(draw->probability(variable, uncertainty->group));
    assumptions_->push_back({draw->full_name(variable), "", value, distribution.low(),
                             distribution.high(), uncertainty->reason, file, distribution.text(),
                             draw->streams_of(variable, uncertainty->group)});
  } else if (!basis.reason.empty()) {
    assumptions_->push_back({path, "", value, basis.low, basis.high, basis.reason, file, ""});
  }
  return value;
}

void Quantities::choose(const std::string& key, const std::string& choice,
                        const std::string& reason) {
  if (reason.empty()) return;
  Assumption assumption;
  assumption.key = table_.name_of(key);
  assumption.choice = choice;
  assumption.reason = reason;
  assumption.file = table_.document().path();
  assumptions_->push_back(assumption);
}

}  // namespace gurney::equipment
