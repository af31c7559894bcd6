#include "groundmotions/formats/column_title.h"

#include <fmt/format.h>

#include <algorithm>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr auto kNone = std::string_view::npos;

bool is_unit(std::string_view text) {
  return acceleration_unit(text) || other_quantity(text) || time_unit(text);
}

bool says_direction(std::string_view text) {
  Component component;
  component.acceleration = Eigen::Vector2d::Zero();
  orient(text, component);
  return component.azimuth || component.direction || orient_by_label(text, component) ||
         number(text);
}

void take_brackets(ColumnTitle& title) {
  std::string_view rest = title.text;
  for (auto open = rest.find_first_of("(["); open != kNone; open = rest.find_first_of("([")) {
    title.name += rest.substr(0, open);
    rest.remove_prefix(open);
    const auto content = in_brackets(rest);
    if (!is_unit(content) && says_direction(content))
      title.direction = content;
    else if (title.unit.empty() || !is_unit(title.unit))
      title.unit = content;
    rest.remove_prefix(std::min(rest.find_first_of(")]"), rest.size() - 1) + 1);
  }
  title.name += rest;
  title.name = trimmed(title.name);
}

/// `acc_g`, `x_m_per_s2`, `time_ms`.
void take_suffix(ColumnTitle& title) {
  for (auto at = title.name.find('_'); at != kNone; at = title.name.find('_', at + 1)) {
    if (at == 0 || !is_unit(title.name.substr(at + 1))) continue;
    title.unit = title.name.substr(at + 1);
    title.name.resize(at);
  }
}

ColumnTitle parsed(const std::string& text) {
  ColumnTitle title;
  title.text = text;
  take_brackets(title);
  if (title.unit.empty()) take_suffix(title);
  const auto quantity = quantity_in(title.name);
  if (quantity && quantity != "acceleration") title.quantity = *quantity;
  if (const auto other = other_quantity(title.unit)) title.quantity = *other;
  const std::string name = lower(title.name);
  if (title.quantity.empty() && (name.starts_with("vel") || name.starts_with("disp")))
    title.quantity = name[0] == 'v' ? "velocity" : "displacement";
  return title;
}

/// Words that say nothing of a direction.
bool is_filler(std::string_view word) {
  return word.starts_with("ACC") || word == "A" || word == "GROUND" || word == "MOTION" ||
         word.starts_with("COMP");
}

void orient_by_name(std::string_view text, Component& component) {
  orient(text, component);
  if (component.azimuth || component.direction) return;
  const std::string capitals = upper(text);
  std::string rest;
  for (const auto word : words_of(capitals, " \t_"))
    if (!is_filler(word)) rest += fmt::format("{}{}", rest.empty() ? "" : " ", word);
  orient(rest, component);
  if (!component.azimuth && !component.direction) orient_by_label(rest, component);
}

}  // namespace

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
    return name != "v" && name != "t" && (says_direction(name) || name == "l" || name == "h1");
  });
  for (ColumnTitle& title : result) {
    if (has_name(title, "v")) {
      if (with_acceleration || with_displacement) title.quantity = "velocity";
      title.is_doubtful = title.quantity.empty() && !with_directions;
    } else if (with_acceleration && (has_name(title, "d") || has_name(title, "u"))) {
      title.quantity = "displacement";
    }
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

}  // namespace gurney::groundmotions
