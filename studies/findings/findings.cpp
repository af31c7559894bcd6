#include "studies/findings/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney::findings {

// Here once, not wherever a cell is written.
Value::Value() = default;
Value::Value(const Value&) = default;
Value::Value(Value&&) noexcept = default;
Value& Value::operator=(const Value&) = default;
Value& Value::operator=(Value&&) noexcept = default;
Value::~Value() = default;

bool Value::is_missing() const {
  if (const auto* number = std::get_if<double>(this)) return !std::isfinite(*number);
  if (const auto* text = std::get_if<std::string>(this)) return text->empty();
  if (const auto* texts = std::get_if<Texts>(this)) return texts->empty();
  return std::holds_alternative<std::monostate>(*this);
}

Section::Section(std::string its_key, std::string its_title)
    : key(std::move(its_key)), title(std::move(its_title)) {}
Section::Section(const Section&) = default;
Section::Section(Section&&) noexcept = default;
Section& Section::operator=(const Section&) = default;
Section& Section::operator=(Section&&) noexcept = default;
Section::~Section() = default;

Section& Section::fact(std::string key_of, std::string label, Value value, Format format,
                       std::string note) {
  parts.emplace_back(Fact{std::move(key_of), std::move(label), std::move(value), std::move(format),
                          std::move(note)});
  return *this;
}

Section& Section::json(std::string key_of, Value value, Format format) {
  return fact(std::move(key_of), "", std::move(value), std::move(format));
}

Section& Section::text(std::string label, Value value, Format format, std::string note) {
  return fact("", std::move(label), std::move(value), std::move(format), std::move(note));
}

Section& Section::say(std::string sentence) {
  if (!sentence.empty()) parts.emplace_back(Sentence{std::move(sentence)});
  return *this;
}

Section& Section::list(std::string key_of, std::string title_of, Texts lines) {
  parts.emplace_back(List{std::move(key_of), std::move(title_of), std::move(lines)});
  return *this;
}

Section& Section::add(Table table) {
  parts.emplace_back(std::move(table));
  return *this;
}

Section& Section::add(List lines) {
  parts.emplace_back(std::move(lines));
  return *this;
}

Section& Section::add(Section section) {
  parts.emplace_back(std::move(section));
  return *this;
}

namespace {

bool is_zero(double number, const Format& format) {
  return number == 0 || std::abs(number) < format.least;
}

}  // namespace

std::size_t hide_zeros(Section& section) {
  std::size_t hidden = 0;
  for (Part& part : section.parts) {
    if (auto* inner = std::get_if<Section>(&part)) hidden += hide_zeros(*inner);
    auto* fact = std::get_if<Fact>(&part);
    if (fact == nullptr || fact->label.empty()) continue;
    const auto* count = std::get_if<std::int64_t>(&fact->value);
    const auto* number = std::get_if<double>(&fact->value);
    if ((count == nullptr || *count != 0) && !(number != nullptr && is_zero(*number, fact->format)))
      continue;
    fact->label.clear();
    ++hidden;
  }
  return hidden;
}

namespace {

std::string four_digits(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (!(size >= 1e-4 && size < 1e6)) return fmt::format("{:.2e}", value);
  return fmt::format("{:.{}f}", value,
                     std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6));
}

}  // namespace

std::string written(const Value& value, const Format& format) {
  const auto number = [&](double of) {
    of = is_zero(of, format) ? 0 : of / format.in_si;
    const std::string text =
        format.before + (format.digits.empty()
                             ? four_digits(of)
                             : fmt::format(fmt::runtime("{:" + format.digits + "}"), of));
    // A number shown as zero has no sign.
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-'
               ? text.substr(1)
               : text;
  };
  if (const auto* of = std::get_if<std::string>(&value)) return *of;
  if (value.is_missing()) return "-";
  if (const auto* of = std::get_if<bool>(&value)) return *of ? "yes" : "no";
  if (const auto* of = std::get_if<std::int64_t>(&value)) return std::to_string(*of);
  if (const auto* of = std::get_if<double>(&value)) return number(*of);
  if (const auto* of = std::get_if<Texts>(&value)) return fmt::format("{}", fmt::join(*of, ", "));
  Texts all;
  if (const auto* of = std::get_if<Counts>(&value))
    for (const std::int64_t each : *of) all.push_back(std::to_string(each));
  if (const auto* of = std::get_if<Numbers>(&value)) {
    if (format.between == kTo && of->size() == 2 && !std::isfinite(of->back()))
      return of->front() > 0 && std::isfinite(of->front()) ? number(of->front()) + " or more"
                                                           : "none";
    for (const double each : *of) all.push_back(number(each));
  }
  return fmt::format("{}", fmt::join(all, format.between));
}

std::string with_unit(const Value& value, const Format& format) {
  return written(value, format) + (format.unit.empty() ? "" : " " + format.unit);
}

const Value& value_in(const Table& table, std::size_t row, std::string_view key) {
  const auto column = std::ranges::find(table.columns, key, &Column::key);
  return table.rows.at(row).at(static_cast<std::size_t>(column - table.columns.begin())).value;
}

double number_in(const Table& table, std::size_t row, std::string_view key) {
  const Value& value = value_in(table, row, key);
  return value.is_missing() ? std::numeric_limits<double>::quiet_NaN() : std::get<double>(value);
}

const std::string& text_in(const Table& table, std::size_t row, std::string_view key) {
  return std::get<std::string>(value_in(table, row, key));
}

std::string text_of(const Section& section, std::string_view key) {
  const Fact* const fact = find<Fact>(section, key);
  return fact == nullptr || fact->value.is_missing() ? "" : written(fact->value, fact->format);
}

std::vector<Table> groups_of(const Table& table) {
  if (!table.grouped) return {table};
  std::vector<Table> groups;
  for (const auto& row : table.rows) {
    const std::string name = written(row.front().value, {});
    if (groups.empty() || groups.back().title != name)
      groups.push_back({"", name, {table.columns.begin() + 1, table.columns.end()}});
    groups.back().add({row.begin() + 1, row.end()});
  }
  return groups;
}

std::string listed(const Texts& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

Texts lines_of(const Section& section) {
  Texts lines;
  for (const Part& part : section.parts) {
    if (const auto* sentence = std::get_if<Sentence>(&part)) lines.push_back(sentence->text);
    const auto* list = std::get_if<List>(&part);
    if (list == nullptr) continue;
    lines.push_back(list->title);
    for (const std::string& each : list->lines) lines.push_back("  " + each);
  }
  return lines;
}

std::string heading(const Column& column) {
  return column.label + (column.format.unit.empty() ? "" : " [" + column.format.unit + "]");
}

}  // namespace gurney::findings
