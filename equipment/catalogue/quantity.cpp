#include "equipment/catalogue/quantity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/units.h"

namespace gurney::equipment {

using config::Range;
using config::Table;

namespace {

constexpr std::array kAxes = {"x", "y", "z"};
constexpr int kOrderChecks = 1000;

/// A value that nothing but its distribution backs rests on that.
void rest_on_distribution(StatedQuantity& quantity) {
  quantity.reason = quantity.uncertainty->reason;
  quantity.low = quantity.uncertainty->distribution.low();
  quantity.high = quantity.uncertainty->distribution.high();
}

bool moves_with(const CorrelationGroup& a, const CorrelationGroup& b) {
  return !a.name.empty() && a.name == b.name && a.correlation == 1 && b.correlation == 1;
}

}  // namespace

StatedQuantity Quantities::number(const std::string& key, const Range& range,
                                  std::optional<double> fallback) {
  if (!table_.is_table(key)) return plain(key, table_.number(key, range, fallback), "");
  Table quantity = *table_.table(key);
  const std::size_t errors = table_.document().errors();
  const double value = quantity.number("value", range);
  const Provenance found = provenance(quantity, key);
  StatedQuantity stated = plain(key, value, "");
  stated.reason = found.reason;
  if (found.has_range || !found.reason.empty()) {
    const std::vector<double> ends = quantity.numbers("range", range, 2);
    stated.low = ends[0];
    stated.high = ends[1];
    if (table_.document().errors() == errors &&
        !(ends[0] <= value && value <= ends[1] && ends[0] < ends[1]))
      quantity.note("range",
                    fmt::format(" = [{}, {}]: must be [low, high] with low < high around {}",
                                ends[0], ends[1], value));
  }
  std::optional<Uncertainty> uncertainty;
  if (quantity.has("distribution")) uncertainty = read_uncertainty(quantity, "distribution", range);
  if (table_.document().errors() > errors || !uncertainty) return stated;
  stated.uncertainty = std::move(uncertainty);
  note_outside(key, *stated.uncertainty, value);
  if (!found.given) rest_on_distribution(stated);
  return stated;
}

std::array<StatedQuantity, 3> Quantities::vector(const std::string& key, const Range& range,
                                                 std::optional<Vector3> fallback) {
  std::optional<std::vector<double>> list;
  if (fallback) list = std::vector<double>(fallback->begin(), fallback->end());
  return components<3>(key, range, list);
}

std::array<StatedQuantity, 2> Quantities::plane(const std::string& key, const Range& range) {
  return components<2>(key, range, std::vector<double>{0, 0});
}

template <std::size_t size>
std::array<StatedQuantity, size> Quantities::components(
    const std::string& key, const Range& range, std::optional<std::vector<double>> fallback) {
  std::vector<StatedQuantity> list = read_components(key, range, size, std::move(fallback));
  std::array<StatedQuantity, size> result;
  std::move(list.begin(), list.end(), result.begin());
  return result;
}

std::vector<StatedQuantity> Quantities::read_components(
    const std::string& key, const Range& range, std::size_t size,
    std::optional<std::vector<double>> fallback) {
  std::vector<StatedQuantity> all;
  const auto add_plain = [&](const std::vector<double>& values) {
    for (std::size_t i = 0; i < size; ++i) all.push_back(plain(key, values[i], kAxes[i]));
  };
  if (!table_.is_table(key)) {
    add_plain(table_.numbers(key, range, size, fallback));
    return all;
  }
  Table quantity = *table_.table(key);
  const std::size_t errors = table_.document().errors();
  const std::vector<double> values = quantity.numbers("value", range, size);
  add_plain(values);
  const Provenance found = provenance(quantity, key);
  std::vector<double> low = values, high = values;
  if (!found.reason.empty()) {
    low = quantity.numbers("low", range, size);
    high = quantity.numbers("high", range, size);
    bool ordered = true;
    for (std::size_t i = 0; i < size; ++i)
      ordered = ordered && low[i] <= values[i] && values[i] <= high[i];
    if (table_.document().errors() == errors && !(ordered && low != high))
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
  if (table_.document().errors() > errors) return all;
  for (std::size_t i = 0; i < size; ++i) {
    all[i].reason = low[i] < high[i] ? found.reason : "";
    all[i].low = low[i];
    all[i].high = high[i];
    if (!uncertainty[i]) continue;
    all[i].uncertainty = std::move(uncertainty[i]);
    note_outside(key, *all[i].uncertainty, values[i]);
    if (!found.given) rest_on_distribution(all[i]);
  }
  return all;
}

StatedText Quantities::text(const std::string& key) {
  if (!table_.is_table(key)) return {table_.text(key)};
  Table quantity = *table_.table(key);
  const std::string value = quantity.text("value");
  if (quantity.has("distribution")) quantity.note("distribution", ": a text cannot be drawn");
  return {value, choice(key, value, provenance(quantity, key).reason)};
}

QuantityList Quantities::flag(const std::string& key, bool fallback) {
  const auto number = [](bool value) { return value ? 1.0 : 0.0; };
  if (!table_.is_table(key)) return plain(key, {number(table_.boolean(key, fallback))});
  Table quantity = *table_.table(key);
  return parts(key, quantity, Range::any(), {number(quantity.boolean("value"))}, {true}, true);
}

namespace {

/// An array of numbers where one for all would do.
std::vector<double> one_each(Table& table, const std::string& key, const Range& range,
                             std::size_t size) {
  std::vector<double> values = table.numbers(key, range, std::nullopt);
  if (values.size() != size)
    table.note(key, fmt::format(" = [{}]: must be an array of {} numbers, or one number for all",
                                fmt::join(values, ", "), size));
  values.resize(size);
  return values;
}

}  // namespace

QuantityList Quantities::numbers(const std::string& key, const Range& range,
                                 const std::vector<bool>& drawn) {
  const std::size_t size = drawn.size();
  if (table_.is_array(key)) return plain(key, one_each(table_, key, range, size));
  if (!table_.has(key)) return {};
  if (!table_.is_table(key))
    return plain(key, std::vector<double>(size, table_.number(key, range)));
  Table quantity = *table_.table(key);
  const std::vector<double> values =
      quantity.is_array("value") ? one_each(quantity, "value", range, size)
                                 : std::vector<double>(size, quantity.number("value", range));
  return parts(key, quantity, range, values, drawn, false);
}

QuantityList Quantities::flags(const std::string& key, const std::vector<bool>& drawn) {
  const std::size_t size = drawn.size();
  const auto numbers = [](const std::vector<bool>& flags) {
    return std::vector<double>(flags.begin(), flags.end());
  };
  if (table_.is_array(key)) return plain(key, numbers(table_.booleans(key, size)));
  if (!table_.has(key)) return {};
  if (!table_.is_table(key)) return plain(key, std::vector<double>(size, table_.boolean(key)));
  Table quantity = *table_.table(key);
  const std::vector<bool> flags = quantity.is_array("value")
                                      ? quantity.booleans("value", size)
                                      : std::vector<bool>(size, quantity.boolean("value"));
  return parts(key, quantity, Range::any(), numbers(flags), drawn, true);
}

bool Quantities::is_one_for_all(const std::string& key) {
  return !table_.is_array(key) && !(table_.is_table(key) && table_.table(key)->is_array("value"));
}

/// Parts of one quantity, each drawn by itself; what the values rest on is one entry for all.
QuantityList Quantities::parts(const std::string& key, Table& quantity, const Range& range,
                               const std::vector<double>& values, const std::vector<bool>& drawn,
                               bool flags) {
  const std::size_t errors = table_.document().errors();
  const Provenance found = provenance(quantity, key);
  std::optional<Uncertainty> uncertainty;
  if (quantity.has("distribution")) uncertainty = read_uncertainty(quantity, "distribution", range);
  QuantityList list = plain(key, values);
  if (table_.document().errors() > errors) return list;
  list.choice = choice(key, fmt::format("{}", fmt::join(values, ", ")),
                       found.given ? found.reason : uncertainty->reason);
  if (!uncertainty) return list;
  list.chosen_in_draws = false;
  const std::vector<double>& choices = uncertainty->distribution.values();
  const auto is_flag = [](double x) { return x == 0 || x == 1; };
  if (flags && !(choices.size() > 0 && std::all_of(choices.begin(), choices.end(), is_flag)))
    quantity.note("distribution", ": must be discrete, with the values 0 (false) and 1 (true)");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!drawn[i]) continue;
    if (table_.document().errors() == errors) note_outside(key, *uncertainty, values[i]);
    list.quantities[i].uncertainty = uncertainty;
  }
  return list;
}

StatedQuantity Quantities::length_mm(const std::string& key, const Range& range,
                                     std::optional<double> fallback) {
  StatedQuantity stated = number(key, range, fallback);
  stated.divisor = kMillimetersPerMeter;
  return stated;
}

std::array<StatedQuantity, 3> Quantities::vector_mm(const std::string& key, const Range& range) {
  std::array<StatedQuantity, 3> stated = vector(key, range);
  for (StatedQuantity& each : stated) each.divisor = kMillimetersPerMeter;
  return stated;
}

StatedQuantity Quantities::angle_deg(const std::string& key, const Range& range,
                                     std::optional<double> fallback) {
  StatedQuantity stated = number(key, range, fallback);
  stated.factor = kRadiansPerDegree;
  return stated;
}

void Quantities::keep_order(const std::string& lower_key, const StatedQuantity& lower,
                            const std::string& upper_key, const StatedQuantity& upper) {
  if (!(lower.value <= upper.value)) {
    table_.note(lower_key,
                fmt::format(" = {}: must be <= {}, {}", lower.value, upper_key, upper.value));
    return;
  }
  const auto& low = lower.uncertainty;
  const auto& high = upper.uncertainty;
  if (!low && !high) return;
  bool ordered = (low ? low->distribution.high() : lower.value) <=
                 (high ? high->distribution.low() : upper.value);
  if (!ordered && low && high && moves_with(low->group, high->group)) {
    ordered = true;
    for (int i = 1; i < kOrderChecks; ++i) {
      const double p = static_cast<double>(i) / kOrderChecks;
      ordered = ordered && low->distribution.quantile(p) <= high->distribution.quantile(p);
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

StatedQuantity Quantities::plain(const std::string& key, double value,
                                 const std::string& component) const {
  StatedQuantity stated{.value = value, .low = value, .high = value, .spot = table_.spot(key)};
  if (!component.empty()) stated.spot.name += '.' + component;
  return stated;
}

QuantityList Quantities::plain(const std::string& key, const std::vector<double>& values) const {
  QuantityList list;
  for (std::size_t i = 0; i < values.size(); ++i) {
    list.quantities.push_back(plain(key, values[i], ""));
    if (values.size() > 1) list.quantities.back().spot.name += fmt::format("[{}]", i);
  }
  return list;
}

Assumption Quantities::choice(const std::string& key, const std::string& text,
                              const std::string& reason) const {
  Assumption assumption;
  assumption.key = table_.name_of(key);
  assumption.choice = text;
  assumption.reason = reason;
  assumption.file = table_.spot(key).file;
  return assumption;
}

}  // namespace gurney::equipment
