#include "studies/study/data_files.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "equipment/catalogue.h"

namespace gurney {
namespace {

namespace fs = std::filesystem;
using config::Node;

class Collector {
 public:
  explicit Collector(const fs::path& job) : beside_(fs::absolute(job).parent_path()) {
    for (const DataKind kind :
         {DataKind::kItem, DataKind::kCaster, DataKind::kFloor, DataKind::kRoom, DataKind::kTether})
      for (const std::string& name : catalogue_names(kind))
        catalogue_.emplace(name, find_data(kind, name, ""));
    for (const char* file : {"contacts.toml", "levelness.toml"})
      add(fs::path(data_folder()) / "equipment" / file);
  }

  /// @param folder  that relative names in the tree start from
  void look_through(const Node& node, const fs::path& folder) {
    for (const Node& each : node.elements) look_through(each, folder);
    if (node.kind != Node::Kind::kText || node.text.empty()) return;
    const auto [first, last] = catalogue_.equal_range(node.text);
    for (auto entry = first; entry != last; ++entry) add(entry->second);
    std::error_code ignored;
    const fs::path named = folder / node.text;
    if (fs::is_regular_file(named, ignored)) add(named);
  }

  std::map<std::string, std::string> take() { return std::move(hashes_); }

 private:
  void add(const fs::path& file) {
    const fs::path path = fs::absolute(file).lexically_normal();
    if (!seen_.insert(path).second) return;
    std::ifstream stream(path, std::ios::binary);
    require(stream.is_open(), path.string() + ": cannot be read");
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    hashes_[name_of(path)] = sha256(bytes.str());
    if (path.extension() == ".toml")
      look_through(config::Document(bytes.str(), path.string()).tree(), path.parent_path());
  }

  std::string name_of(const fs::path& path) const {
    const fs::path in_catalogue =
        path.lexically_relative(fs::absolute(data_folder()).lexically_normal() / "equipment");
    if (!in_catalogue.empty() && *in_catalogue.begin() != "..")
      return (fs::path("equipment") / in_catalogue).string();
    return path.lexically_proximate(beside_.lexically_normal()).string();
  }

  fs::path beside_;
  std::multimap<std::string, std::string> catalogue_;  ///< files by name
  std::set<fs::path> seen_;
  std::map<std::string, std::string> hashes_;
};

}  // namespace

std::map<std::string, std::string> data_files(const StudyJob& job) {
  Collector collector(job.file());
  for (const Configuration& each : job.configurations())
    collector.look_through(each.tree, fs::absolute(job.file()).parent_path());
  return collector.take();
}

}  // namespace gurney
