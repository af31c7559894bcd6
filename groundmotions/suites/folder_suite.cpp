#include "groundmotions/suites/folder_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "groundmotions/suites/peer_search_results.h"

namespace gurney {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSeparators = "-_. ";

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

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
  explicit FileGrouping(const ReadOptions& options) : options_(options) {}

  void read_report(const fs::path& path) {
    try {
      const SourceFile file(path);
      if (!recognises_peer_search_results(file)) return;
      Suite report = read_peer_search_results(file, options_);
      for (SuiteRecord& record : report.records) {
        for (const RecordFile& used : record.files) taken_.insert(used.path);
        records_["0" + path.string() + fmt::format("{:06}", records_.size())] = std::move(record);
      }
      refused_.insert(refused_.end(), report.refused.begin(), report.refused.end());
      taken_.insert(path);
    } catch (const Error&) {
      // told when the file is read as a record
    }
  }

  void read_file(const fs::path& path) {
    if (taken_.contains(path)) return;
    try {
      const auto components = read_components(path, options_);
      const std::string folder = path.parent_path().string();
      if (components.size() > 1) return add(path.string(), path, path.stem().string());
      const std::string by_name =
          name_without_component(path.filename().string(), components[0].name);
      if (!by_name.empty()) return add(folder + "/" + by_name, path, without_ends(by_name));
      const std::string by_content = content_key(components[0]);
      add(by_content.empty() ? path.string() : folder + "|" + by_content, path,
          path.stem().string());
    } catch (const Error& error) {
      refused_.push_back({path.string(), error.what()});
    }
  }

  Suite finish() {
    Suite suite;
    for (auto& [key, record] : records_) suite.records.push_back(std::move(record));
    std::ranges::stable_sort(suite.records, {},
                             [](const SuiteRecord& record) { return record.files.front().path; });
    suite.refused = std::move(refused_);
    return suite;
  }

 private:
  void add(const std::string& key, const fs::path& path, const std::string& name) {
    SuiteRecord& record = records_[key];
    if (record.name.empty()) record.name = name;
    record.options = options_;
    record.files.push_back({.path = path});
  }

  ReadOptions options_;
  std::set<fs::path> taken_;
  std::map<std::string, SuiteRecord> records_;
  std::vector<Refusal> refused_;
};

}  // namespace

std::string name_without_component(const std::string& file_name, const std::string& component) {
  std::string plain = component;
  std::erase_if(plain, [](char c) { return c == '-'; });  // "E-W" is "EW" in file names
  if (plain.empty()) return {};
  const auto at = upper(file_name).rfind(upper(plain));
  if (at == std::string::npos) return {};
  std::size_t begin = at;
  while (begin > 0 && kSeparators.find(file_name[begin - 1]) != std::string_view::npos) --begin;
  if (begin == 0) begin = at;
  return file_name.substr(0, begin) + "*" + file_name.substr(at + plain.size());
}

Suite group_files(const std::vector<fs::path>& files, const ReadOptions& options,
                  const Progress& progress) {
  FileGrouping reader(options);
  for (const fs::path& file : files)
    if (upper(file.extension().string()) == ".CSV") reader.read_report(file);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (progress) progress(i, files.size());
    reader.read_file(files[i]);
  }
  return reader.finish();
}

Suite read_folder_suite(const fs::path& folder, const ReadOptions& options,
                        const Progress& progress) {
  const auto files = files_in(folder);
  require(!files.empty(), folder.string() + ": the folder holds no files");
  return group_files(files, options, progress);
}

}  // namespace gurney
