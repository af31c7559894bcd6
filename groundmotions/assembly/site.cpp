#include "groundmotions/assembly/site.h"

#include <algorithm>
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

std::string site_of(const Component& component) {
  std::string site = plain_words(fact_of(component, "location"));
  if (site.empty()) site = plain_words(fact_of(component, "recorder"));
  append(plain_words(fact_of(component, "sensor")), site);
  append(instrument_of(component.name), site);
  return site;
}

}  // namespace gurney::groundmotions
