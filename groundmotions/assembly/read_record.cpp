#include "groundmotions/assembly/read_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/base/error.h"
#include "groundmotions/assembly/align.h"
#include "groundmotions/assembly/file_name_direction.h"
#include "groundmotions/assembly/live_channels.h"
#include "groundmotions/assembly/place.h"
#include "groundmotions/assembly/record_name.h"
#include "groundmotions/assembly/site.h"
#include "groundmotions/processing/rotate.h"

namespace gurney::groundmotions {

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
  LiveChannels live = live_channels(components);
  std::vector<Component> used;
  for (const std::size_t i : live.kept) used.push_back(std::move(components[i]));
  std::ranges::move(live.warnings, std::back_inserter(used[0].warnings));
  return used;
}

std::vector<UnplacedComponent> read_files(const std::vector<RecordFile>& files,
                                          const ReadOptions& options) {
  std::vector<UnplacedComponent> components;
  std::string errors;
  for (const RecordFile& file : files) {
    try {
      for (Component& component : read_file(file, options))
        components.push_back({std::move(component), file.direction});
    } catch (const Error& error) {
      errors += fmt::format("{}{}", errors.empty() ? "" : "\n", error.what());
    }
  }
  require(errors.empty(), errors);
  return components;
}

std::string name_from(const std::vector<RecordFile>& files) {
  std::vector<std::string> stems;
  for (const RecordFile& file : files) {
    const std::string stem = file.path.stem().string();
    if (std::ranges::find(stems, stem) == stems.end()) stems.push_back(stem);
  }
  return common_name(stems);
}

/// Channels of several places are no record, unless the user says which is which.
void check_sites(const std::vector<UnplacedComponent>& components, Record& record) {
  std::set<std::string> sites;
  bool any_stated = false;
  std::string text;
  for (const auto& [component, stated] : components) {
    any_stated = any_stated || stated.has_value();
    if (sites.insert(site_of(component)).second)
      text += fmt::format("{}'{}' at '{}'", text.empty() ? "" : ", ", component.name,
                          site_of(component));
  }
  if (sites.size() < 2) return;
  text = fmt::format("{}: the components are of {} places or instruments: {}",
                     components[0].component.file, sites.size(), text);
  require(any_stated, text + "; one record is of one place: name its files or channels");
  record.warnings.push_back(text);
}

void warn_of_structure(Record& record) {
  for (const auto& component : record.components)
    if (const std::string structure = component ? structure_of(*component) : "";
        !structure.empty()) {
      record.warnings.push_back(fmt::format(
          "the sensor is in a structure ('{}'): a motion of the structure, not of the ground",
          structure));
      return;
    }
}

}  // namespace

Record read_record(const std::vector<RecordFile>& files, const ReadOptions& options) {
  require(!files.empty(), "a record needs at least one component: h1, h2 or vertical");
  std::vector<UnplacedComponent> components = read_files(files, options);
  orient_by_file_names(components);
  Record record = place(components);
  check_sites(components, record);
  warn_of_structure(record);
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

}  // namespace gurney::groundmotions
