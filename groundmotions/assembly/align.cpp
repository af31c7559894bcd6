#include "groundmotions/assembly/align.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "groundmotions/processing/resample.h"

namespace gurney::groundmotions {

namespace {

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

void align(Record& record) {
  if (present(record).empty()) return;
  to_one_time_step(record);
  to_one_start(record);
  to_one_length(record);
}

}  // namespace gurney::groundmotions
