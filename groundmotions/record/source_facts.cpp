#include "groundmotions/record/source_facts.h"

#include <charconv>
#include <optional>

namespace gurney::groundmotions {
namespace {

constexpr double kMetresPerKilometre = 1000;

/// The first number in a text: 7.1 of "Moment Mag=      7.1 Ms=      7.0", 6 of "6.0 Mw".
std::optional<double> first_number(const std::string& text) {
  std::size_t at = text.find_first_of("0123456789");
  if (at == std::string::npos) return {};
  if (at > 0 && text[at - 1] == '.') --at;
  if (at > 0 && text[at - 1] == '-') --at;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  if (error != std::errc()) return {};
  return value;
}

/// The first of the sources that states one of the names, with a number in (low, high).
std::optional<double> stated(const std::vector<NamedFacts>& sources, const char* name, double low,
                             double high) {
  for (const NamedFacts& facts : sources)
    for (const auto& [key, text] : facts) {
      if (key != name) continue;
      const std::optional<double> value = first_number(text);
      if (value && *value > low && *value < high) return value;
    }
  return {};
}

}  // namespace

SourceFacts source_facts(const std::vector<NamedFacts>& sources) {
  constexpr double kLargestMagnitude = 11, kFarthest = 20040, kFastest = 10000;
  constexpr std::pair<const char*, const char*> kDistances[] = {
      {"R_rup [km]", "Rrup"},
      {"R_JB [km]", "Rjb"},
      {"epicentral distance [km]", "epicentral"},
      {"distance [km]", "not stated"}};
  SourceFacts facts;
  for (const char* name : {"magnitude Mw", "magnitude", "magnitude ML"})
    if (const auto value = stated(sources, name, 0, kLargestMagnitude)) {
      facts.magnitude = *value;
      break;
    }
  for (const auto& [name, kind] : kDistances)
    if (const auto value = stated(sources, name, -1e-9, kFarthest)) {
      facts.distance = *value * kMetresPerKilometre;
      facts.distance_kind = kind;
      break;
    }
  for (const char* name : {"Vs30 [m/s]", "vs30 [m/s]"})
    if (const auto value = stated(sources, name, 0, kFastest)) {
      facts.vs30 = *value;
      break;
    }
  return facts;
}

}  // namespace gurney::groundmotions
