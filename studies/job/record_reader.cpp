#include "studies/job/record_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/file_snapshot.h"
#include "equipment/catalogue/catalogue.h"
#include "groundmotions/buildings/building.h"
#include "groundmotions/processing/pipeline.h"
#include "groundmotions/record/acceleration_unit.h"
#include "groundmotions/record/record.h"
#include "groundmotions/suites/suite.h"
#include "studies/job/scale_reader.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

namespace fs = std::filesystem;

constexpr std::array kAxes = {"x", "y", "z"};
constexpr const char* kSuiteByLevel = "suite_by_level";

/// Relative to the folder of the job; noted where nothing is there.
fs::path existing_path(Table& table, const std::string& key, const std::string& name) {
  const fs::path path = (fs::path(table.document().path()).parent_path() / name).lexically_normal();
  if (!config::FileSnapshot::exists(path))
    table.note(key, " = \"" + name + "\": no such file: " + path.string());
  return path;
}

/// Path of a file, which cannot be a folder.
fs::path checked_path(Table& table, const std::string& key, const std::string& name) {
  fs::path path = existing_path(table, key, name);
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    table.note(key, " = \"" + name + "\": is a folder, not a file: " + path.string());
  return path;
}

/// A file, a folder, or a pattern such as "recs/*.AT2".
fs::path suite_path(Table& table, const std::string& key, const std::string& name) {
  if (name.empty()) {  // an entry that is no text has been noted
    if (table.document().errors() == 0) table.note(key, " has \"\": must name files");
    return {};
  }
  const fs::path path = (fs::path(table.document().path()).parent_path() / name).lexically_normal();
  return groundmotions::is_glob(path) && !groundmotions::glob(path).empty()
             ? path
             : existing_path(table, key, name);
}

/// Files for stated axes, or files that place their components themselves.
std::vector<groundmotions::RecordFile> read_files(Table& excitation, Table& in,
                                                  RecordRequest& record) {
  std::vector<groundmotions::RecordFile> files;
  record.suite_by_level = in.has(kSuiteByLevel);
  for (const std::string key : {"suite", kSuiteByLevel})
    for (const std::string& name : in.texts(key)) record.suite.push_back(suite_path(in, key, name));
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    const char* key = kAxes[static_cast<std::size_t>(direction)];
    if (const std::string name = in.text(key, ""); !name.empty())
      files.push_back({.path = checked_path(in, key, name), .direction = direction});
  }
  const bool by_axis = !files.empty();
  for (const std::string& name : in.texts("file"))
    files.push_back({.path = checked_path(in, "file", name)});
  const bool by_file = in.has("file");
  if (int(by_axis) + int(by_file) + int(in.has("synthetic")) + int(in.has("suite")) +
          int(record.suite_by_level) !=
      1)
    excitation.note("record",
                    ": no components or too many; must have 'file' (one file with all components, "
                    "or an array of files), or files for 'x', 'y', 'z', or 'synthetic', or, in a "
                    "study, 'suite' or 'suite_by_level'");
  return files;
}

/// One file becomes one for each axis that has a channel.
void read_channels(Table& in, std::vector<groundmotions::RecordFile>& files) {
  if (!in.has("channels")) return;
  const auto channels = in.numbers("channels", Range::within(0, 1000), 3);
  if (files.size() != 1 || files[0].direction) {
    in.note("channels", ": must go with one 'file'");
    return;
  }
  const fs::path path = files[0].path;
  files.clear();
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    const double channel = channels[static_cast<std::size_t>(direction)];
    if (channel != std::floor(channel)) in.note("channels", ": must be whole numbers");
    if (channel >= 1) files.push_back({path, direction, static_cast<int>(channel)});
  }
  if (files.empty()) in.note("channels", ": must name a channel");
}

void read_use(Table& in, RecordRequest& record) {
  static const std::vector<std::string> kUses = {"xyz", "xy", "xz", "yz", "x", "y", "z"};
  const std::string use = kUses[in.choice("use", kUses, 0)];
  record.use_stated = in.has("use");
  const bool by_axis = !record.files.empty() && record.files.front().direction.has_value();
  const auto acts = [&](groundmotions::Direction direction) {
    const char axis = kAxes[static_cast<std::size_t>(direction)][0];
    const bool wanted = use.find(axis) != std::string::npos;
    const bool there = std::ranges::any_of(
        record.files,
        [&](const groundmotions::RecordFile& file) { return file.direction == direction; });
    if (record.use_stated && wanted && by_axis && !there)
      in.note("use", fmt::format(" = \"{}\": must name components that are there; '{}' has no file",
                                 use, axis));
    return wanted;
  };
  record.use_x = acts(groundmotions::Direction::kH1);
  record.use_y = acts(groundmotions::Direction::kH2);
  record.use_z = acts(groundmotions::Direction::kVertical);
  record.use_stated = record.use_stated || by_axis || record.synthetic;
}

void read_options(Table& in, groundmotions::ReadOptions& options) {
  const std::vector<std::string>& units = groundmotions::acceleration_unit_names();
  if (in.has("unit")) options.unit = units[in.choice("unit", units)];
  if (in.has("time_step_s"))
    options.time_step = in.number("time_step_s", Range::within(groundmotions::kShortestTimeStep,
                                                               groundmotions::kLongestTimeStep));
  if (in.has("count_m_per_s2"))
    options.si_per_count = in.number("count_m_per_s2", Range::positive());
  options.columns = in.text("columns", "");
}

void read_scaling(Table& in, RecordRequest& record) {
  record.scale = in.number("scale", Range::positive(), record.scale);
  auto found = in.table("scale_to");
  if (!found) return;
  if (in.has("scale")) in.note("scale", ": must not go with scale_to");
  record.scale_to = read_scale_to(*found);
}

/// A building of the catalogue by its name, or a file.
void read_building_file(Table& table, BuildingRequest& request) {
  const std::string name = table.text("file", "");
  try {
    request.file =
        equipment::find_data(equipment::DataKind::kBuilding, name, table.document().path());
  } catch (const Error& error) {
    table.note("file", " = \"" + name + "\": " + error.what());
    return;
  }
  try {
    request.building = groundmotions::building_from_file(request.file);
  } catch (const Error& error) {
    table.document().note(error);
  }
}

std::optional<BuildingRequest> read_building_request(Table& excitation) {
  auto found = excitation.table("building");
  if (!found) return {};
  if (!excitation.has("record"))
    excitation.note("building", ": must go with a record that shakes it");
  BuildingRequest request;
  const std::size_t before = excitation.document().errors();
  if (found->has("file"))
    read_building_file(*found, request);
  else
    request.building = groundmotions::read_building(*found);
  // The floors of a building that could not be read are not known.
  if (excitation.document().errors() == before)
    request.floor = read_floor(*found, request.building);
  else
    found->has("floor");
  if (found->has("position_m")) {
    constexpr double kFarthest = groundmotions::kFarthestPlace;
    const std::vector<double> place =
        found->numbers("position_m", Range::within(-kFarthest, kFarthest), 2);
    request.place = {place[0], place[1]};
  }
  return request;
}

}  // namespace

std::optional<RecordRequest> read_record_request(Table& excitation) {
  std::optional<BuildingRequest> building = read_building_request(excitation);
  for (const char* key :
       {"file", "suite", kSuiteByLevel, "synthetic", "scale", "scale_to", "unit", "use"})
    if (excitation.has(key))
      excitation.note(key, fmt::format(": unknown key; did you mean 'record.{}'?", key));
  auto found = excitation.table("record");
  if (!found) return {};
  Table& in = *found;
  RecordRequest record;
  record.where = excitation.where("record");
  record.files = read_files(excitation, in, record);
  read_channels(in, record.files);
  if (auto synthetic = in.table("synthetic"))
    record.synthetic = groundmotions::read_synthetic_request(*synthetic);
  read_use(in, record);
  read_options(in, record.options);
  record.processing = groundmotions::read_processing_steps(in);
  if (building && building->building.tables && !record.processing.empty())
    in.note(
        "processing",
        ": must not go with floor motions of another program, which are of the record as it is");
  read_scaling(in, record);
  record.angle = in.number("angle_deg", Range::any(), 0.0) * kRadiansPerDegree;
  record.refuse_implausible = in.choice("plausibility", {"warn", "refuse"}, 0) == 1;
  record.building = std::move(building);
  return record;
}

}  // namespace gurney::study
