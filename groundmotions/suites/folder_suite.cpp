#include "groundmotions/suites/folder_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "groundmotions/formats/words.h"
#include "groundmotions/suites/peer_search_results.h"

namespace gurney {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSeparators = "-_. ";

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

std::string fact(const Component& component, const char* name) {
  for (const auto& [key, value] : component.header)
    if (key == name) return value;
  return {};
}

/// Event and station as the header has them, without the name of the component.
std::string content_key(const Component& component) {
  std::string key = fact(component, "event") + "|" + fact(component, "station");
  if (key == "|") return {};
  if (const auto at = key.rfind(component.name); !component.name.empty() && at != std::string::npos)
    key.replace(at, component.name.size(), "*");
  return key;
}

bool all_digits(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

/// Where `part` stands last in `text` with no character of its own kind beside it: no letter beside
/// a letter, no digit beside a digit.
std::size_t find_apart(const std::string& text, const std::string& part) {
  const auto touches = [](unsigned char a, unsigned char b) {
    return (std::isdigit(a) && std::isdigit(b)) || (std::isalpha(a) && std::isalpha(b));
  };
  for (auto at = text.rfind(part); at != std::string::npos;
       at = at > 0 ? text.rfind(part, at - 1) : std::string::npos) {
    const std::size_t end = at + part.size();
    const bool before = at > 0 && touches(static_cast<unsigned char>(text[at - 1]),
                                          static_cast<unsigned char>(part.front()));
    const bool after = end < text.size() && touches(static_cast<unsigned char>(text[end]),
                                                    static_cast<unsigned char>(part.back()));
    if (!before && !after) return at;
  }
  return std::string::npos;
}

std::string without_ends(std::string name) {
  const auto star = name.find('*');
  if (star == std::string::npos) return fs::path(name).stem().string();
  std::string result = name.substr(0, star) + name.substr(star + 1);
  result = fs::path(result).stem().string();
  while (!result.empty() && kSeparators.find(result.back()) != std::string_view::npos)
    result.pop_back();
  return result.empty() ? name : result;
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
      for (SuiteRecord& record : report.records) {
        for (const RecordFile& used : record.files) taken_.insert(used.path);
        records_["0" + path.string() + fmt::format("{:06}", records_.size())] = std::move(record);
      }
      if (!report.refused.empty())
        refused_.push_back(
            {path.string(),
             fmt::format("{}: {} of its {} records cannot be used here; the first: {}: {}",
                         path.string(), report.refused.size(),
                         report.refused.size() + report.records.size(), report.refused[0].file,
                         report.refused[0].reason)});
      taken_.insert(path);
    } catch (const Error&) {
      // told when the file is read as a record
    }
  }

  void read_file(const fs::path& path) {
    if (taken_.contains(path)) return;
    try {
      const auto [components, options] = read(path);
      const std::string folder = path.parent_path().string();
      if (components.size() > 1) return add(path.string(), path, path.stem().string(), options);
      const std::string by_name =
          name_without_component(path.filename().string(), components[0].name);
      if (!by_name.empty())
        return add(folder + "/" + by_name, path, without_ends(by_name), options);
      const std::string by_content = content_key(components[0]);
      add(by_content.empty() ? path.string() : folder + "|" + by_content, path,
          path.stem().string(), options);
    } catch (const Error& error) {
      refused_.push_back({path.string(), error.what()});
    }
  }

  Suite finish() {
    Suite suite;
    for (auto& [key, record] : records_) {
      if (record.files.size() == 1) record.name = record.files.front().path.stem().string();
      suite.records.push_back(std::move(record));
    }
    std::ranges::stable_sort(suite.records, {},
                             [](const SuiteRecord& record) { return record.files.front().path; });
    suite.refused = std::move(refused_);
    return suite;
  }

 private:
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
          // told below, if the options do not help
        }
      }
    }
    return {read_components(path, options_), options_};
  }

  void add(const std::string& key, const fs::path& path, const std::string& name,
           const ReadOptions& options) {
    SuiteRecord& record = records_[key];
    if (record.name.empty()) record.name = name;
    record.options = options;
    record.files.push_back({.path = path});
  }

  ReadOptions options_;
  bool only_where_needed_;
  std::set<fs::path> taken_;
  std::map<std::string, SuiteRecord> records_;
  std::vector<Refusal> refused_;
};

}  // namespace

std::string name_without_component(const std::string& file_name, const std::string& component) {
  std::string plain = upper(component);
  std::erase_if(plain, [](char c) { return c == '-'; });  // "E-W" is "EW" in file names
  if (plain.empty()) return {};
  const std::string extension = fs::path(file_name).extension().string();
  if (upper(extension) == "." + plain)
    return file_name.substr(0, file_name.size() - extension.size()) + "*";
  const std::string stem = file_name.substr(0, file_name.size() - extension.size());
  const std::string padded =
      all_digits(plain) && plain.size() < 3 ? std::string(3 - plain.size(), '0') + plain : plain;
  for (const std::string& text : {padded, plain})
    if (const auto at = find_apart(upper(stem), text); at != std::string::npos) {
      std::size_t begin = at;
      while (begin > 0 && kSeparators.find(stem[begin - 1]) != std::string_view::npos) --begin;
      if (begin == 0) begin = at;
      return stem.substr(0, begin) + "*" + stem.substr(at + text.size()) + extension;
    }
  return {};
}

namespace {

Suite grouped(FileGrouping grouping, const std::vector<fs::path>& files, const Progress& progress) {
  for (const fs::path& file : files)
    if (upper(file.extension().string()) == ".CSV") grouping.read_report(file);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress(i, files.size());
    grouping.read_file(files[i]);
  }
  return grouping.finish();
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

}  // namespace gurney
