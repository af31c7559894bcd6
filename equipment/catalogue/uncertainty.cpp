#include "equipment/catalogue/uncertainty.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "engine/base/diagnostics.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;

constexpr double kInfinity = Distribution::kInfinity;

Distribution read_normal(Table& in) {
  const double mean = in.number("mean", Range::any());
  if (in.has("sd") == in.has("cov"))
    in.note("sd", ": must be given, or cov (sd over |mean|), not both");
  const double sd = in.has("cov") ? in.number("cov", Range::positive()) * std::abs(mean)
                                  : in.number("sd", Range::positive(), 1.0);
  const double low = in.number("low", Range::any(), -kInfinity);
  const double high = in.number("high", Range::any(), kInfinity);
  return Distribution::normal(mean, sd, low, high);
}

Distribution read_lognormal(Table& in) {
  const double median = in.number("median", Range::positive());
  const double beta = in.number("beta", Range::positive());
  const double low = in.number("low", Range::not_negative(), 0.0);
  const double high = in.number("high", Range::positive(), kInfinity);
  return Distribution::lognormal(median, beta, low, high);
}

Distribution read_uniform(Table& in) {
  const double low = in.number("low", Range::any());
  return Distribution::uniform(low, in.number("high", Range::any()));
}

Distribution read_discrete(Table& in) {
  std::vector<double> values = in.numbers("values", Range::any());
  return Distribution::discrete(std::move(values), in.numbers("probabilities", Range::positive()));
}

Distribution read_table(Table& in) {
  if (in.has("samples") == in.has("values"))
    in.note("values", ": must be given with cumulative, or samples, not both");
  if (in.has("samples")) return Distribution::samples(in.numbers("samples", Range::any()));
  std::vector<double> values = in.numbers("values", Range::any());
  return Distribution::table(std::move(values), in.numbers("cumulative", Range::within(0, 1)));
}

CorrelationGroup read_group(Table& in) {
  CorrelationGroup group;
  group.name = in.text("group", "");
  if (in.has("group") && group.name.empty()) in.note("group", ": must have a name");
  group.correlation = in.number("correlation", Range::within(-1, 1), 1.0);
  if (in.has("correlation") && !in.has("group"))
    in.note("correlation", ": needs the group it is with");
  return group;
}

bool stays_within(const Distribution& distribution, const Range& range) {
  if (distribution.values().empty())
    return range.contains_between(distribution.low(), distribution.high());
  for (const double value : distribution.values())
    if (!range.contains(value)) return false;
  return true;
}

}  // namespace

std::optional<Uncertainty> read_uncertainty(Table& parent, const std::string& key,
                                            const Range& range) {
  using Reader = Distribution (*)(Table&);
  static const std::vector<std::string> kKinds = {"normal", "lognormal", "uniform", "discrete",
                                                  "table"};
  static constexpr std::array<Reader, 5> kReaders = {read_normal, read_lognormal, read_uniform,
                                                     read_discrete, read_table};
  std::optional<Table> found = parent.table(key);
  if (!found) return {};
  Table& in = *found;
  const config::Document& document = in.document();
  const std::size_t before = document.errors();
  const std::size_t kind = in.choice("kind", kKinds);
  if (document.errors() > before) {
    for (const std::string& each : in.keys()) in.has(each);  // whose they are is not known
    return {};
  }
  CorrelationGroup group = read_group(in);
  const std::string source = in.text("source", ""), reason = in.text("assumption", "");
  if (source.empty() && reason.empty())
    parent.note(key, ": must have a source, an assumption, or both");
  const std::size_t before_numbers = document.errors();
  const auto numbers_are_right = [&] { return document.errors() == before_numbers; };
  try {
    Distribution distribution = kReaders[kind](in);
    if (numbers_are_right() && !stays_within(distribution, range))
      parent.note(key, fmt::format(": {} gives numbers from {:g} to {:g}: each must be {}",
                                   distribution.text(), distribution.low(), distribution.high(),
                                   range.text()));
    if (document.errors() == before)
      return Uncertainty{std::move(distribution), std::move(group), reason};
  } catch (const Error& error) {
    if (numbers_are_right()) parent.note(key, std::string(": ") + error.what());
  }
  return {};
}

std::string unit_of_key(const std::string& key) {
  struct Unit {
    const char* ending;
    const char* unit;
  };
  // An ending stands before those it ends with.
  static constexpr std::array<Unit, 16> kUnits = {{{"_n_m_s_per_rad", "N m s/rad"},
                                                   {"_n_s_per_m", "N s/m"},
                                                   {"_n_per_m", "N/m"},
                                                   {"_m_per_s2", "m/s2"},
                                                   {"_m_per_s", "m/s"},
                                                   {"_deg_per_s", "deg/s"},
                                                   {"_kg_m2", "kg m2"},
                                                   {"_n_m", "N m"},
                                                   {"_mm", "mm"},
                                                   {"_kg", "kg"},
                                                   {"_hz", "Hz"},
                                                   {"_deg", "deg"},
                                                   {"_m", "m"},
                                                   {"_s", "s"},
                                                   {"_n", "N"},
                                                   {"_j", "J"}}};
  std::string name = key;
  if (name.ends_with(']')) name.erase(name.rfind('['));
  if (name.size() > 2 && name[name.size() - 2] == '.') name.erase(name.size() - 2);  // an axis
  for (const Unit& each : kUnits)
    if (name.ends_with(each.ending)) return each.unit;
  return "1";
}

void SampleErrors::add(const config::Spot& spot, const std::string& message) {
  entries_.push_back({spot, message});
}

void SampleErrors::add(const Error& error) { entries_.push_back({{}, error.what()}); }

void SampleErrors::note_in(config::Document& document) const {
  for (const Entry& each : entries_)
    if (each.spot)
      document.note(*each.spot, each.message);
    else
      document.note(Error(each.message));
}

void SampleErrors::raise() const {
  Diagnostics errors;
  for (const auto& [spot, message] : entries_)
    if (spot)
      errors.add(spot->place.line, spot->place.column, spot->where + ": " + spot->name + message);
    else
      errors.add(message);
  errors.sort();
  errors.raise();
}

Sampler::Sampler(std::vector<Assumption>& list, SampleErrors& errors, std::optional<Draw> draw)
    : list_(&list), errors_(&errors), draw_(std::move(draw)) {}

double Sampler::operator()(const StatedQuantity& quantity) {
  const double value = in_unit(quantity);
  const std::string& name = quantity.spot.name;
  if (draw_ && quantity.uncertainty) {
    const auto& [distribution, group, reason] = *quantity.uncertainty;
    list_->push_back({draw_->full_name(variable(name)), "", value, distribution.low(),
                      distribution.high(), reason, quantity.spot.file, distribution.text(),
                      draw_->streams_of(variable(name), group)});
  } else if (!quantity.reason.empty()) {
    list_->push_back(
        {name, "", value, quantity.low, quantity.high, quantity.reason, quantity.spot.file, ""});
  }
  return quantity.si(value);
}

Vector3 Sampler::operator()(const std::array<StatedQuantity, 3>& components) {
  Vector3 vector;
  for (int i = 0; i < 3; ++i) vector[i] = (*this)(components[static_cast<std::size_t>(i)]);
  return vector;
}

std::vector<double> Sampler::operator()(const QuantityList& list) {
  if (list.chosen_in_draws || !draw_) note(list.choice);
  std::vector<double> values;
  for (const StatedQuantity& each : list.quantities) values.push_back((*this)(each));
  return values;
}

void Sampler::note(const Assumption& choice) {
  if (!choice.reason.empty()) list_->push_back(choice);
}

Sampler Sampler::of_part(const std::string& part) const {
  Sampler sampler = *this;
  if (draw_) sampler.draw_ = draw_->of_part(part);
  return sampler;
}

Sampler Sampler::of_element(const std::string& element, const std::string& part) const {
  Sampler sampler = of_part(part);
  sampler.element_ = element;
  return sampler;
}

Sampler Sampler::into(std::vector<Assumption>& list) const {
  Sampler sampler = *this;
  sampler.list_ = &list;
  return sampler;
}

void Sampler::error(const config::Spot& spot, const std::string& message) {
  errors_->add(spot, message);
}

void Sampler::error(const Error& error) { errors_->add(error); }

void Sampler::check_drawn(const StatedQuantity& quantity, const config::Range& range) {
  const double value = in_unit(quantity);
  if (draw_ && !range.contains(value))
    error(quantity.spot, fmt::format(" = {}: must be {}", value, range.text()));
}

std::string Sampler::variable(const std::string& name) const {
  if (element_.empty() || !name.starts_with(element_ + '.')) return name;
  return element_.substr(0, element_.rfind('[')) + name.substr(element_.size());
}

double Sampler::in_unit(const StatedQuantity& quantity) const {
  if (!draw_ || !quantity.uncertainty) return quantity.value;
  const auto& [distribution, group, reason] = *quantity.uncertainty;
  return distribution.quantile(draw_->probability(variable(quantity.spot.name), group));
}

}  // namespace gurney::equipment
