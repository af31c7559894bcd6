#include "studies/plan/undrawn_ranges.h"

#include <fmt/format.h>

#include <algorithm>

namespace gurney::study {
namespace {

std::string parameter_of(std::string key) {
  for (std::size_t at = key.find('['); at != std::string::npos; at = key.find('[', at + 2))
    key.erase(at + 1, key.find(']', at) - at - 1);
  const bool has_axis = key.size() > 2 && key[key.size() - 2] == '.';
  return has_axis ? key.substr(0, key.size() - 2) : key;
}

}  // namespace

void UndrawnRanges::add(const std::string& file, const std::string& key) {
  auto found = std::ranges::find(files_, file, &OfFile::name);
  if (found == files_.end()) found = files_.insert(files_.end(), {file, {}});
  const std::string parameter = parameter_of(key);
  if (std::ranges::find(found->parameters, parameter) == found->parameters.end())
    found->parameters.push_back(parameter);
}

std::vector<std::string> UndrawnRanges::lines() const {
  std::vector<std::string> lines;
  for (const OfFile& file : files_)
    lines.push_back(fmt::format("{}: {}", file.name, fmt::join(file.parameters, ", ")));
  return lines;
}

std::size_t UndrawnRanges::parameters() const {
  std::size_t count = 0;
  for (const OfFile& file : files_) count += file.parameters.size();
  return count;
}

}  // namespace gurney::study
