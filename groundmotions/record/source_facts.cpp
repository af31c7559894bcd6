#include "groundmotions/record/source_facts.h"

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/base/number_text.h"

namespace gurney::groundmotions {
namespace {

constexpr double kMetresPerKilometre = 1000;

/// The first number in a text: 7.1 of "Moment Mag=      7.1 Ms=      7.0", 6 of "6.0 Mw".
std::optional<double> first_number(const std::string& text) {
  std::size_t at = text.find_first_of("0123456789");
  if (at == std::string::npos) return {};
  if (at > 0 && text[at - 1] == '.') --at;
  if (at > 0 && text[at - 1] == '-') --at;
  std::string_view rest = std::string_view(text).substr(at);
  return take_number(rest);
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

/// The first of the names that a source states, of the first source that states one.
std::string stated_text(const std::vector<NamedFacts>& sources,
                        std::initializer_list<const char*> names) {
  for (const NamedFacts& facts : sources)
    for (const char* name : names)
      for (const auto& [key, text] : facts)
        if (key == name && !text.empty()) return text;
  return {};
}

/// Cuts off what a GeoNet file states of a record in the lines of its event and its station.
void cut_record(SourceFacts& facts) {
  for (const auto& [text, word] :
       {std::pair(&facts.event, "  Bearing "), std::pair(&facts.station, "  Cusp file:")})
    if (const auto at = text->find(word); at != std::string::npos) text->resize(at);
}

/// Cuts the line of a PEER file behind the field with the date. The last field is the component.
void split_event(SourceFacts& facts) {
  const std::string line = facts.event;
  const auto slash = line.find('/');
  if (slash == std::string::npos || line.find('/', slash + 1) == std::string::npos) return;
  const auto date_end = line.find(',', slash), last = line.rfind(',');
  if (date_end == std::string::npos) return;
  facts.event = line.substr(0, date_end);
  const auto start = line.find_first_not_of(" ,", date_end);
  if (facts.station.empty() && start < last) facts.station = line.substr(start, last - start);
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
  constexpr double kHighest = 1000;
  if (const auto value = stated(sources, "lowest usable frequency [Hz]", 0, kHighest))
    facts.lowest_frequency = *value;
  facts.event = stated_text(
      sources, {"event id", "event", "event time", "event date", "origin time (Japan)"});
  facts.station = stated_text(sources, {"station", "station name", "station code"});
  cut_record(facts);
  split_event(facts);
  return facts;
}

}  // namespace gurney::groundmotions
