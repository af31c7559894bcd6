#include "studies/explanation/stages.h"

#include <algorithm>

namespace gurney::explanation {
namespace {

Stage stage_at(const std::string& name, double time, const std::vector<Sample>& history) {
  constexpr double kSame = 1e-9;  // [s]
  const auto after = std::ranges::upper_bound(history, time + kSame, {}, &Sample::time);
  const Sample& sample = after == history.begin() ? history.front() : *std::prev(after);
  const EnergyAccount& e = sample.energy;
  return {.name = name,
          .time = time,
          .kinetic = e.kinetic,
          .potential = e.gravitational,
          .elastic = e.elastic + e.weight_energy,
          .floor_work = e.work_of_floor,
          .other_work = e.work() - e.work_of_floor,
          .friction = e.sliding_loss + e.relaxation_loss + e.tread_loss,
          .rolling = e.rolling_loss + e.axle_loss + e.swivel_loss,
          .impacts = e.contact_loss,
          .other_loss = e.damper_loss + e.numerical_loss};
}

const char* stage_name(EventKind kind) {
  switch (kind) {
    case EventKind::kMoved:
      return "slides or rolls";
    case EventKind::kGripExceeded:
      return "brakes skid";
    case EventKind::kLiftOff:
      return "casters lift";
    case EventKind::kTipped:
      return "tips";
    case EventKind::kImpact:
      return "first impact";
    case EventKind::kPeakDisplacement:
      return "farthest";
    case EventKind::kPeakTilt:
      return "largest tilt";
    case EventKind::kOverturned:
      return "overturned";
    default:
      return nullptr;
  }
}

}  // namespace

std::vector<Stage> stages_of(const Explanation& of, const ItemResponse& item) {
  const std::vector<Sample>& history = item.history;
  if (history.empty()) return {};
  std::vector<Stage> stages{stage_at("start", history.front().time, history)};
  for (const Event& event : of.events) {
    const char* const name = stage_name(event.kind);
    if (name == nullptr || event.item != of.item().name) continue;
    if (std::ranges::find(stages, name, &Stage::name) != stages.end()) continue;
    stages.push_back(stage_at(name, event.time, history));
  }
  if (of.hit && of.hit->time > stages.back().time)
    stages.push_back(stage_at("hardest impact", of.hit->time, history));
  std::ranges::stable_sort(stages, {}, &Stage::time);
  stages.push_back(stage_at("end", of.end_time, history));
  const double at_rest = stages.front().elastic;
  for (Stage& stage : stages) stage.elastic -= at_rest;
  return stages;
}

}  // namespace gurney::explanation
