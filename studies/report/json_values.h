#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace gurney::report {

/// JSON has no NaN and no infinity: they are null.
inline nlohmann::ordered_json json_number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

inline nlohmann::ordered_json json_interval(double low, double high) {
  return nlohmann::ordered_json::array({json_number(low), json_number(high)});
}

/// @param of    with ends `low` and `high`
/// @param unit  to write them in
template <class Ends>
nlohmann::ordered_json json_interval(const Ends& of, double unit = 1) {
  return json_interval(of.low / unit, of.high / unit);
}

}  // namespace gurney::report
