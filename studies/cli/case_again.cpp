#include "studies/cli/case_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/hash/sha256.h"
#include "studies/cli/job_of_log.h"
#include "studies/cli/study_case.h"
#include "studies/results/columns.h"
#include "studies/results/hdf5_reader.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

std::string type_of(const study::Hdf5Reader& file) {
  const auto attributes = file.attributes();
  if (std::ranges::find(attributes, "filetype") == attributes.end()) return {};
  return file.text_attribute("filetype");
}

/// The demands of one run as its file has them, by column.
using StoredDemands = std::vector<std::pair<std::string, std::vector<double>>>;

StoredDemands demands_of(const study::Hdf5Reader& file) {
  StoredDemands demands;
  const std::vector<study::Hdf5Dataset> known = file.datasets();
  for (const study::TableColumn<Demands>& column : study::demand_columns()) {
    const std::string path = std::string("/items/") + column.name;
    if (std::ranges::find(known, path, &study::Hdf5Dataset::path) != known.end())
      demands.emplace_back(column.name, file.numbers(path));
  }
  return demands;
}

std::string difference_to(const std::string& path, const StoredDemands& stored,
                          const Response& response) {
  for (const auto& [name, theirs] : stored) {
    const auto column =
        std::ranges::find_if(study::demand_columns(),
                             [&wanted = name](const auto& each) { return each.name == wanted; });
    for (std::size_t i = 0; i < response.items.size(); ++i) {
      const double ours = column->value(response.items[i].demands);
      if (i < theirs.size() && (ours == theirs[i] || (std::isnan(ours) && std::isnan(theirs[i]))))
        continue;
      return fmt::format(
          "{}: its job gives other results now: {} is {:.17g}, there {:.17g}; a record, an item, "
          "the program or the machine has changed",
          path, name, ours, i < theirs.size() ? theirs[i] : 0);
    }
  }
  return {};
}

CaseAgain single_run(const std::string& path, const std::string& named) {
  const study::Hdf5Reader file(path);
  require(type_of(file) == "gurney-results", path + ": is not a results file");
  const std::string job = named.empty() ? job_of_log(path) : named;
  require(!job.empty() && is_there(job),
          fmt::format("{}: the job's file {}; name it with --job", path,
                      job.empty() ? "is not known" : job + " " + why_not_there(job)));
  CaseAgain result{study::prepare_run(job), {}};
  const std::string& text = result.run.facts.job_text;
  if (result.run.facts.job_sha256 != file.text_attribute("job_sha256"))
    throw Error(fmt::format("{}: is not the job of {}: {}", job, path,
                            study::job_difference(file.text_attribute("job_text"), text)));
  result.difference = [path, stored = demands_of(file)](const Response& response) {
    return difference_to(path, stored, response);
  };
  return result;
}

}  // namespace

bool is_study(const std::string& path) {
  return type_of(study::Hdf5Reader(path)) == "gurney-study";
}

CaseAgain case_again(const std::string& file, std::optional<std::size_t> index,
                     const std::string& job) {
  if (!is_study(file)) {
    require(index.value_or(0) == 0, file + ": is a single run, which has no --run but 0");
    return single_run(file, job);
  }
  require(index.has_value(), file + ": is a study; choose one of its runs with --run N");
  const auto of_study = std::make_shared<StudyCase>(file, *index, job);
  return {of_study->prepared(),
          [of_study](const Response& response) { return of_study->difference(response); }};
}

}  // namespace gurney::cli
