#include "groundmotions/record_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"

namespace gurney {

namespace {

constexpr double kSmallestPeak = 0.001 * kStandardGravity;
constexpr double kLargestPeak = 3 * kStandardGravity;

void place(Component component, std::optional<Direction> stated, std::size_t in_file,
           Record& record) {
  const auto& own = component.direction;
  require(own || stated,
          fmt::format("{}: the file does not say whether it is h1, h2 or vertical; state it",
                      component.file));
  require(!stated || in_file == 1,
          fmt::format("{}: given as {}, but the file holds {} components", component.file,
                      stated ? name_of(*stated) : "", in_file));
  require(!own || !stated || *own == *stated,
          fmt::format("{}: given as {}, but its column {} is {}", component.file,
                      stated ? name_of(*stated) : "", component.name, own ? name_of(*own) : ""));
  const Direction direction = stated ? *stated : *own;
  auto& slot = record.components[static_cast<std::size_t>(direction)];
  require(!slot, fmt::format("{}: a second {} component, after {}", component.file,
                             name_of(direction), slot ? slot->file : ""));
  component.direction = direction;
  slot = std::move(component);
}

/// Every pair, so that each file that differs from the first is named.
void require_one_time_step(const Record& record) {
  const Component* first = nullptr;
  for (const auto& component : record.components) {
    if (!component) continue;
    if (!first) first = &*component;
    require(
        std::abs(component->time_step - first->time_step) <= 1e-6 * first->time_step,
        fmt::format("components of one record must have one time step: {} has {} s, {} has {} s",
                    first->file, first->time_step, component->file, component->time_step));
  }
}

void fill_to_one_length(Record& record) {
  Eigen::Index longest = 0;
  for (const auto& component : record.components)
    if (component) longest = std::max(longest, component->acceleration.size());
  for (auto& component : record.components) {
    if (!component || component->acceleration.size() == longest) continue;
    const Eigen::Index own = component->acceleration.size();
    record.warnings.push_back(
        fmt::format("{}: {} samples, the longest component has {}: {} zeros added at the end",
                    component->file, own, longest, longest - own));
    component->acceleration.conservativeResize(longest);
    component->acceleration.tail(longest - own).setZero();
  }
}

bool sounds_vertical(std::string name) {
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name == "UP" || name == "DWN" || name == "DOWN" || name == "V" || name == "VER" ||
         name == "VERT" || name == "Z" || name == "UD";
}

void warn_of_places(Record& record) {
  for (const auto& component : record.components) {
    if (!component || component->format == "columns CSV") continue;
    const bool vertical = component->direction == Direction::kVertical;
    if (vertical ? component->azimuth.has_value() : sounds_vertical(component->name))
      record.warnings.push_back(
          fmt::format("{}: the file calls this component '{}', it is used as {}", component->file,
                      component->name, name_of(*component->direction)));
  }
  const auto& h1 = record[Direction::kH1];
  const auto& h2 = record[Direction::kH2];
  if (h1 && h2 && h1->azimuth && h2->azimuth &&
      std::abs(std::cos(*h2->azimuth - *h1->azimuth)) > std::sin(1 * kRadiansPerDegree))
    record.warnings.push_back(fmt::format(
        "the horizontal components have azimuths of {:.0f} and {:.0f} degrees, which is no right "
        "angle; they are used as if it were",
        *h1->azimuth / kRadiansPerDegree, *h2->azimuth / kRadiansPerDegree));
}

void check_peaks(Record& record) {
  bool moves = false;
  for (const auto& component : record.components) {
    if (!component) continue;
    const double peak = component->acceleration.cwiseAbs().maxCoeff();
    moves = moves || peak > 0;
    if (peak == 0)
      record.warnings.push_back(fmt::format("{}: the {} component is all zero", component->file,
                                            name_of(*component->direction)));
    else if (peak < kSmallestPeak || peak > kLargestPeak)
      record.warnings.push_back(fmt::format(
          "{}: the peak acceleration of {} is {:.3g} g, outside 0.001 to 3 g; check the "
          "unit ({})",
          component->file, name_of(*component->direction), peak / kStandardGravity,
          component->unit));
  }
  require(moves, fmt::format("{}: all accelerations of the record are zero", record.name));
}

std::string name_from(const std::vector<RecordFile>& files) {
  std::string name;
  for (const RecordFile& file : files)
    name += (name.empty() ? "" : " + ") + file.path.stem().string();
  return name;
}

}  // namespace

Record read_record(const std::vector<RecordFile>& files, const ReadOptions& options) {
  require(!files.empty(), "a record needs at least one component: h1, h2 or vertical");
  Record record;
  record.name = name_from(files);
  std::string mistakes;
  for (const RecordFile& file : files) {
    try {
      auto components = read_components(file.path, options);
      const std::size_t count = components.size();
      for (Component& component : components)
        place(std::move(component), file.direction, count, record);
    } catch (const Error& error) {
      mistakes += fmt::format("{}{}", mistakes.empty() ? "" : "\n", error.what());
    }
  }
  require(mistakes.empty(), mistakes);
  for (const auto& component : record.components)
    if (component)
      record.warnings.insert(record.warnings.end(), component->warnings.begin(),
                             component->warnings.end());
  require_one_time_step(record);
  fill_to_one_length(record);
  warn_of_places(record);
  check_peaks(record);
  return record;
}

}  // namespace gurney
