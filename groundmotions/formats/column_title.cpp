#include "groundmotions/formats/column_title.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

struct QuantityWords {
  std::string_view name;
  std::string_view words;  ///< in lower case, blanks part them
};

/// Starts of words for columns of laboratories and of other programs that are no accelerations.
constexpr QuantityWords kQuantities[] = {
    {"velocity", "vel"},         {"displacement", "disp lvdt"},
    {"voltage", "volt"},         {"force", "force load"},
    {"strain", "strain"},        {"stress", "stress"},
    {"pressure", "press"},       {"temperature", "temperat"},
    {"humidity", "humid"},       {"rotation", "gyro rotation tilt angle"},
    {"moment", "moment torque"}, {"intensity", "arias husid intens"},
    {"energy", "energy"},        {"jerk", "jerk"}};

constexpr QuantityWords kUnits[] = {{"voltage", "v mv volt volts"},
                                    {"force", "kn lbf lb lbs kip kips kgf"},
                                    {"pressure", "pa kpa mpa psi ksi"},
                                    {"rotation", "rad rad/s deg deg/s \xc2\xb0 \xc2\xb0/s"},
                                    {"temperature",
                                     "degc \xc2\xb0"
                                     "c"},
                                    {"strain", "strain ustrain microstrain"},
                                    {"frequency", "hz"},
                                    {"jerk", "m/s3 g/s"},
                                    {"energy", "m2/s3"}};

/// The quantity of a column that is no acceleration by its name or unit; empty if neither says it.
std::string foreign_quantity(std::string_view name, std::string_view unit) {
  const std::string plain = plain_unit(unit), text = lower(name);
  for (const auto& [quantity, spellings] : kUnits)
    if (is_one_of(plain, spellings)) return std::string(quantity);
  if (time_unit(unit)) return "time";
  for (const auto word : words_of(text, " \t,;:.-_/#*"))
    for (const auto& [quantity, starts] : kQuantities)
      if (begins_with_one_of(word, starts)) return std::string(quantity);
  return {};
}

bool is_unit(std::string_view text) {
  return acceleration_unit(text) || other_quantity(text) || time_unit(text);
}

/// A direction, a label or a number of degrees.
bool may_be_direction(std::string_view text) {
  Component component;
  component.acceleration = Eigen::Vector2d::Zero();
  return says_direction(text) || orient_by_label(text, component) || number(text);
}

/// Two known units contradict each other: their sum is none.
void add_unit(std::string_view unit, ColumnTitle& title) {
  if (title.unit.empty() || !is_unit(title.unit))
    title.unit = unit;
  else if (is_unit(unit) && plain_unit(unit) != plain_unit(title.unit))
    title.unit += fmt::format(" and {}", unit);
}

void take_brackets(ColumnTitle& title) {
  std::string_view rest = title.text;
  for (auto open = rest.find_first_of("(["); open != kNone; open = rest.find_first_of("([")) {
    title.name += rest.substr(0, open);
    rest.remove_prefix(open);
    const auto content = in_brackets(rest);
    rest.remove_prefix(std::min(rest.find_first_of(")]"), rest.size() - 1) + 1);
    // "Acc (V)" is a vertical, "CH1 (V)" and "Voltage (V)" are volts.
    const bool is_volt =
        content == "V" && !title.name.empty() && quantity_in(title.name) != "acceleration";
    if (!is_unit(content) && !is_volt && may_be_direction(content))
      title.direction = content;
    else
      add_unit(content, title);
    if (title.factor.empty() && is_unit(content)) title.factor = factor_behind(rest);
  }
  title.name += rest;
  title.name = trimmed(title.name);
}

/// `acc_g`, `x_m_per_s2`, `time_ms`, `acc/g`.
void take_suffix(ColumnTitle& title) {
  if (says_direction(title.name)) return;  // "N_S"
  for (auto at = title.name.find('_'); at != kNone; at = title.name.find('_', at + 1)) {
    if (at == 0 || !is_unit(title.name.substr(at + 1))) continue;
    title.unit = title.name.substr(at + 1);
    title.name.resize(at);
  }
  const std::string name = lower(title.name);
  if (title.unit.empty() && name.ends_with("/g") && (name[0] == 'a')) {
    title.unit = "g";
    title.name.resize(name.size() - 2);
  }
}

/// `Acceleration in g`, `Acceleration, m/s2`, `NS cm/s2`, or a unit alone.
void take_last_words(ColumnTitle& title) {
  const auto words = words_of(title.name, " \t,;:");
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto begin = static_cast<std::size_t>(words[i].data() - title.name.data());
    const auto unit = trimmed(std::string_view(title.name).substr(begin));
    const bool is_known = acceleration_unit(unit) || other_quantity(unit) || time_unit(unit);
    if (!is_known || unit.find(',') != kNone) continue;
    const bool behind_in = i > 0 && lower(words[i - 1]) == "in";
    const bool has_comma = i > 0 && title.name.find_first_of(",;:", begin - 1) == begin - 1;
    // "G" and "M" may be the name of a channel.
    const bool is_sure = unit == "g" || unit.size() > 1;
    const bool is_quantity =
        i > 0 && quantity_in(std::string_view(title.name).substr(0, begin)).has_value();
    if (i == 0 && unit.size() == 1 && lower(unit) != unit) continue;
    if (i > 0 && !behind_in && !has_comma && !is_sure && !is_quantity) continue;
    title.unit = unit;
    auto rest = std::string_view(title.name).substr(0, begin);
    if (behind_in)
      rest = rest.substr(0, static_cast<std::size_t>(words[i - 1].data() - rest.data()));
    const auto end = rest.find_last_not_of(" \t,;:");
    title.name = std::string(rest.substr(0, end == kNone ? 0 : end + 1));
    return;
  }
}

ColumnTitle parsed(const std::string& text) {
  ColumnTitle title;
  title.text = text;
  take_brackets(title);
  if (title.unit.empty()) take_suffix(title);
  if (title.unit.empty()) take_last_words(title);
  const auto quantity = quantity_in(title.name);
  if (quantity && quantity != "acceleration") title.quantity = *quantity;
  if (const auto other = other_quantity(title.unit)) title.quantity = *other;
  const bool is_acceleration =
      acceleration_unit(title.unit) || (quantity && quantity == "acceleration");
  if (title.quantity.empty() && !is_acceleration)
    title.quantity = foreign_quantity(title.name, title.unit);
  return title;
}

/// Words that say nothing of a direction.
bool is_filler(std::string_view word) {
  const auto rest = word.starts_with("CH") ? word.substr(2) : word;
  return word == "A" || rest.find_first_not_of("0123456789") == kNone ||
         begins_with_one_of(word, "ACC GROUND MOTION COMP CHAN DIR SENSOR ACEL RECORD");
}

/// "Z" of AZ and ACCZ, "EW" of ACCEW; other words as they are.
std::string_view without_quantity(std::string_view word) {
  for (const std::string_view start : {"ACCEL", "ACC", "A"})
    if (word.starts_with(start) && is_one_of(word.substr(start.size()), "E N Z U V EW NS UD"))
      return word.substr(start.size());
  return word;
}

void orient_by_name(std::string_view text, Component& component) {
  orient(text, component);
  if (component.azimuth || component.direction) return;
  const std::string capitals = upper(text);
  std::string rest;
  for (const auto each : words_of(capitals, " \t_"))
    if (const auto word = without_quantity(each); !is_filler(word))
      rest += fmt::format("{}{}", rest.empty() ? "" : " ", word);
  orient(rest, component);
  if (!component.azimuth && !component.direction) orient_by_label(rest, component);
  if (component.azimuth || component.direction) return;
  // "STA.EW", "CH3-UD", "UD-dir": two letters and more, as N may be a place.
  for (const auto word : words_of(capitals, " \t_.-:"))
    if (!is_filler(word) && word.size() > 1 && !number(word)) {
      orient(word, component);
      if (component.azimuth || component.direction) return;
    }
}

/// Letters only, in lower case: "tn" of "T_n".
std::string letters(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The cells of one line of text.
struct Cells {
  std::vector<std::string> texts;
  bool by_blanks = false;  ///< single blanks part them, as they part the words of a sentence
};

bool in_brackets_whole(std::string_view text) {
  return text.size() > 1 && std::string_view("([").find(text.front()) != kNone &&
         text.find_first_of(")]") == text.size() - 1;
}

std::string_view without_mark(std::string_view line) { return left_trimmed(line, "#%/ \t"); }

std::vector<std::string_view> apart_by_two_blanks(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const auto end = std::min({line.find("  "), line.find('\t'), line.size()});
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// Between any two marks, also where nothing stands there; a mark at the end parts nothing.
std::vector<std::string_view> apart_by_mark(std::string_view line, char mark) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find(mark, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

/// A bracket belongs to the word before it, unless all words are in brackets.
std::vector<std::string> with_brackets(const std::vector<std::string_view>& words) {
  const bool all = std::ranges::all_of(words, in_brackets_whole);
  std::vector<std::string> cells;
  for (const auto word : words) {
    const auto text = trimmed(word);
    const bool is_bracket = !text.empty() && (text[0] == '(' || text[0] == '[');
    // "(m / s2)" was cut at its blanks.
    const bool is_open = !cells.empty() && cells.back().find_last_of("([") != kNone &&
                         (cells.back().find_last_of(")]") == kNone ||
                          cells.back().find_last_of(")]") < cells.back().find_last_of("(["));
    if (!cells.empty() && (is_open || (is_bracket && !all)))
      cells.back() += std::string(text);
    else
      cells.emplace_back(text);
  }
  return cells;
}

/// Units that stand alone belong to the word before them: `Time, s, Acc, m/s2`.
std::vector<std::string> with_lone_units(const std::vector<std::string>& cells) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (const std::string& cell = cells[i];
        lower(cell) == "in" && i + 1 < cells.size() && is_unit_of_something(cells[i + 1]))
      continue;  // "acc in g"
    else if (!result.empty() && is_unit_of_something(cell) && !number(result.back()))
      result.back() += " [" + cell + "]";
    else
      result.push_back(cell);
  return result;
}

std::optional<Cells> cells_of(std::string_view line, std::size_t count) {
  constexpr std::size_t kLongestLine = 10000;
  if (line.size() > kLongestLine) return {};
  line = without_mark(line);
  std::vector<Cells> partings;
  for (const char mark : {';', ',', '\t'})
    if (line.find(mark) != kNone) {
      partings.push_back({with_brackets(apart_by_mark(line, mark)), false});
      partings.push_back({with_brackets(words_of(line, std::string_view(&mark, 1))), false});
    }
  partings.push_back({with_brackets(words_of(line, " \t")), true});
  partings.push_back({with_brackets(apart_by_two_blanks(line)), false});
  for (const Cells& cells : partings)
    if (cells.texts.size() == count) return cells;
  for (Cells& cells : partings) {
    cells.texts = with_lone_units(cells.texts);
    if (cells.texts.size() == count) return cells;
  }
  return {};
}

bool is_empty_cell(std::string_view text) {
  return text.empty() || text == "-" || text == "--" || text == "()" || text == "[]";
}

/// `[s] [g] [cm/s]`, `(s),(g),(cm)`, `s,g`, `sec,g,g,in`.
bool is_unit_row(const Cells& cells) {
  const auto is_unit = [](const std::string& text) {
    return is_empty_cell(text) || in_brackets_whole(text) || is_unit_of_something(text);
  };
  return std::ranges::all_of(cells.texts, is_unit) &&
         std::ranges::any_of(cells.texts, is_unit_of_something);
}

/// `Units: g`, `cm/s2; dt=0.01`, `recorded in g`, `Acc m/s2`: no titles although the words fit.
bool is_statement(const Cells& cells) {
  constexpr std::string_view kLinks = "in of at from the and by for is with to on are";
  constexpr std::string_view kKeys =
      "unit dt npts sampling station event date record file component channels";
  const auto& texts = cells.texts;
  const std::string first = lower(texts[0]);
  const bool has_key = begins_with_one_of(first, kKeys) || first.starts_with("time step");
  if (first.ends_with(':') || (has_key && first.find(':') != kNone)) return true;
  for (const std::string& text : texts) {
    if (text.find('=') != std::string::npos) return true;
    const bool is_link = text.ends_with(':') || is_one_of(lower(text), kLinks);
    if (cells.by_blanks && is_link) return true;
  }
  return cells.by_blanks && quantity_in(texts[0]) == "acceleration" &&
         std::ranges::any_of(texts.begin() + 1, texts.end(),
                             [](const auto& text) { return acceleration_unit(text).has_value(); });
}

/// Words of a sentence are no titles if the first of them names neither a time nor an index.
bool may_be_titles(const Cells& cells, bool first_grows) {
  if (is_statement(cells) || is_unit_row(cells)) return false;
  if (!cells.by_blanks || !first_grows) return true;
  const auto titles = parsed_titles(cells.texts);
  const bool has_unit = std::ranges::any_of(
      titles, [](const ColumnTitle& title) { return is_unit_of_something(title.unit); });
  const bool is_ascii = std::ranges::all_of(
      cells.texts[0], [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return has_unit || !is_ascii || names_time(titles[0]) || names_index(titles[0]) ||
         names_period(titles[0]) || titles[0].name.size() == 1;
}

bool first_grows(const PlainRows& rows, std::size_t count) {
  for (std::size_t i = count; i < rows.values.size(); i += count)
    if (!(rows.values[i] > rows.values[i - count])) return false;
  return rows.lengths.size() > 1;
}

/// Units of a row of their own stand behind the names; those that the names have stay too.
std::vector<std::string> with_units(std::vector<std::string> names,
                                    const std::vector<std::string>& units) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!is_empty_cell(units[i])) {
      const std::string_view unit = units[i];
      const bool whole = in_brackets_whole(unit);
      names[i] += fmt::format("{}[{}]", names[i].empty() ? "" : " ",
                              whole ? unit.substr(1, unit.size() - 2) : unit);
    }
  return names;
}

/// A line of the header that has one cell for each column.
struct TitleRow {
  std::size_t line = 0;
  Cells cells;
};

TableTitles titles_of(const std::vector<std::string>& names, std::vector<std::size_t> lines,
                      const PlainRows& rows) {
  TableTitles result;
  result.titles = parsed_titles(names);
  result.line = rows.header_lines[*std::ranges::max_element(lines)];
  result.lines = std::move(lines);
  return result;
}

/// `components: E N Z`, for as many columns or all but the first.
TableTitles named_components(const PlainRows& rows, std::size_t count) {
  for (std::size_t i = 0; i < rows.header.size(); ++i) {
    const std::string line = lower(without_mark(rows.header[i]));
    const auto mark = line.find_first_of(":=");
    if (mark == std::string::npos) continue;
    const auto key = trimmed(std::string_view(line).substr(0, mark));
    if (!key.ends_with("components") && !key.ends_with("channels") && !key.ends_with("columns") &&
        key != "component order" && key != "component" && key != "order")
      continue;
    const auto text = without_mark(rows.header[i]).substr(mark + 1);
    std::vector<std::string> names;
    for (const auto word : words_of(text, " \t,;/")) names.emplace_back(word);
    if (names.size() + 1 == count && first_grows(rows, count)) names.insert(names.begin(), "time");
    if (names.size() != count || count < 2) continue;
    TableTitles result = titles_of(names, {i}, rows);
    result.are_components = true;
    return result;
  }
  return {};
}

}  // namespace

bool ColumnTitle::is_acceleration() const {
  if (!quantity.empty()) return false;
  const std::string plain = lower(name);
  return acceleration_unit(unit) || plain == "a" || plain == "ag" || plain.starts_with("acc") ||
         quantity_in(name) == "acceleration";
}

bool is_unit_of_something(std::string_view text) {
  text = trimmed(text);
  const bool in_brackets = text.size() > 1 && std::string_view("([").find(text.front()) != kNone;
  const std::string plain = plain_unit(text);
  return is_unit(text) ||
         std::ranges::any_of(kUnits,
                             [&](const auto& each) { return is_one_of(plain, each.words); }) ||
         (in_brackets && (plain == "v" || plain == "n" || plain == "c" || plain == "%"));
}

bool names_time(const ColumnTitle& title) {
  const std::string name = letters(title.name);
  return name == "t" || (name.empty() && time_unit(title.unit)) ||
         begins_with_one_of(name, "time tempo tiempo temps zeit zaman tijd");
}

bool names_index(const ColumnTitle& title) {
  constexpr std::string_view kNames =
      "no n i nr num number index sample samples step row point points scan id unnamed";
  const std::string name = letters(title.name);
  return title.unit.empty() && (name.empty() || is_one_of(name, kNames));
}

bool names_period(const ColumnTitle& title) {
  const std::string name = letters(title.name), unit = plain_unit(title.unit);
  return name.find("period") != kNone || begins_with_one_of(name, "per freq frec frek") ||
         is_one_of(name, "tn f fn freq omega") || is_one_of(unit, "hz rad/s 1/s") ||
         lower(title.name) == "hz";
}

bool names_ordinate(const ColumnTitle& title, bool beside_time) {
  constexpr std::string_view kNames =
      "sa psa rsa psv fas ars uhs sae spa target mce dbe mcer design";
  std::string name = lower(title.name);
  if (name.starts_with("s_")) name.erase(1, 1);  // "S_a"
  const auto words = words_of(name, " \t_-.,:;/#*|0123456789%");
  if (words.empty()) return false;
  return is_one_of(words[0], kNames) || begins_with_one_of(words[0], "rotd spectr") ||
         (!beside_time && is_one_of(words[0], "se sd sv response"));
}

std::vector<ColumnTitle> parsed_titles(const std::vector<std::string>& titles) {
  std::vector<ColumnTitle> result;
  for (const std::string& title : titles) result.push_back(parsed(title));
  const auto any = [&](auto is) { return std::ranges::any_of(result, is); };
  const auto has_name = [](const ColumnTitle& title, std::string_view name) {
    return title.quantity.empty() && title.unit.empty() && lower(title.name) == name;
  };
  const bool with_acceleration = any([](const ColumnTitle& title) {
    return lower(title.name) == "a" || quantity_in(title.name) == "acceleration";
  });
  const bool with_displacement =
      any([&](const ColumnTitle& t) { return has_name(t, "d") || t.quantity == "displacement"; });
  const bool with_directions = any([](const ColumnTitle& t) {
    const std::string name = lower(t.name);
    return name != "v" && name != "u" && name != "t" &&
           (may_be_direction(name) || name == "l" || name == "h1");
  });
  for (ColumnTitle& title : result) {
    const bool is_velocity = has_name(title, "v");
    if (!is_velocity && !has_name(title, "d") && !has_name(title, "u")) continue;
    if (with_acceleration || (is_velocity && with_displacement))
      title.quantity = is_velocity ? "velocity" : "displacement";
    title.is_doubtful = title.quantity.empty() && !with_directions;
  }
  return result;
}

void orient(const ColumnTitle& title, const std::optional<Direction>& stated,
            Component& component) {
  const Eigen::VectorXd samples = component.acceleration;
  orient_by_name(title.direction.empty() ? title.name : title.direction, component);
  if (!component.azimuth && !component.direction) orient_by_name(title.name, component);
  if (!stated) return;
  const bool is_vertical = component.direction == Direction::kVertical;
  const bool says_it = is_vertical || component.azimuth;
  if (says_it && is_vertical != (*stated == Direction::kVertical)) {
    component.acceleration = samples;
    component.warnings.clear();
    component.azimuth.reset();
    component.warnings.push_back(fmt::format(
        "the file calls this column '{}', `columns` makes it {}", title.text, name_of(*stated)));
  }
  component.direction = *stated;
}

TableTitles table_titles(const PlainRows& rows, std::size_t count) {
  constexpr std::size_t kSearched = 6;  ///< lines above the numbers
  const bool grows = first_grows(rows, count);
  std::optional<TitleRow> units, names;
  std::size_t seen = 0;
  for (std::size_t i = rows.header.size(); i-- > 0 && seen < kSearched && !names;) {
    if (is_rule(without_mark(rows.header[i])) || without_mark(rows.header[i]).empty()) continue;
    ++seen;
    const auto cells = cells_of(rows.header[i], count);
    if (!cells) continue;
    if (!units && is_unit_row(*cells)) {
      units = {i, *cells};
    } else if (may_be_titles(*cells, grows)) {
      // Far from the numbers only what names a time or a unit is surely no place and date.
      const auto titles = parsed_titles(cells->texts);
      const bool is_sure =
          names_time(titles[0]) || names_index(titles[0]) ||
          std::ranges::any_of(titles, [](const auto& t) { return is_unit_of_something(t.unit); });
      const bool is_next = seen == 1 || (units && units->line == i + 1);
      if (is_next || is_sure) names = {i, *cells};
    }
  }
  // Units may stand above the names.
  if (names && !units && names->line > 0)
    if (const auto above = cells_of(rows.header[names->line - 1], count);
        above && is_unit_row(*above))
      units = {names->line - 1, *above};
  if (names && units)
    return titles_of(with_units(names->cells.texts, units->cells.texts), {names->line, units->line},
                     rows);
  if (names) return titles_of(names->cells.texts, {names->line}, rows);
  if (units)
    return titles_of(with_units(std::vector<std::string>(count), units->cells.texts), {units->line},
                     rows);
  return named_components(rows, count);
}

}  // namespace gurney::groundmotions
