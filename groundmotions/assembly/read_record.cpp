#include "groundmotions/assembly/read_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "groundmotions/assembly/file_names.h"
#include "groundmotions/assembly/place.h"
#include "groundmotions/assembly/site.h"
#include "groundmotions/processing/resample.h"
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

using Indices = std::vector<std::size_t>;

bool is_vertical(const Component& channel) {
  return channel.direction == Direction::kVertical ||
         (!channel.azimuth && sounds_vertical(channel.name));
}

bool all_zero(const Component& channel) { return (channel.acceleration.array() == 0).all(); }

bool has_places_for(const std::vector<Component>& channels, const Indices& kept) {
  const auto verticals =
      std::ranges::count_if(kept, [&](std::size_t i) { return is_vertical(channels[i]); });
  return !kept.empty() && verticals <= 1 && std::ssize(kept) - verticals <= 2;
}

template <class Keep>
LiveChannels filtered(const std::vector<Component>& channels, const char* reason, Keep keep) {
  LiveChannels result;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (keep(channels[i]))
      result.kept.push_back(i);
    else
      result.warnings.push_back(fmt::format("{}: channel {} ('{}') {}: not used", channels[i].file,
                                            i + 1, channels[i].name, reason));
  return result;
}

std::vector<Component*> present(Record& record) {
  std::vector<Component*> components;
  for (auto& component : record.components)
    if (component) components.push_back(&*component);
  return components;
}

void to_one_time_step(Record& record) {
  const auto components = present(record);
  const double smallest =
      (*std::ranges::min_element(components, {}, &Component::time_step))->time_step;
  for (Component* component : components) {
    if (component->time_step - smallest <= 1e-6 * smallest) continue;
    record.warnings.push_back(
        fmt::format("{}: a time step of {:g} s, resampled to {:g} s as the other components have",
                    component->file, component->time_step, smallest));
    component->acceleration = resampled(component->time_step, component->acceleration, smallest);
    component->time_step = smallest;
  }
}

/// Whether all starts are known; a warning if only some are.
bool have_starts(const std::vector<Component*>& components, Record& record) {
  const auto known =
      std::ranges::count_if(components, [](auto* c) { return c->start_time.has_value(); });
  if (known == std::ssize(components)) return true;
  if (known > 0)
    for (const Component* component : components)
      if (!component->start_time)
        record.warnings.push_back(fmt::format(
            "{}: states no start, as other components do: all are taken to start at the same time",
            component->file));
  return false;
}

void to_one_start(Record& record) {
  constexpr double kSlack = 0.01;  // of a step
  const auto components = present(record);
  if (!have_starts(components, record)) return;
  double earliest = *components.front()->start_time, shortest = components.front()->duration();
  for (const Component* component : components) {
    earliest = std::min(earliest, *component->start_time);
    shortest = std::min(shortest, component->duration());
  }
  for (Component* component : components) {
    const double late = *component->start_time - earliest;
    require(late < shortest,
            fmt::format("{}: starts {:.6g} s after the first component, which is longer than the "
                        "shortest ({:.6g} s): these are not of one earthquake",
                        component->file, late, shortest));
    const auto zeros = static_cast<Eigen::Index>(std::lround(late / component->time_step));
    const double rest = late - static_cast<double>(zeros) * component->time_step;
    const bool is_even = std::abs(rest) <= kSlack * component->time_step;
    if (zeros > 0 || !is_even)
      record.warnings.push_back(fmt::format(
          "{}: starts {:.6g} s after the first component: {} zeros added before it{}",
          component->file, late, zeros, is_even ? "" : fmt::format(", {:.2g} s are left", rest)));
    if (zeros == 0) continue;
    Eigen::VectorXd padded(component->acceleration.size() + zeros);
    padded << Eigen::VectorXd::Zero(zeros), component->acceleration;
    component->acceleration = std::move(padded);
    component->start_time = earliest;
  }
}

void to_one_length(Record& record) {
  Eigen::Index longest = 0;
  for (const Component* component : present(record))
    longest = std::max(longest, component->acceleration.size());
  for (Component* component : present(record)) {
    const Eigen::Index own = component->acceleration.size();
    if (own == longest) continue;
    record.warnings.push_back(
        fmt::format("{}: {} samples, the longest component has {}: {} zeros added at the end",
                    component->file, own, longest, longest - own));
    component->acceleration.conservativeResize(longest);
    component->acceleration.tail(longest - own).setZero();
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
    if (component) append_all(warnings, component->warnings);
  record.warnings.insert(record.warnings.begin(), warnings.begin(), warnings.end());
  align(record);
  if (std::ranges::none_of(files,
                           [](const RecordFile& file) { return file.direction.has_value(); })) {
    record = orthogonal_horizontals(std::move(record));
    append_all(record.warnings, record.processing);
  }
  const bool moves = std::ranges::any_of(record.components, [](const auto& component) {
    return component && (component->acceleration.array() != 0).any();
  });
  require(moves, fmt::format("{}: all accelerations of the record are zero", record.name));
  return record;
}

LiveChannels live_channels(const std::vector<Component>& channels) {
  LiveChannels all;
  all.kept.resize(channels.size());
  std::iota(all.kept.begin(), all.kept.end(), 0);
  if (has_places_for(channels, all.kept)) return all;
  LiveChannels moving = filtered(channels, "is all zero",
                                 [](const Component& channel) { return !all_zero(channel); });
  if (has_places_for(channels, moving.kept)) return moving;
  LiveChannels axes = filtered(channels, "is no axis of the motion", [](const Component& channel) {
    return channel.azimuth.has_value() || is_vertical(channel);
  });
  const auto azimuths = std::ranges::count_if(
      axes.kept, [&](std::size_t i) { return channels[i].azimuth.has_value(); });
  return azimuths == 2 && has_places_for(channels, axes.kept) ? axes : all;
}

void align(Record& record) {
  if (present(record).empty()) return;
  to_one_time_step(record);
  to_one_start(record);
  to_one_length(record);
}

}  // namespace gurney::groundmotions
