#include "studies/study_results/study_reader.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/study_results/study_file.h"

namespace gurney {

StudyReader::StudyReader(const std::string& path) : path_(path), file_(path) {
  const std::string type = text_attribute("filetype");
  require(type == "gurney-study",
          path + ": is no results file of a study" +
              (type.empty() ? "" : " but '" + type + "', which one run leaves"));
  const std::int64_t version = file_.whole_attribute("format_version");
  require(version == kStudyFormatVersion,
          fmt::format("{}: is a study file of format_version {}, made by gurney {} ({}); this "
                      "program reads version {}: run the study again, or use that program",
                      path, version, text_attribute("program_version"),
                      text_attribute("git_commit"), kStudyFormatVersion));
  for (const Hdf5Dataset& each : file_.datasets()) columns_[each.path] = true;
  runs_ = numbers("runs/run").size();
}

bool StudyReader::has(const std::string& table) const {
  return columns_.contains("/" + table + "/row");
}

std::vector<double> StudyReader::numbers(const std::string& column) const {
  require(columns_.contains("/" + column), path_ + ": has no column " + column);
  return file_.numbers("/" + column);
}

std::vector<std::string> StudyReader::strings(const std::string& column) const {
  require(columns_.contains("/" + column), path_ + ": has no column " + column);
  return file_.strings("/" + column);
}

std::vector<std::pair<std::size_t, std::size_t>> StudyReader::rows_of_runs(
    const std::string& table) const {
  std::vector<std::pair<std::size_t, std::size_t>> rows(runs_, {0, 0});
  const std::vector<double> run = numbers(table + "/run");
  for (std::size_t row = 0; row < run.size(); ++row) {
    auto& [first, last] = rows.at(static_cast<std::size_t>(run[row]));
    if (last == 0) first = row;
    last = row + 1;
  }
  return rows;
}

}  // namespace gurney
