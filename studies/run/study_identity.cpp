#include "studies/run/study_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/config/document.h"
#include "studies/build_info/build_info.h"
#include "studies/plan/study_job.h"
#include "studies/run/part_folder.h"

namespace gurney::study {
namespace {

using Entries = std::map<std::string, std::string>;

constexpr const char* kJob = "job_sha256";
constexpr std::size_t kMaxShown = 3;

std::string input_lines(const Batch& batch) {
  std::string lines;
  for (std::size_t set = 0; set < batch.motions.sets(); ++set)
    for (std::size_t i = 0; i < batch.motions.set(set).size(); ++i)
      lines += record_line(std::to_string(set), batch.motions.set(set).name(i),
                           batch.motions.set(set).ground(i).files);
  for (const auto& [name, hash] : data_files(batch.job)) lines += data_file_line(name, hash);
  return lines;
}

/// Without the job's text. Records of one name are numbered.
Entries entries_of(const std::string& identity) {
  Entries entries;
  std::istringstream stream(identity);
  for (std::string line; std::getline(stream, line) && !line.empty();) {
    const auto cut = std::min(line.find(" = "), line.size());
    const std::string name = line.substr(0, cut);
    std::string key = name;
    for (int number = 2; entries.contains(key); ++number)
      key = fmt::format("{} ({})", name, number);
    entries[key] = cut < line.size() ? line.substr(cut + 3) : "";
  }
  return entries;
}

std::string value_in(const Entries& entries, const std::string& key) {
  const auto found = entries.find(key);
  return found == entries.end() ? "nothing" : "'" + found->second + "'";
}

std::string differences(const Entries& theirs, const Entries& ours) {
  Entries all = theirs;
  all.insert(ours.begin(), ours.end());
  std::string text;
  std::size_t count = 0;
  for (const auto& [key, ignored] : all) {
    const std::string there = value_in(theirs, key), here = value_in(ours, key);
    if (there == here || ++count > kMaxShown) continue;
    text += fmt::format("{}{}: there {}, here {}", count > 1 ? "; " : "", key, there, here);
  }
  return text + (count > kMaxShown ? fmt::format("; and {} more", count - kMaxShown) : "");
}

Entries keys_of_job(const std::string& text) {
  Entries entries;
  flatten(config::Document(text, "the job").tree(), "", entries);
  return entries;
}

/// Beginnings of the keys of each level of each factor.
std::vector<std::string> levels_of_job(const std::string& text) {
  const config::Node tree = config::Document(text, "the job").tree();
  std::vector<std::string> levels;
  const config::Node* const study = tree.find("study");
  const config::Node* const factors = study == nullptr ? nullptr : study->find("factor");
  if (factors == nullptr) return levels;
  for (const config::Node& factor : factors->elements) {
    const config::Node *const name = factor.find("name"), *const known = factor.find("level");
    if (name == nullptr || known == nullptr) continue;
    for (const config::Node& level : known->elements)
      levels.push_back(fmt::format("study.factor[{}].level.{}.", name->text, level.key));
  }
  return levels;
}

/// A described path, or an array of them, without folders.
std::string file_names(const std::string& described) {
  return std::regex_replace(described, std::regex("\"[^\"]*/"), "\"");
}

}  // namespace

std::string job_text_in(const std::string& identity) {
  const auto end = identity.find("\n\n");
  return end == std::string::npos ? std::string() : identity.substr(end + 2);
}

std::string record_line(const std::string& set, const std::string& name, const std::string& files) {
  std::string on_one_line = files;
  std::ranges::replace(on_one_line, '\n', ',');
  return fmt::format("record {}{} = {}\n", name, set == "0" ? "" : " of set " + set, on_one_line);
}

std::string data_file_line(const std::string& name, const std::string& sha256) {
  return fmt::format("{} = {}\n", name, sha256);
}

std::string inputs_from(const std::string& lines, const std::string& job_text) {
  return fmt::format("{} = {}\n{}\n{}", kJob, sha256(job_text), lines, job_text);
}

std::string inputs_of(const Batch& batch) {
  return inputs_from(input_lines(batch), batch.job.text());
}

std::string identity_of(const Batch& batch) {
  const build_info::BuildInfo build = build_info::build_info();
  return inputs_from(
      fmt::format("{}analysis_cases = {}\nprogram = {} {}\ncpu_class = {}\n", input_lines(batch),
                  batch.plan.tasks(), build.program_version, build.git_commit, build.cpu_class),
      batch.job.text());
}

namespace {

/// The whole number of an entry; none: it has none.
std::optional<std::size_t> number_in(const Entries& entries, const std::string& key) {
  const auto found = entries.find(key);
  const std::string text = found == entries.end() ? "" : found->second;
  std::size_t number = 0;
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (text.empty() || read.ec != std::errc() || read.ptr != end) return {};
  return number;
}

}  // namespace

std::size_t tasks_in(const std::string& identity) {
  const auto tasks = number_in(entries_of(identity), "analysis_cases");
  require(tasks.has_value(), "the file 'study' states no number of analysis cases");
  return *tasks;
}

std::size_t stages_in(const std::string& identity) {
  return 1 + number_in(keys_of_job(job_text_in(identity)), "study.intensity.adaptive.stages")
                 .value_or(0);
}

std::string job_difference(const std::string& theirs, const std::string& ours) {
  return differences(keys_of_job(theirs), keys_of_job(ours));
}

std::string run_difference(const std::string& theirs, const std::string& ours) {
  const auto compared = [](Entries job, const std::vector<std::string>& own,
                           const std::vector<std::string>& other) {
    // The item of the job is that of no run: each level states its own.
    static const std::set<std::string> kOfDesign = {"title", "item.equipment", "study.combinations",
                                                    "study.intensity.levels"};
    std::erase_if(job, [&](const auto& entry) {
      const auto begins = [&](const std::string& level) { return entry.first.starts_with(level); };
      return kOfDesign.contains(entry.first) ||
             (std::ranges::any_of(own, begins) && std::ranges::none_of(other, begins));
    });
    // Files are the same wherever they lie: their contents are compared by their hashes.
    for (auto& [key, value] : job)
      if (key.ends_with(".file") || key.ends_with(".files")) value = file_names(value);
    return job;
  };
  const std::vector<std::string> there = levels_of_job(theirs), here = levels_of_job(ours);
  return differences(compared(keys_of_job(theirs), there, here),
                     compared(keys_of_job(ours), here, there));
}

std::string difference(const std::string& theirs, const std::string& ours) {
  Entries there = entries_of(theirs), here = entries_of(ours);
  const std::string job_there = job_text_in(theirs), job_here = job_text_in(ours);
  if (!job_there.empty() && !job_here.empty() && there[kJob] != here[kJob]) {
    const std::string keys = job_difference(job_there, job_here);
    if (!keys.empty()) return keys + " (in the job)";
    return fmt::format("the comments or the layout of the job ({})",
                       differences({{kJob, there[kJob]}}, {{kJob, here[kJob]}}));
  }
  const std::string found = differences(there, here);
  return found.empty() && theirs != ours ? "the order of the records or data files" : found;
}

IdentityFile::IdentityFile(const std::filesystem::path& folder) : path_(folder / "study") {
  std::error_code unknown;
  const std::string bytes =
      std::filesystem::exists(path_, unknown) ? file_bytes(path_) : std::string();
  exists_ = !bytes.empty();
  const auto end = bytes.find('\n');
  if (end != std::string::npos) identity_ = bytes.substr(end + 1);
  damaged_ = exists_ && bytes != bytes_of(identity_);
}

const std::string& IdentityFile::identity() const {
  require(!damaged_, path_.string() +
                         ": is damaged (its checksum does not match); `gurney run` with --resume "
                         "and `gurney merge` write it again");
  return identity_;
}

std::string IdentityFile::bytes_of(const std::string& identity) {
  return "sha256 = " + sha256(identity) + "\n" + identity;
}

}  // namespace gurney::study
