#include "studies/cli/compare_command.h"

#include <fmt/format.h>

#include <optional>

#include "engine/base/error.h"
#include "studies/cli/records_output.h"
#include "studies/report/comparison_report.h"

namespace gurney {
namespace {

std::string listed(const StudyData& data) {
  return fmt::format("{}: {}", data.file().path(), fmt::join(data.configurations(), "; "));
}

/// Two configurations of one file.
void choose(const StudyData& data, const std::string& text, ComparisonReport& report) {
  std::vector<std::size_t> chosen = named_configurations(data, text);
  if (text.empty() && data.configurations().size() == 2) chosen = {0, 1};
  require(chosen.size() == 2,
          fmt::format("two configurations must be named, --configurations A,B, or a second file "
                      "given\n{}",
                      listed(data)));
  report.a = {&data, chosen[0]};
  report.b = {&data, chosen[1]};
  report.name_a = report.a.configuration_name();
  report.name_b = report.b.configuration_name();
}

/// The configuration of a file that a text names by itself.
std::optional<std::size_t> only(const StudyData& data, const std::string& text) {
  if (text.empty() && data.configurations().size() == 1) return 0;
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    if (!text.empty() && data.configurations()[i] == text) return i;
  return {};
}

/// One configuration of each file: one name for both, or two apart by a comma.
void choose(const StudyData& a, const StudyData& b, const std::string& text,
            ComparisonReport& report) {
  auto first = only(a, text), second = only(b, text);
  for (auto comma = text.find(','); !(first && second) && comma != std::string::npos;
       comma = text.find(',', comma + 1)) {
    const auto start = text.find_first_not_of(' ', comma + 1);
    first = only(a, text.substr(0, comma));
    second = start == std::string::npos ? std::nullopt : only(b, text.substr(start));
  }
  require(first && second,
          fmt::format("{}a configuration of each file must be named, --configuration NAME, or "
                      "NAME,NAME where they differ\n{}\n{}",
                      text.empty() ? "" : fmt::format("--configuration '{}': ", text), listed(a),
                      listed(b)));
  report.a = {&a, *first};
  report.b = {&b, *second};
  const auto name = [](const StudySide& side) {
    const std::string& of = side.configuration_name();
    return side.data->file().path() + (of.empty() ? "" : " (" + of + ")");
  };
  report.name_a = name(report.a);
  report.name_b = name(report.b);
}

}  // namespace

int compare_command(const CompareOptions& options) {
  const StudyData a(options.a);
  std::optional<StudyData> b;
  ComparisonReport report;
  if (options.b.empty()) {
    choose(a, options.configurations, report);
  } else {
    b.emplace(options.b);
    choose(a, *b, options.configurations, report);
  }
  report.inputs = input_differences(report.a, report.b);
  report.found = compare_studies(
      report.a, report.b,
      {.demands = options.demands, .measure = options.measure, .confidence = report.confidence});
  fmt::print("{}", options.json ? comparison_json(report) : comparison_text(report));
  if (!options.figure.empty())
    write_output(options.figure, comparison_figure(report), options.overwrite, options.json);
  return 0;
}

}  // namespace gurney
