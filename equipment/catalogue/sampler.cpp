#include "equipment/catalogue/sampler.h"

#include <fmt/format.h>

#include <utility>

#include "engine/base/diagnostics.h"

namespace gurney::equipment {

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
