#include "studies/analysis/input_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "engine/config/document.h"
#include "engine/config/overlay.h"
#include "studies/job/old_names.h"
#include "studies/plan/flat_tree.h"

namespace gurney::study {
namespace {

using config::Node;
using Entries = std::map<std::string, std::string>;

/// The job of one configuration, with [study] but without its factors.
Entries job_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  config::Document document(file.job_text(), file.path());
  rename_old_keys(document);
  Entries entries;
  auto study = document.take("study");
  std::erase_if(study->elements, [](const Node& each) { return each.key == "factor"; });
  flatten(*study, "study", entries);
  Node job = document.tree();
  for (const Factor& factor : side.data->study().factors) {
    const std::string level = file.strings("configurations/" + factor.name)[side.configuration];
    for (const FactorLevel& each : factor.levels)
      if (each.name == level) config::overlay(job, each.patch, factor.name, document);
  }
  flatten(job, "", entries);
  return entries;
}

Entries assumptions_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto configuration = file.strings("assumptions/configuration");
  const auto keys = file.strings("assumptions/key"), values = file.strings("assumptions/value"),
             ranges = file.strings("assumptions/range");
  Entries entries;
  for (std::size_t row = 0; row < keys.size(); ++row)
    if (configuration[row] == std::to_string(side.configuration))
      entries[keys[row]] = fmt::format("{} ({})", values[row], ranges[row]);
  return entries;
}

Entries data_files_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  Entries entries;
  for (std::size_t row = 0; row < names.size(); ++row) entries[names[row]] = hashes[row];
  return entries;
}

Entries program_of(const ConfigurationView& side) {
  Entries entries;
  for (const char* name :
       {"program_version", "git_commit", "compiler", "bullet_precision", "cpu_class"})
    entries[name] = side.data->file().text_attribute(name);
  return entries;
}

/// Name of each record with what it came from.
Entries records_of(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto files = file.strings("records/files"), processing = file.strings("records/processing");
  const std::vector<std::string> names = record_names(side);
  const std::vector<std::size_t> rows = record_rows(side);
  Entries entries;
  for (std::size_t i = 0; i < rows.size(); ++i)
    entries[names[i]] = files[rows[i]] + "\n" + processing[rows[i]];
  return entries;
}

std::vector<InputDifference> differences(const Entries& a, const Entries& b) {
  std::vector<InputDifference> result;
  Entries all = a;
  all.insert(b.begin(), b.end());
  for (const auto& [key, ignored] : all) {
    const auto in_a = a.find(key), in_b = b.find(key);
    const InputDifference each{key, in_a == a.end() ? "" : in_a->second,
                               in_b == b.end() ? "" : in_b->second};
    if (each.a != each.b) result.push_back(each);
  }
  return result;
}

}  // namespace

bool InputDifferences::none() const {
  return job.empty() && assumptions.empty() && data_files.empty() && program.empty() &&
         records_of_a.empty() && records_of_b.empty() && records_changed.empty();
}

InputDifferences input_differences(const ConfigurationView& a, const ConfigurationView& b) {
  InputDifferences result;
  result.job = differences(job_of(a), job_of(b));
  result.assumptions = differences(assumptions_of(a), assumptions_of(b));
  result.data_files = differences(data_files_of(a), data_files_of(b));
  result.program = differences(program_of(a), program_of(b));
  const Entries of_a = records_of(a), of_b = records_of(b);
  for (const auto& [name, source] : of_a) {
    const auto other = of_b.find(name);
    if (other == of_b.end()) {
      result.records_of_a.push_back(name);
      continue;
    }
    ++result.records_common;
    if (other->second != source) result.records_changed.push_back(name);
  }
  for (const auto& [name, source] : of_b)
    if (!of_a.contains(name)) result.records_of_b.push_back(name);
  return result;
}

}  // namespace gurney::study
