#include "groundmotions/assembly/site.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// Band and instrument of a SEED channel code: "HN" of HNE.
std::string instrument_of(const std::string& name) {
  const std::string code = upper(name);
  const bool is_code =
      code.size() >= 3 && std::string_view("FGDCESHBML").find(code[0]) != std::string_view::npos &&
      std::string_view("NGLH").find(code[1]) != std::string_view::npos &&
      std::string_view("ENZ123").find(code[2]) != std::string_view::npos &&
      std::all_of(code.begin() + 3, code.end(), [](unsigned char c) { return std::isdigit(c); });
  return is_code ? code.substr(0, 2) + code.substr(3) : "";
}

/// Whether a place, as plain_words() writes it, is in or on a structure.
bool is_in_structure(const std::string& place) {
  constexpr std::array<std::string_view, 28> kPlaces = {
      "ROOF",      "FLOOR",     "FLR",    "STORY",   "STY",   "BASEMENT", "BSMT",
      "PENTHOUSE", "MEZZANINE", "DECK",   "GIRDER",  "BENT",  "PIER",     "ABUT",
      "ABUTMENT",  "CREST",     "SPAN",   "MIDSPAN", "TOWER", "COLUMN",   "WALL",
      "FOOTING",   "BUILDING",  "BRIDGE", "DAM",     "BLDG",  "GALLERY",  "STRUCTURE"};
  const std::string spaced = " " + place + " ";
  const auto has = [&](std::string_view word) {
    return spaced.find(" " + std::string(word) + " ") != std::string::npos;
  };
  if (has("FF") || has("FREEFIELD") || has("FREE FIELD")) return false;
  return std::ranges::any_of(kPlaces, has);
}

void append(std::string_view text, std::string& site) {
  if (text.empty()) return;
  if (!site.empty()) site += ", ";
  site += text;
}

}  // namespace

std::string fact_of(const Component& component, std::string_view name) {
  for (const auto& [key, value] : component.header)
    if (key == name) return value;
  return {};
}

std::string plain_words(std::string_view text) {
  std::string plain;
  for (const unsigned char c : text) {
    if (std::isalnum(c) || c >= 0x80)
      plain += static_cast<char>(std::toupper(c));
    else if (!plain.empty() && plain.back() != ' ')
      plain += ' ';
  }
  if (plain.ends_with(' ')) plain.pop_back();
  return plain;
}

std::string structure_of(const Component& component) {
  const std::string location = fact_of(component, "location");
  if (is_in_structure(plain_words(location))) return location;
  if (const std::string structure = fact_of(component, "structure"); !structure.empty())
    return structure;
  const std::string station = plain_words(fact_of(component, "station"));
  const bool has_storeys = (" " + station + " ").find(" STORY ") != std::string::npos;
  return has_storeys && location.empty() && is_in_structure(station) ? fact_of(component, "station")
                                                                     : "";
}

std::string site_of(const Component& component) {
  std::string site = plain_words(fact_of(component, "location"));
  if (site.empty()) site = plain_words(fact_of(component, "recorder"));
  append(plain_words(fact_of(component, "sensor")), site);
  append(instrument_of(component.name), site);
  return site;
}

}  // namespace gurney::groundmotions
