#include "groundmotions/suites/folder_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "groundmotions/assembly/read_record.h"
#include "groundmotions/formats/words.h"
#include "groundmotions/suites/grouping.h"
#include "groundmotions/suites/list_suite.h"

namespace gurney::groundmotions {
namespace {

namespace fs = std::filesystem;

bool hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(folder);
       entry != fs::recursive_directory_iterator(); ++entry) {
    if (hidden(entry->path())) {
      if (entry->is_directory()) entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      files.push_back(entry->path());
    }
  }
  std::ranges::sort(files);
  return files;
}

class FileGrouping {
 public:
  /// @param only_where_needed  options are for the files that cannot be read without them
  FileGrouping(const ReadOptions& options, bool only_where_needed)
      : options_(options), only_where_needed_(only_where_needed) {}

  void read_report(const fs::path& path) {
    try {
      const SourceFile file(path);
      if (!recognises_peer_search_results(file)) return;
      Suite report = read_peer_search_results(file, options_);
      for (const SuiteRecord& record : report.records)
        for (const RecordFile& used : record.files) taken_.insert(used.path);
      std::ranges::move(report.records, std::back_inserter(suite_.records));
      std::ranges::move(report.refused, std::back_inserter(suite_.refused));
      std::ranges::move(report.notes, std::back_inserter(suite_.notes));
      taken_.insert(path);
    } catch (const Error&) {
      // reported when the file is read as a record
    }
  }

  void read_file(const fs::path& path) {
    if (taken_.contains(path)) return;
    try {
      const auto [components, options] = read(path);
      warn_of_copy(path, components[0].sha256);
      if (components.size() == 1) {
        singles_.push_back(found_component(path, components[0], {}, options));
        return;
      }
      std::vector<FoundComponent> channels;
      for (const std::size_t i : live_channels(components).kept)
        channels.push_back(found_component(path, components[i], static_cast<int>(i) + 1, options));
      std::ranges::move(records_of_file(channels), std::back_inserter(suite_.records));
    } catch (const Error& error) {
      suite_.refused.push_back({path.string(), error.what()});
    }
  }

  Suite finish() {
    std::ranges::move(records_of_components(std::move(singles_), suite_.warnings),
                      std::back_inserter(suite_.records));
    std::ranges::stable_sort(suite_.records, {},
                             [](const SuiteRecord& record) { return record.files.front().path; });
    return std::move(suite_);
  }

 private:
  void warn_of_copy(const fs::path& path, const std::string& sha256) {
    const auto [first, is_new] = read_.try_emplace(sha256, path);
    if (!is_new)
      suite_.warnings.push_back(fmt::format("{} and {} are the same file, byte by byte",
                                            first->second.string(), path.string()));
  }

  struct FileRead {
    std::vector<Component> components;
    ReadOptions options;
  };

  FileRead read(const fs::path& path) const {
    if (only_where_needed_) {
      ReadOptions without_time_step = options_;
      without_time_step.time_step.reset();
      for (const ReadOptions& options : {ReadOptions(), without_time_step}) {
        try {
          return {read_components(path, options), options};
        } catch (const Error&) {
          // reported below, if the options do not help
        }
      }
    }
    return {read_components(path, options_), options_};
  }

  ReadOptions options_;
  bool only_where_needed_;
  std::set<fs::path> taken_;
  std::map<std::string, fs::path> read_;  ///< by SHA-256
  std::vector<FoundComponent> singles_;
  Suite suite_;
};

Suite grouped(FileGrouping grouping, std::vector<fs::path> files, const Progress& progress) {
  const std::size_t dropped = drop_companions(files);
  for (const fs::path& file : files)
    if (upper(file.extension().string()) == ".CSV") grouping.read_report(file);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress(i, files.size());
    grouping.read_file(files[i]);
  }
  Suite suite = grouping.finish();
  if (dropped > 0)
    suite.notes.push_back(fmt::format(
        "{} {} of velocity or displacement beside their acceleration: not needed, skipped", dropped,
        dropped == 1 ? "file" : "files"));
  return suite;
}

constexpr std::array kCompanions = {std::pair(".VT2", ".AT2"), std::pair(".DT2", ".AT2"),
                                    std::pair(".VEL", ".ACC"), std::pair(".DIS", ".ACC"),
                                    std::pair(".DSP", ".ACC"), std::pair(".DISP", ".ACC")};

std::string key_of(const std::filesystem::path& path) {
  return (path.parent_path() / upper(path.filename().string())).string();
}

/// The acceleration file beside a velocity or a displacement; empty if the name is of neither.
std::string acceleration_of(const std::filesystem::path& path) {
  const std::string name = upper(path.filename().string());
  for (const auto& [mark, other] : kCompanions) {
    const std::string text = mark;
    const auto at = name.rfind(text);
    if (at == std::string::npos) continue;
    const auto end = at + text.size();
    if (end < name.size() && name[end] != '.') continue;
    return (path.parent_path() / (name.substr(0, at) + other + name.substr(end))).string();
  }
  return {};
}

}  // namespace

Suite group_files(const std::vector<fs::path>& files, const ReadOptions& options,
                  const Progress& progress) {
  return grouped({options, false}, files, progress);
}

Suite read_folder_suite(const fs::path& folder, const ReadOptions& options,
                        const Progress& progress) {
  const auto files = files_in(folder);
  require(!files.empty(), folder.string() + ": the folder holds no files");
  return grouped({options, true}, files, progress);
}

std::size_t drop_companions(std::vector<std::filesystem::path>& files) {
  std::set<std::string> names;
  for (const auto& file : files) names.insert(key_of(file));
  return std::erase_if(files, [&](const auto& file) {
    const std::string acceleration = acceleration_of(file);
    return !acceleration.empty() && names.contains(acceleration);
  });
}

}  // namespace gurney::groundmotions
