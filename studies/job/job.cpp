#include "studies/job/job.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/append_all.h"
#include "engine/base/units.h"
#include "engine/config/table.h"
#include "engine/run/overlaps.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/perturbed.h"
#include "engine/scene/scene.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/support.h"
#include "equipment/catalogue/uncertainty.h"
#include "studies/job/items_reader.h"
#include "studies/job/job_parts.h"
#include "studies/job/old_names.h"
#include "studies/job/record_reader.h"
#include "studies/job/room_reader.h"

namespace gurney::study {
namespace {

/// Notes each item that stands in another one or in the room.
/// @param positions  where the items of the job are stated
void check_overlaps(const std::vector<config::Spot>& positions, const JobParts& job,
                    equipment::Sampler& of) {
  const Scene& scene = job.scene;
  if (scene.items.size() == 1 && scene.room.empty()) return;
  for (const Overlap& overlap : find_overlaps(scene)) {
    const bool item = overlap.other_item >= 0;
    // The later of two items: the first stands where it was put.
    const std::size_t later = item ? static_cast<std::size_t>(overlap.other_item) : overlap.item;
    const std::string& other = item ? scene.items[overlap.item].name
                                    : scene.room[static_cast<std::size_t>(overlap.shape)].name;
    of.error(positions[job.owners[later]],
             fmt::format(": '{}' stands {:.0f} mm deep in '{}'", scene.items[later].name,
                         overlap.depth * kMillimetersPerMeter, other));
  }
}

std::string name_of(const PlacedItem& item) {
  return item.name.empty() ? item.model.name : item.name;
}

/// Centre of mass in plan, in item axes, of a rigid item with what stands on it; none where parts or a
/// fixture move or hold it.
std::optional<Vector2> rigid_center(const Scene& scene, std::size_t item) {
  const PlacedItem& base = scene.items[item];
  const auto free = [](const Guide& guide) { return guide.kind == Guide::Kind::kFree; };
  if (!std::ranges::all_of(base.fixture.guides, free)) return {};
  double mass = 0;
  Vector2 moment = Vector2::Zero();
  for (std::size_t i = item; i < scene.items.size(); ++i) {
    if (carrier_of(scene, i) != item) continue;
    if (joint_of(scene, i)) return {};
    const PlacedItem& each = scene.items[i];
    const MassProperties whole = whole_item(each.model);
    mass += whole.mass;
    moment += whole.mass * (each.initial.position.head<2>() +
                            Eigen::Rotation2Dd(each.initial.yaw) * whole.center_of_mass.head<2>());
  }
  if (mass == 0) return {};
  return Eigen::Rotation2Dd(-base.initial.yaw) * (moment / mass - base.initial.position.head<2>());
}

/// Notes each item that falls by itself on a level floor.
/// @param places  where the items of the job are named
void check_standing(const std::vector<config::Spot>& places, const Scene& scene,
                    equipment::Sampler& of) {
  if (scene.gravity == 0) return;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::optional<Vector2> center = rigid_center(scene, i);
    if (!center) continue;
    const PlacedItem& item = scene.items[i];
    const equipment::Margin margin = equipment::smallest_margin(
        equipment::supports_of(item.model, equipment::Swivels::kAsPlaced), *center);
    if (margin.distance < 0)
      of.error(places[i],
               fmt::format(
                   ": '{}' does not stand on its {}: its centre of mass is {:.3g} mm outside of "
                   "their support, towards {:.0f} degrees from its front; must be inside",
                   name_of(item), item.model.casters.empty() ? "feet" : "casters",
                   -margin.distance * kMillimetersPerMeter, margin.direction / kRadiansPerDegree));
  }
}

/// A warning for each item that stands in a zone at the start: the zone then counts as entered in
/// every run.
void add_warnings_of_zones(const Scene& scene, std::vector<std::string>& warnings) {
  for (const OccupiedZone& each : find_occupied_zones(scene)) {
    warnings.push_back(fmt::format(
        "zone '{}': '{}' stands in it at the start, so that every run counts as an entry",
        scene.zones[each.zone].name, name_of(scene.items[each.item])));
  }
}

/// The least box along the axes that holds a shape of the room; of a column one that its box has.
Eigen::AlignedBox3d bounds_of(const RoomShape& shape) {
  Eigen::AlignedBox3d bounds;
  const auto add = [&](const Vector3& point) {
    bounds.extend(Vector3(shape.position + shape.rotation * point));
  };
  if (const auto* hull = std::get_if<RoomHull>(&shape.shape)) {
    for (const Vector3& point : hull->points) add(point);
    return bounds;
  }
  Vector3 half;
  if (const auto* column = std::get_if<RoomColumn>(&shape.shape))
    half = {column->radius, column->radius, column->height / 2};
  else
    half = std::get<RoomBox>(shape.shape).size / 2;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1}) add(half.cwiseProduct(Vector3(x, y, z)));
  return bounds;
}

/// Items of the job that stand outside of the walls, where nothing of the room is: often a unit is wrong.
/// Walls are shapes as high as a door; they are around something where they extend both ways.
void add_warnings_of_walls(const Scene& scene, std::size_t items,
                           std::vector<std::string>& warnings) {
  constexpr double kHeight = 1.8, kAround = 1;  // [m]
  Eigen::AlignedBox2d walls;
  for (const RoomShape& shape : scene.room) {
    const Eigen::AlignedBox3d bounds = bounds_of(shape);
    if (bounds.max().z() < kHeight) continue;
    walls.extend(bounds.min().head<2>()).extend(bounds.max().head<2>());
  }
  if (walls.isEmpty() || walls.sizes().minCoeff() < kAround) return;
  for (std::size_t i = 0; i < items; ++i) {
    const Vector3& at = scene.items[i].initial.position;
    if (walls.contains(at.head<2>())) continue;
    warnings.push_back(fmt::format(
        "'{}' stands outside of the walls of the room, at ({:g}, {:g}) m: they reach from ({:.3g}, "
        "{:.3g}) m to ({:.3g}, {:.3g}) m",
        name_of(scene.items[i]), at.x(), at.y(), walls.min().x(), walls.min().y(), walls.max().x(),
        walls.max().y()));
  }
}

using config::Range;
using config::Table;

constexpr double kLongestRun = 7200;  ///< [s]; the longest records have some 20 min
constexpr double kMaxSteps = 2e7;

/// Notes each of these keys that is there, as one that `reason` leaves without effect.
void note_without_effect(Table& table, const std::vector<const char*>& keys,
                         const std::string& reason, JobReading& job) {
  for (const char* key : keys)
    if (table.has(key))
      job.add([line = fmt::format("{}: {}: has no effect {}", table.where(key), table.name_of(key),
                                  reason)](JobParts& of_draw, equipment::Sampler&) {
        of_draw.without_effect.push_back(line);
      });
}

/// The key wheels_roll of items without wheels.
void note_wheels_roll(Table& root, std::vector<Table>& items, JobReading& job) {
  const auto note = [&](Table& table, std::size_t index) {
    auto initial = table.table("initial");
    if (initial && job.stated().scene.items[index].model.casters.empty())
      note_without_effect(*initial, {"wheels_roll"}, "on an item without casters", job);
  };
  if (!root.document().clean()) return;
  for (std::size_t i = 0; i < items.size(); ++i) note(items[i], i);
  note(root, 0);
}

void read_settings(Table& root, JobReading& job) {
  auto found = root.table("settings");
  if (!found) return;
  RunOptions settings;
  Table& in = *found;
  static const std::vector<std::string> kSolvers = {"implicit", "bullet", "bullet-dantzig",
                                                    "bullet-paper", "bullet-paper-dantzig"};
  settings.solver =
      static_cast<Solver>(in.choice("solver", kSolvers, static_cast<std::size_t>(settings.solver)));
  settings.time_step =
      in.number("time_step_s", Range::within(0, 0.02).open_below(), settings.time_step);
  if (in.has("tolerance"))
    settings.tolerance = in.number("tolerance", Range::within(0, 0.1).open_below());
  if (in.has("peak_error"))
    settings.peak_error = in.number("peak_error", Range::within(0, 0.1).open_below());
  settings.residual = in.number("residual", Range::within(0, 1e-3).open_below(), settings.residual);
  settings.max_newton_iterations =
      in.integer("max_newton_iterations", 4, 1000, settings.max_newton_iterations);
  settings.max_subdivisions = in.integer("max_subdivisions", 0, 20, settings.max_subdivisions);
  settings.settle_time =
      in.number("settle_time_s", Range::within(0, kLongestRun), settings.settle_time);
  settings.duration =
      in.number("duration_s", Range::within(0, kLongestRun).open_below(), settings.duration);
  const double steps = settings.duration / settings.time_step;
  if (steps > kMaxSteps)
    in.note("duration_s",
            fmt::format(" = {:g}: takes {:g} time steps of {:g} s; must take at most {:g}",
                        settings.duration, steps, settings.time_step, kMaxSteps));
  settings.rest_speed = in.number("rest_speed_m_per_s", Range::positive(), settings.rest_speed);
  settings.rest_hold = in.number("rest_hold_s", Range::positive(), settings.rest_hold);
  if (in.has("follow_overturning")) settings.follow_overturning = in.boolean("follow_overturning");
  if (in.has("overturn_tilt_deg"))
    settings.overturn_tilt =
        in.number("overturn_tilt_deg", Range::within(0, 90).open_below().open_above()) *
        kRadiansPerDegree;
  settings.merge_held_bodies = in.boolean("merge_held_bodies", settings.merge_held_bodies);
  settings.skip_clear_collision_passes =
      in.boolean("skip_clear_collision_passes", settings.skip_clear_collision_passes);
  if (settings.solver != Solver::kImplicit)
    note_without_effect(
        in,
        {"tolerance", "peak_error", "residual", "max_newton_iterations", "max_subdivisions",
         "merge_held_bodies", "skip_clear_collision_passes"},
        "with the solver \"" + kSolvers[static_cast<std::size_t>(settings.solver)] + "\"", job);
  std::vector<std::string> warnings;
  for (const char* key : {"settle_time_s", "rest_speed_m_per_s", "rest_hold_s"})
    if (settings.duration > 0 && in.has(key))
      warnings.push_back(in.name_of(key) + ": no effect beside duration_s, which ends the run");
  job.add([settings, warnings](JobParts& of_draw, equipment::Sampler&) {
    of_draw.settings = settings;
    append_all(of_draw.warnings, warnings);
  });
}

void read_output(Table& root, JobReading& job) {
  auto table = root.table("output");
  if (!table) return;
  const SimulationSettings& settings = job.stated().settings;
  const bool histories = table->boolean("histories", true);
  const double spacing = table->number("history_step_s", Range::positive(), settings.history_step);
  const double steps = std::max(1.0, std::round(spacing / settings.time_step));
  const double whole = steps * settings.time_step;
  if (table->has("history_step_s") && std::abs(spacing - whole) > 1e-6 * spacing)
    table->note("history_step_s",
                fmt::format(" = {:g}: must be a whole number of time steps of {:g} s, such as {:g}",
                            spacing, settings.time_step, whole));
  job.add([step = histories ? whole : 0](JobParts& of_draw, equipment::Sampler&) {
    of_draw.settings.history_step = step;
  });
  if (!histories) note_without_effect(*table, {"history_step_s"}, "with histories = false", job);
}

/// A member of the scene.
template <class Value>
auto scene(Value Scene::*member) {
  return [member](JobParts& job) -> Value& { return job.scene.*member; };
}

/// How far the floor is out of level where the job does not state it.
void use_levelness(JobReading& job) {
  job.add([usual = equipment::usual_levelness()](JobParts& of_draw, equipment::Sampler& of) {
    const equipment::Levelness level = usual.sample(of.of_part("floor"));
    of_draw.scene.slope = level.slope;
    of_draw.scene.cross_slope = level.cross_slope;
    add_assumptions(of_draw.assumptions, level.assumptions);
  });
}

void read_floor(Table& root, JobReading& job) {
  auto table = root.table("floor");
  const bool stated = table && (table->has("slope") || table->has("cross_slope"));
  if (!stated) use_levelness(job);
  if (!table) return;
  equipment::Quantities in(*table);
  if (stated) {
    job.set(scene(&Scene::slope), in.number("slope", Range::within(-1, 1), 0.0));
    job.set(scene(&Scene::cross_slope), in.number("cross_slope", Range::within(-1, 1), 0.0));
  }
  job.set(scene(&Scene::gravity),
          in.number("gravity_m_per_s2", Range::not_negative(), Scene().gravity));
  if (auto covering = load_named(*table, "covering", equipment::DataKind::kFloor,
                                 equipment::load_floor_covering))
    job.add([covering = *std::move(covering)](JobParts& of_draw, equipment::Sampler& of) {
      of_draw.covering = covering.sample(of.of_part("floor"));
    });
}

/// On the rotation of the building's floors.
void read_rotation_factor(Table& excitation, JobReading& job) {
  auto building = excitation.table("building");
  if (!building) return;
  job.set(&JobParts::rotation_factor,
          equipment::Quantities(*building).number("rotation_factor", Range::not_negative(), 1.0));
  const std::optional<RecordRequest>& record = job.stated().record;
  if (!record || !record->building) return;
  if (!rocks(record->building->building, record->building->floor))
    note_without_effect(*building, {"rotation_factor"},
                        "on a floor that does not rotate: the building has no floor_rotation", job);
  if (record->building->building.torsion.empty())
    note_without_effect(*building, {"position_m"},
                        "on a floor that does not twist: the building has no torsion", job);
}

std::optional<Draw> read_draw(Table& root) {
  constexpr int kMax = std::numeric_limits<int>::max();
  auto table = root.table("uncertainty");
  if (!table) return {};
  const int seed = table->integer("seed", 0, kMax, 1);
  return Draw(static_cast<std::uint64_t>(seed),
              static_cast<std::uint64_t>(table->integer("draw", 0, kMax)));
}

/// Keys at the top of a file that belong into one of its tables.
void note_misplaced(config::Document& document) {
  constexpr std::pair<const char*, const char*> kPlaces[] = {
      {"record", "excitation"},      {"building", "excitation"}, {"force", "excitation"},
      {"drop_weight", "excitation"}, {"covering", "floor"},      {"slope", "floor"},
      {"equipment", "item"},         {"brakes", "item"},         {"casters", "item"},
      {"position_m", "item"},        {"duration_s", "settings"}, {"time_step_s", "settings"},
      {"limit_state", "study"},      {"factor", "study"},        {"intensity", "study"},
      {"replicas", "study"},         {"draws", "study"}};
  for (const auto& [key, table] : kPlaces)
    if (const auto found = document.take(key))
      document.note(found->key_place,
                    fmt::format("{0}: unknown key; did you mean '{1}.{0}'?", key, table));
}

JobReading read(config::Document& document) {
  equipment::refuse_other_kind(document, "gurney-job/1");
  note_misplaced(document);
  std::vector<std::string> notes = rename_old_keys(document);
  Table root = document.root();
  root.choice("schema", {"gurney-job/1"});
  document.tree().asked.insert("study");  // is read by StudyJob
  JobParts fixed;
  fixed.file = document.path();
  fixed.text = document.text();
  fixed.title = root.text("title", "");
  fixed.warnings = std::move(notes);
  JobReading job(std::move(fixed));

  read_floor(root, job);
  equipment::RoomNames names;
  read_job_room(root, names, job);
  std::vector<Table> items = read_items(root, names.shapes, job);
  unfold_items(job);
  const bool stands = document.clean();
  const TetherSpots tethers = read_tethers(root, job);
  if (auto table = root.table("excitation")) {
    job.add([record = read_record_request(*table)](JobParts& of_draw, equipment::Sampler&) {
      of_draw.record = record;
    });
    read_rotation_factor(*table, job);
  }
  read_acting_at_top(root, job);
  read_settings(root, job);
  read_output(root, job);
  note_wheels_roll(root, items, job);
  furnish(root, items, job);
  read_supports(items, job);
  place_unfolded(job);
  if (stands) check_tethers(tethers, document, job);
  if (document.clean()) {
    std::vector<config::Spot> positions, places;
    for (const Table& item : items) {
      positions.push_back(item.spot("position_m"));
      places.push_back(item.spot("equipment"));
    }
    job.add(document, [positions, places](JobParts& of_draw, equipment::Sampler& of) {
      if (of.clean()) check_overlaps(positions, of_draw, of);
      if (of.clean()) check_standing(places, of_draw.scene, of);
      if (!of.clean()) return;
      add_warnings_of_zones(of_draw.scene, of_draw.warnings);
      add_warnings_of_walls(of_draw.scene, positions.size(), of_draw.warnings);
    });
  }
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
  const JobReading reading = read(document);
  const std::optional<Draw> draw = read_draw(root);
  Job job = reading.stated();
  note_lines(document, job.without_effect);
  if (document.clean() && draw) {
    try {
      job = sample(reading, draw);
      if (!draws_anything(job))
        root.note("uncertainty", ": has no effect: no parameter of the job has a distribution");
    } catch (const Error& error) {
      document.note(error);
    }
  }
  document.finish();
  job.draw = draw;
  return job;
}

JobModel::JobModel(config::Document& document)
    : reading_(std::make_shared<const JobReading>(read(document))) {
  document.finish();
}

const Job& JobModel::stated() const { return reading_->stated(); }

Job sample(const JobModel& model, const std::optional<Draw>& draw, std::size_t replica) {
  Job job = sample(*model.reading_, draw);
  job.draw = draw;
  job.scene = replica_of(std::move(job.scene), replica);
  return job;
}

}  // namespace gurney::study
