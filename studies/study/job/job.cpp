#include "studies/study/job/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "engine/base/units.h"
#include "engine/config/table.h"
#include "equipment/catalogue/file_kind.h"
#include "equipment/catalogue/levelness.h"
#include "equipment/catalogue/quantity.h"
#include "studies/study/job/item_reader.h"
#include "studies/study/job/items_reader.h"
#include "studies/study/job/overlap_check.h"
#include "studies/study/job/record_reader.h"
#include "studies/study/job/room_reader.h"
#include "studies/study/job/tether_reader.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

constexpr double kLongestRun = 7200;  ///< [s]; the longest records have some 20 min
constexpr double kMostSteps = 2e7;

/// Notes each of these keys that is there, as one that `reason` leaves without effect.
void note_without_effect(Table& table, const std::vector<const char*>& keys,
                         const std::string& reason, Job& job) {
  for (const char* key : keys)
    if (table.has(key))
      job.without_effect.push_back(
          fmt::format("{}: {}: has no effect {}", table.where(key), table.name_of(key), reason));
}

/// The key wheels_roll of items without wheels.
void note_wheels_roll(Table& root, std::vector<JobItem>& items, Job& job) {
  const auto note = [&](Table& table, const EquipmentModel& model) {
    auto initial = table.table("initial");
    if (initial && model.casters.empty())
      note_without_effect(*initial, {"wheels_roll"}, "on an item without casters", job);
  };
  if (!root.document().clean()) return;
  for (std::size_t i = 0; i < items.size(); ++i) note(items[i].table, job.scene.items[i].model);
  note(root, job.scene.items.front().model);
}

void read_settings(Table& root, Job& job) {
  auto found = root.table("settings");
  if (!found) return;
  SimulationSettings& settings = job.settings;
  Table& in = *found;
  static const std::vector<std::string> kSolvers = {"star", "bullet", "bullet-dantzig",
                                                    "bullet-paper", "bullet-paper-dantzig"};
  settings.solver =
      static_cast<Solver>(in.choice("solver", kSolvers, static_cast<std::size_t>(settings.solver)));
  settings.time_step =
      in.number("time_step_s", Range::within(0, 0.02).open_below(), settings.time_step);
  settings.residual = in.number("residual", Range::within(0, 1e-3).open_below(), settings.residual);
  settings.max_newton_iterations =
      in.integer("max_newton_iterations", 4, 1000, settings.max_newton_iterations);
  settings.max_subdivisions = in.integer("max_subdivisions", 0, 20, settings.max_subdivisions);
  settings.settle_time =
      in.number("settle_time_s", Range::within(0, kLongestRun), settings.settle_time);
  settings.duration =
      in.number("duration_s", Range::within(0, kLongestRun).open_below(), settings.duration);
  const double steps = settings.duration / settings.time_step;
  if (steps > kMostSteps)
    in.note("duration_s",
            fmt::format(" = {:g}: takes {:g} time steps of {:g} s; must take at most {:g}",
                        settings.duration, steps, settings.time_step, kMostSteps));
  settings.rest_speed = in.number("rest_speed_m_per_s", Range::positive(), settings.rest_speed);
  settings.rest_hold = in.number("rest_hold_s", Range::positive(), settings.rest_hold);
  if (in.has("follow_overturning")) settings.follow_overturning = in.boolean("follow_overturning");
  if (in.has("overturn_tilt_deg"))
    settings.overturn_tilt =
        in.number("overturn_tilt_deg", Range::within(0, 90).open_below().open_above()) *
        kRadiansPerDegree;
  settings.skip_clear_collision_passes =
      in.boolean("skip_clear_collision_passes", settings.skip_clear_collision_passes);
  if (settings.solver != Solver::kStar)
    note_without_effect(
        in,
        {"residual", "max_newton_iterations", "max_subdivisions", "skip_clear_collision_passes"},
        "with the solver \"" + kSolvers[static_cast<std::size_t>(settings.solver)] + "\"", job);
  for (const char* key : {"settle_time_s", "rest_speed_m_per_s", "rest_hold_s"})
    if (settings.duration > 0 && in.has(key))
      job.warnings.push_back(in.name_of(key) + ": no effect beside duration_s, which ends the run");
}

void read_output(Table& root, Job& job) {
  auto table = root.table("output");
  if (!table) return;
  SimulationSettings& settings = job.settings;
  const bool histories = table->boolean("histories", true);
  const double spacing = table->number("history_step_s", Range::positive(), settings.history_step);
  const double steps = std::max(1.0, std::round(spacing / settings.time_step));
  const double whole = steps * settings.time_step;
  if (table->has("history_step_s") && std::abs(spacing - whole) > 1e-6 * spacing)
    table->note("history_step_s",
                fmt::format(" = {:g}: must be a whole number of time steps of {:g} s, such as {:g}",
                            spacing, settings.time_step, whole));
  settings.history_step = histories ? whole : 0;
  if (!histories) note_without_effect(*table, {"history_step_s"}, "with histories = false", job);
}

/// How far the floor is out of level where the job does not say.
void use_levelness(std::optional<Draw> draw, std::vector<equipment::Assumption>& assumptions,
                   Scene& scene) {
  if (draw) draw = draw->of_part("floor");
  const equipment::Levelness usual = equipment::usual_levelness(draw);
  scene.slope = usual.slope;
  scene.cross_slope = usual.cross_slope;
  equipment::add_assumptions(assumptions, usual.assumptions);
}

std::optional<equipment::FloorCovering> read_floor(Table& root,
                                                   std::vector<equipment::Assumption>& assumptions,
                                                   Scene& scene) {
  auto table = root.table("floor");
  const bool stated = table && (table->has("slope") || table->has("cross_slope"));
  if (!stated) use_levelness(root.document().draw(), assumptions, scene);
  if (!table) return {};
  equipment::Quantities in(*table, assumptions);
  scene.slope = in.number("slope", Range::within(-1, 1), scene.slope);
  scene.cross_slope = in.number("cross_slope", Range::within(-1, 1), scene.cross_slope);
  scene.gravity = in.number("gravity_m_per_s2", Range::not_negative(), scene.gravity);
  return read_floor_covering(*table);
}

/// On the rotation of the building's floors.
void read_rotation_factor(Table& excitation, Job& job) {
  auto building = excitation.table("building");
  if (!building) return;
  equipment::Quantities in(*building, job.assumptions);
  job.rotation_factor = in.number("rotation_factor", Range::not_negative(), 1.0);
  if (job.record && job.record->building &&
      !groundmotions::rotates(job.record->building->building, job.record->building->floor))
    note_without_effect(*building, {"rotation_factor"},
                        "on a floor that does not rotate: the building has no floor_rotation", job);
}

std::optional<Draw> read_draw(Table& root) {
  constexpr int kMost = std::numeric_limits<int>::max();
  auto table = root.table("uncertainty");
  if (!table) return {};
  const int seed = table->integer("seed", 0, kMost, 1);
  return Draw(static_cast<std::uint64_t>(seed),
              static_cast<std::uint64_t>(table->integer("draw", 0, kMost)));
}

Job read(config::Document& document, const std::optional<Draw>& draw) {
  Job job;
  job.file = document.path();
  job.text = document.text();
  equipment::refuse_other_kind(document, "gurney-job/1");
  Table root = document.root();
  root.choice("schema", {"gurney-job/1"});
  document.tree().asked.insert("study");  // is read by StudyJob
  job.title = root.text("title", "");
  job.draw = draw;
  document.set_draw(draw);

  const std::optional<equipment::FloorCovering> covering =
      read_floor(root, job.assumptions, job.scene);
  equipment::RoomNames names;
  equipment::RoomDescription room = read_job_room(root, names);
  std::vector<JobItem> items = read_items(root, covering, names.shapes, job);
  read_tethers(root, room.points, job);
  if (auto table = root.table("excitation")) {
    job.record = read_record_request(*table);
    read_rotation_factor(*table, job);
  }
  read_acting_at_top(root, job);
  read_settings(root, job);
  read_output(root, job);
  note_wheels_roll(root, items, job);
  furnish(root, items, std::move(room), job);
  if (document.clean()) check_overlaps(items, job.scene);
  return job;
}

void note_lines(config::Document& document, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) document.note(Error(line));
}

}  // namespace

bool draws_anything(const Job& job) {
  return std::ranges::any_of(job.assumptions, [](const equipment::Assumption& each) {
    return !each.distribution.empty();
  });
}

Job read_job(const std::string& path) {
  config::Document document(path);
  return read_job(document);
}

Job read_job(config::Document& document) {
  Table root = document.root();
  Job job = read(document, read_draw(root));
  note_lines(document, job.without_effect);
  if (document.clean() && job.draw && !draws_anything(job))
    root.note("uncertainty", ": has no effect: no number of the job has a distribution");
  document.finish();
  return job;
}

Job read_study_job(config::Document& document, const std::optional<Draw>& draw) {
  Job job = read(document, draw);
  document.finish();
  return job;
}

}  // namespace gurney::study
