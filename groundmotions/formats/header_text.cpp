#include "groundmotions/formats/header_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

using Words = std::vector<std::string_view>;

/// Velocities and displacements that are no samples.
bool is_of_something_else(const Words& words, std::size_t i) {
  constexpr std::string_view kBefore =
      "WAVE SHEAR S-WAVE P-WAVE S P GROUP PHASE PEAK MAX MAXIMUM RUPTURE FAULT RESIDUAL SAMPLING "
      "PERMANENT";
  return (i > 0 && is_one_of(words[i - 1], kBefore)) ||
         (i + 1 < words.size() && is_one_of(words[i + 1], "MODEL PROFILE STRUCTURE PULSE"));
}

bool speaks_of_peaks(std::string_view line) {
  return std::ranges::any_of(words_of("PEAK PGA PGV PGD MAX MIN MAXIMUM MINIMUM", " "),
                             [&](auto word) { return find_word(line, word) != kNone; });
}

/// A unit of acceleration that up to four words at the start of `text` make: "cm / s2".
std::optional<std::string_view> unit_at_start(std::string_view text) {
  const auto words = words_of(text, " \t");
  for (std::size_t count = std::min<std::size_t>(words.size(), 4); count > 0; --count) {
    const auto end =
        static_cast<std::size_t>(words[count - 1].data() - text.data()) + words[count - 1].size();
    if (acceleration_unit(text.substr(0, end))) return text.substr(0, end);
  }
  return {};
}

/// Text that follows the word `unit`: "OF G. FILTER...", "(g)", ": cm / s2", "= SEC AND G".
std::optional<std::string_view> behind_unit(std::string_view rest) {
  for (bool again = true; again;) {
    rest = left_trimmed(rest, " \t(=:[-");
    rest = rest.substr(0, rest.find_first_of(",;"));
    if (const auto unit = unit_at_start(rest)) return unit;  // "in / s2"
    again = false;
    for (const std::string_view filler : {"OF ", "ARE ", "IS ", "IN ", "ACCELERATION"})
      if (rest.starts_with(filler)) {
        rest.remove_prefix(filler.size());
        again = true;
      }
  }
  for (const auto word : words_of(rest, " \t()[]"))  // "gal(cm/s/s)"
    if (acceleration_unit(word)) return word;
  const auto words = words_of(rest, " \t");
  if (words.empty() || time_unit(words[0])) return {};
  return words[0];
}

/// Whether a value follows: "Vs30 (m/s): 379".
bool is_of_a_value(std::string_view behind) {
  behind = left_trimmed(behind, " \t)].");
  if (behind.empty() || (behind[0] != ':' && behind[0] != '=')) return false;
  auto rest = trimmed(behind.substr(1));
  return take_number(rest).has_value();
}

/// A unit of several words: "CM / S2", "M S-2", "CM PER SEC SQUARED", "% OF G"; else empty.
std::string_view unit_of_words(std::string_view line, const Words& words, std::size_t i) {
  constexpr std::size_t kMost = 5;
  const auto begin = static_cast<std::size_t>(words[i].data() - line.data());
  for (std::size_t k = std::min(words.size(), i + kMost) - 1; k > i; --k) {
    const auto end = static_cast<std::size_t>(words[k].data() - line.data()) + words[k].size();
    const auto text = line.substr(begin, end - begin);
    // Blanks drop out of a unit: "M G" is no "MG".
    const bool is_compound = text.find_first_of("/%2") != kNone || text.find("PER") != kNone;
    if (is_compound && text.find(',') == kNone && acceleration_unit(text)) return text;
  }
  return {};
}

/// Whether a lone "g" or "mg" is a unit by the words beside it: "ACCELERATION, G", "UNITS G",
/// "FRACTION OF G", or nothing at all.
bool is_lone_unit(const Words& words, std::size_t i) {
  constexpr std::string_view kShares =
      "FRACTION FRACTIONS TERMS UNIT UNITS MULTIPLE MULTIPLES PARTS";
  std::size_t before = i;
  while (before > 0 && words[before - 1].find_first_not_of("-_/|#%*") == kNone) --before;
  if (before == 0) return i + 1 == words.size() || is_one_of(words[i + 1], kShares);
  const auto word = words[before - 1];
  if (word == "OF") return before > 1 && is_one_of(words[before - 2], kShares);
  return word.starts_with("ACC") || is_one_of(word, kShares);
}

/// "in cm/s", "(g)", "[m/s2]" and words such as "cm/sec/sec" and "gal" that are nothing else.
/// Lengths are left out: "in" and "m" measure depths and distances.
std::optional<std::string_view> unit_elsewhere(std::string_view line) {
  const auto words = words_of(line, " \t,;:=");
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto word = words[i];
    // "ACC(GAL)"
    if (const auto open = word.find_first_of("(["); open != kNone) word.remove_prefix(open);
    if (const auto compound = unit_of_words(line, words, i); !compound.empty()) word = compound;
    const auto end = static_cast<std::size_t>(word.data() - line.data()) + word.size();
    const bool in_brackets = std::string_view("([").find(word[0]) != kNone &&
                             std::string_view(")]").find(word.back()) != kNone;
    const bool after_in = i > 0 && words[i - 1] == "IN";
    const bool after_number = i > 0 && number(words[i - 1]).has_value();
    if (after_number || is_of_a_value(line.substr(end))) continue;
    const bool is_short = plain_unit(word) == "g" || plain_unit(word) == "mg";
    if (acceleration_unit(word) && (in_brackets || after_in || !is_short || is_lone_unit(words, i)))
      return word;
    if ((in_brackets || after_in) && other_quantity(word) == "velocity") return word;
  }
  return {};
}

/// Behind the key: "(SEC) = 0.02 SEC", "IS 5 ms", ": .005".
std::optional<double> keyed(std::string_view rest, bool is_rate) {
  constexpr std::string_view kBetween = " \t=:,";
  std::string_view unit;
  const auto skip = [&] { rest = left_trimmed(rest, kBetween); };
  skip();
  if (rest.starts_with('(') || rest.starts_with('[')) {
    unit = in_brackets(rest);
    rest.remove_prefix(std::min(rest.find_first_of(")]"), rest.size() - 1) + 1);
  }
  skip();
  for (const std::string_view filler : {"OF ", "IS "})
    if (rest.starts_with(filler)) rest.remove_prefix(filler.size());
  skip();
  const auto value = take_number(rest);
  if (!value || !(*value > 0)) return {};
  if (unit.empty()) unit = trimmed(rest).substr(0, trimmed(rest).find_first_of(" \t,;)"));
  const auto seconds = time_unit(unit);
  if (seconds) return *value * *seconds;
  unit = left_trimmed(unit, "([");
  const bool is_per_second =
      unit.starts_with("HZ") || unit.starts_with("SPS") || unit.find("/S") != kNone;
  // "Sampling rate: 0.01" is a step.
  return (is_rate && *value > 1) || is_per_second ? 1 / *value : *value;
}

}  // namespace

std::optional<std::string_view> quantity_in(std::string_view text) {
  const std::string line = upper(text);
  const auto words = words_of(line, " \t,;:()[]=.#%*\"");
  const auto acceleration = [](std::string_view word) {
    return word == "ACC" ||
           begins_with_one_of(word, "ACCEL ACELER ACC\xc3\xa9L BESCHLEUNIG IVME \xc4\xb0VME");
  };
  if (std::ranges::any_of(words, acceleration)) return "acceleration";
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool velocity =
        words[i] == "VEL" || begins_with_one_of(words[i], "VELOC VITESSE GESCHWINDIG");
    const bool displacement =
        is_one_of(words[i], "DISP DESP") ||
        begins_with_one_of(words[i], "DISPL DESPL SPOST VERSCHIEB DEPLAC D\xc3\xa9PLAC");
    if ((velocity || displacement) && !is_of_something_else(words, i))
      return velocity ? "velocity" : "displacement";
  }
  return {};
}

std::optional<OtherQuantity> other_quantity_in(const std::vector<std::string_view>& lines) {
  constexpr std::string_view kAcceleration = "acceleration";
  std::optional<OtherQuantity> first;
  bool any_acceleration = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto quantity = quantity_in(lines[i]);
    if (!quantity) continue;
    const auto words = words_of(lines[i], "#%* \t([:,");
    if (const auto start = quantity_in(words[0]))
      return *start == kAcceleration ? std::nullopt : std::optional(OtherQuantity{i, *start});
    any_acceleration = any_acceleration || *quantity == kAcceleration;
    if (*quantity != kAcceleration && !first) first = OtherQuantity{i, *quantity};
  }
  return any_acceleration ? std::nullopt : first;
}

std::optional<std::string_view> unit_text_in(std::string_view text) {
  const std::string line = upper(text);
  std::optional<std::string_view> found;
  for (const std::string_view key : {"UNITS", "UNIT", "UNIDADES", "UNIDAD", "UNIT\xc3\xa0",
                                     "UNIT\xc3\xa9", "UNITE", "EINHEIT", "BIRIM"})
    if (const auto at = find_word(line, key); !found && at != kNone) {
      const auto rest = std::string_view(line).substr(at + key.size());
      const auto next = left_trimmed(rest, " \t");
      const auto word = next.substr(0, next.find_first_of(" \t,;"));
      const bool is_statement =
          (!next.empty() && std::string_view(":=([-").find(next[0]) != kNone) ||
          is_one_of(word, "OF ARE IS IN") || acceleration_unit(word);
      if (is_statement) found = behind_unit(rest);
    }
  if (!found && !speaks_of_peaks(line)) found = unit_elsewhere(line);
  if (!found) return {};
  const auto begin = static_cast<std::size_t>(found->data() - line.data());
  auto unit = text.substr(begin, found->size());
  unit = left_trimmed(unit, "([");
  return unit.substr(0, unit.find_last_not_of("]).") + 1);
}

std::optional<double> time_step_in(std::string_view text) {
  const std::string line = upper(text);
  for (const std::string_view key :
       {"DT", "TIME STEP", "TIMESTEP", "TIME INTERVAL", "TIME INCREMENT", "SAMPLING INTERVAL",
        "SAMPLE INTERVAL", "SAMPLING PERIOD", "SAMPLING TIME", "SPACING OF", "EQUALLY SPACED AT",
        "INTERVALS OF", "DELTA T", "DELTAT", "INTERVALO DE MUESTREO", "INTERVALO DE TIEMPO",
        "PASO DE TIEMPO", "PASSO TEMPORALE"})
    if (const auto at = find_word(line, key); at != kNone)
      if (const auto step = keyed(std::string_view(line).substr(at + key.size()), false))
        return step;
  for (const std::string_view key :
       {"SAMPLING RATE", "SAMPLE RATE", "SAMPLING FREQUENCY", "SAMPLING FREQ", "SAMPLING FREQ.",
        "FRECUENCIA DE MUESTREO", "TASA DE MUESTREO", "MUESTREO", "FREQUENZA DI CAMPIONAMENTO"})
    if (const auto at = find_word(line, key); at != kNone)
      if (const auto step = keyed(std::string_view(line).substr(at + key.size()), true))
        return step;
  for (const std::string_view key : {"SAMPLES PER SECOND", "SAMPLES/SEC", "SAMPLES/S", "SPS",
                                     "POINTS PER SECOND", "MUESTRAS/S", "MUESTRAS/SEGUNDO"}) {
    const auto at = find_word(line, key);
    if (at == kNone) continue;
    const auto words = words_of(std::string_view(line).substr(0, at), " \t,;:=(");
    const auto rate = words.empty() ? std::nullopt : number(words.back());
    if (rate && *rate > 0) return 1 / *rate;
    if (const auto step = keyed(std::string_view(line).substr(at + key.size()), true)) return step;
  }
  return {};
}

std::optional<double> count_in(std::string_view text) {
  const std::string line = upper(text);
  for (const std::string_view key :
       {"NPTS", "NDATA", "NO. OF POINTS", "NO. OF SAMPLES", "NO. OF DATA", "NO OF POINTS",
        "NUMBER OF POINTS", "NUMBER OF SAMPLES", "NUMBER OF DATA", "NUMBER OF DATA POINTS",
        "NUMERO DE MUESTRAS", "N\xc3\xbaMERO DE MUESTRAS"}) {
    const auto at = find_word(line, key);
    if (at == kNone) continue;
    const auto count = number_after(std::string_view(line).substr(at), key);
    if (count && *count >= 2 && *count == std::floor(*count)) return count;
  }
  return {};
}

std::string component_in(std::string_view text) {
  constexpr std::string_view kBlanks = " \t,;:=()[]";
  const std::string line = upper(text);
  for (const std::string_view key :
       {"COMPONENT", "COMPONENTE", "COMP", "COMP.", "DIRECTION", "DIRECCION", "DIR", "DIR.",
        "ORIENTATION", "ORIENTACION", "CHANNEL", "CANAL", "STREAM"}) {
    const auto at = find_word(line, key);
    if (at == kNone) continue;
    const auto behind = words_of(std::string_view(line).substr(at + key.size()), kBlanks);
    const auto before = words_of(std::string_view(line).substr(0, at), kBlanks);
    const std::size_t count = before.size();
    std::vector<std::string> names;  // two words first: "NORTH SOUTH"
    if (behind.size() > 1) names.push_back(fmt::format("{}-{}", behind[0], behind[1]));
    if (!behind.empty()) names.emplace_back(behind[0]);
    if (count > 1) names.push_back(fmt::format("{}-{}", before[count - 2], before[count - 1]));
    if (count > 0 && before.back().size() > 1) names.emplace_back(before.back());
    const auto name = std::ranges::find_if(names, says_direction);
    if (name != names.end()) return *name;
  }
  // "Acceleration (VERTICAL)"
  for (auto at = line.find_first_of("(["); at != kNone; at = line.find_first_of("([", at + 1)) {
    const auto word = in_brackets(std::string_view(line).substr(at));
    if (word.size() > 1 && is_letter(word[0]) && says_direction(word)) return std::string(word);
  }
  return {};
}

std::optional<double> factor_in(std::string_view text) {
  const std::string line = upper(text);
  for (const std::string_view key : {"SCALE FACTOR", "SCALING FACTOR", "SCALE", "CONVERSION FACTOR",
                                     "FACTOR DE ESCALA", "FACTOR", "MULTIPLY BY", "MULTIPLIED BY"})
    if (const auto at = find_word(line, key); at != kNone) {
      const auto factor = number_after(std::string_view(line).substr(at), key);
      if (factor && *factor != 1 && *factor != 0) return factor;
    }
  return {};
}

std::optional<double> time_unit_in(std::string_view text) {
  const std::string line = upper(text);
  const auto at = find_word(line, "TIME");
  if (at == kNone) return {};
  const auto rest = trimmed(std::string_view(line).substr(at + 4));
  if (rest.starts_with('(') || rest.starts_with('[')) return time_unit(in_brackets(rest));
  return rest.starts_with("IN ") ? time_unit(rest.substr(3, rest.find_first_of(" \t,;:", 3) - 3))
                                 : std::nullopt;
}

std::optional<double> leading_time(std::string_view text) {
  const auto value = take_number(text);
  if (!value) return {};
  text = trimmed(text);
  const auto unit = time_unit(text.substr(0, text.find_first_of(" \t,;)")));
  return *value * unit.value_or(1);
}

}  // namespace gurney::groundmotions
