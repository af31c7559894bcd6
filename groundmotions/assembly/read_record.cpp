#include "groundmotions/assembly/read_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "groundmotions/assembly/align.h"
#include "groundmotions/assembly/place.h"
#include "groundmotions/processing/rotate.h"

namespace gurney {

namespace {

/// The components to take from one file.
std::vector<Component> read_file(const RecordFile& file, const ReadOptions& options) {
  auto components = read_components(file.path, options);
  const auto count = components.size();
  if (file.channel) {
    require(*file.channel >= 1 && static_cast<std::size_t>(*file.channel) <= count,
            fmt::format("{}: channel {} was asked for, the file has 1 to {}", file.path.string(),
                        *file.channel, count));
    return {components[static_cast<std::size_t>(*file.channel) - 1]};
  }
  require(!file.direction || count == 1,
          fmt::format("{}: given as {}, but the file holds {} components", file.path.string(),
                      file.direction ? name_of(*file.direction) : "", count));
  return components;
}

std::vector<UnplacedComponent> read_files(const std::vector<RecordFile>& files,
                                          const ReadOptions& options) {
  std::vector<UnplacedComponent> components;
  std::string mistakes;
  for (const RecordFile& file : files) {
    try {
      for (Component& component : read_file(file, options))
        components.push_back({std::move(component), file.direction});
    } catch (const Error& error) {
      mistakes += fmt::format("{}{}", mistakes.empty() ? "" : "\n", error.what());
    }
  }
  require(mistakes.empty(), mistakes);
  return components;
}

/// What all begin with, without separators at its end; empty if that says little.
std::string common_beginning(const std::vector<std::string>& names) {
  constexpr std::size_t kFewestLetters = 4;
  std::string common = names.front();
  for (const std::string& name : names) {
    const auto [end, other] = std::ranges::mismatch(common, name);
    common.erase(end, common.end());
  }
  common.erase(common.find_last_not_of("-_. ") + 1);
  return common.size() < kFewestLetters ? "" : common;
}

std::string name_from(const std::vector<RecordFile>& files) {
  std::vector<std::string> stems;
  for (const RecordFile& file : files) {
    const std::string stem = file.path.stem().string();
    if (std::ranges::find(stems, stem) == stems.end()) stems.push_back(stem);
  }
  const std::string common = common_beginning(stems);
  return common.empty() ? fmt::format("{}", fmt::join(stems, " + ")) : common;
}

}  // namespace

Record read_record(const std::vector<RecordFile>& files, const ReadOptions& options) {
  require(!files.empty(), "a record needs at least one component: h1, h2 or vertical");
  Record record = place(read_files(files, options));
  record.name = name_from(files);
  std::vector<std::string> warnings;
  for (const auto& component : record.components)
    if (component)
      warnings.insert(warnings.end(), component->warnings.begin(), component->warnings.end());
  record.warnings.insert(record.warnings.begin(), warnings.begin(), warnings.end());
  align(record);
  if (std::ranges::none_of(files,
                           [](const RecordFile& file) { return file.direction.has_value(); })) {
    record = orthogonal_horizontals(std::move(record));
    record.warnings.insert(record.warnings.end(), record.processing.begin(),
                           record.processing.end());
  }
  const bool moves = std::ranges::any_of(record.components, [](const auto& component) {
    return component && (component->acceleration.array() != 0).any();
  });
  require(moves, fmt::format("{}: all accelerations of the record are zero", record.name));
  return record;
}

}  // namespace gurney
