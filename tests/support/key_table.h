#pragma once

#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace gurney {

/// Keys of the tables of a page of docs/formats: rows that start with "| `key`" or "| `key`, `key`",
/// below the heading `## section`, or of the whole page if `section` is empty.
inline std::set<std::string> documented_keys(const std::string& page, const std::string& section) {
  std::ifstream in(page);
  std::set<std::string> keys;
  bool inside = section.empty();
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("## ", 0) == 0) inside = section.empty() || line == "## " + section;
    if (!inside || line.rfind("| `", 0) != 0) continue;
    const std::string names = line.substr(0, line.find('|', 1));
    for (std::size_t at = names.find('`'); at != names.npos; at = names.find('`', at + 1)) {
      const std::size_t begin = at + 1;
      at = names.find('`', begin);
      keys.insert(names.substr(begin, at - begin));
    }
  }
  return keys;
}

/// Keys a reader asked for, without those inside a quantity.
inline std::set<std::string> without_provenance(const std::vector<std::string>& keys) {
  std::set<std::string> kept;
  for (const std::string& key : keys) {
    const std::string last = key.substr(key.rfind('.') + 1);
    static const std::set<std::string> kInner = {"value", "source", "assumption",  "range",
                                                 "low",   "high",   "distribution"};
    if (kInner.count(last) == 0) kept.insert(key);
  }
  return kept;
}

}  // namespace gurney
