#include "studies/analysis/configuration_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/config/nearest_name.h"

namespace gurney::study {
namespace {

/// Levels that differ by less are one: a scale times an intensity is rounded.
constexpr double kRounding = 1e-9;

/// Indices of the names in a list apart by commas; empty unless all are known.
std::vector<std::size_t> parsed(const std::string& text, const std::vector<std::string>& names) {
  const auto whole = std::ranges::find(names, trimmed(text));
  if (whole != names.end()) return {static_cast<std::size_t>(whole - names.begin())};
  for (auto comma = text.find(','); comma != std::string::npos; comma = text.find(',', comma + 1)) {
    const auto first = std::ranges::find(names, trimmed(text.substr(0, comma)));
    if (first == names.end()) continue;
    std::vector<std::size_t> rest = parsed(text.substr(comma + 1), names);
    if (rest.empty()) continue;
    rest.insert(rest.begin(), static_cast<std::size_t>(first - names.begin()));
    return rest;
  }
  return {};
}

/// The rest of a list without the known names at its front; where no name has a comma, up to the next one.
std::string unknown_part(const std::string& text, const std::vector<std::string>& names) {
  for (auto comma = text.find(','); comma != std::string::npos; comma = text.find(',', comma + 1))
    if (std::ranges::find(names, trimmed(text.substr(0, comma))) != names.end())
      return unknown_part(text.substr(comma + 1), names);
  const bool with_commas = std::ranges::any_of(
      names, [](const std::string& name) { return name.find(',') != std::string::npos; });
  return std::string(trimmed(with_commas ? text : text.substr(0, text.find(','))));
}

std::string no_configuration(const std::string& text, const std::vector<std::string>& names) {
  const std::string part = unknown_part(text, names), near = config::near_name(part, names);
  return fmt::format("no configuration '{}'{}", part,
                     near.empty() ? fmt::format("; known: '{}'", fmt::join(names, "', '")) : near);
}

}  // namespace

std::vector<std::size_t> named_configurations(const StudyData& data, const std::string& text) {
  if (text.empty()) return {};
  const std::vector<std::size_t> found = parsed(text, data.configurations());
  require(!found.empty(),
          data.file().path() + ": " + no_configuration(text, data.configurations()));
  return found;
}

std::vector<std::size_t> wanted_configurations(const StudyData& data,
                                               const std::vector<std::string>& texts) {
  std::vector<std::size_t> wanted;
  for (const std::string& text : texts)
    for (const std::size_t each : named_configurations(data, text))
      if (std::ranges::find(wanted, each) == wanted.end()) wanted.push_back(each);
  if (texts.empty())
    for (std::size_t i = 0; i < data.configurations().size(); ++i) wanted.push_back(i);
  return wanted;
}

std::vector<RunMeasure> known_measures(const StudyData& data) {
  std::vector<RunMeasure> known;
  for (const std::string& name : data.measures()) {
    try {
      known.push_back(data.measure(name));
    } catch (const Error&) {  // no record has it
    }
  }
  return known;
}

Levels::Levels(const StudyData& data) {
  measure_ = data.file().text_attribute("intensity_measure");
  unit_ = report_unit(data, {measure_, data.file().text_attribute("intensity_units"), {}});
  const std::vector<double> value =
      data.file().numbers(measure_.empty() ? "runs/scale" : "runs/intensity");
  std::vector<double> sorted = value;
  std::ranges::sort(sorted);
  for (const double each : sorted)
    if (values_.empty() || each > values_.back() * (1 + kRounding)) values_.push_back(each);
  for (const double each : value) {
    const auto above = std::ranges::upper_bound(values_, each);
    of_run_.push_back(static_cast<std::size_t>(above - values_.begin()) - 1);
  }
}

std::string Levels::name_of(std::size_t level) const {
  if (measure_.empty()) return fmt::format("scale = {:.4g}", values_.at(level));
  return fmt::format("{} = {:.4g} {}", measure_, values_.at(level) / unit_.in_si, unit_.name);
}

std::vector<std::size_t> record_rows(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  if (side.runs().empty()) return {};
  const auto motion = static_cast<std::size_t>(file.numbers("runs/motion")[side.runs().front()]);
  const auto set = static_cast<int>(file.numbers("motions/set")[motion]);
  const std::vector<std::string> sets = file.strings("records/set");
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < sets.size(); ++row)
    if (sets[row] == std::to_string(set)) rows.push_back(row);
  return rows;
}

std::vector<std::string> record_names(const ConfigurationView& side) {
  const std::vector<std::string> names = side.data->file().strings("records/name");
  std::map<std::string, int> times;
  std::vector<std::string> result;
  for (const std::size_t row : record_rows(side)) {
    const int time = ++times[names[row]];
    result.push_back(time == 1 ? names[row] : fmt::format("{} ({})", names[row], time));
  }
  return result;
}

}  // namespace gurney::study
