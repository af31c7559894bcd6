#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/uncertainty.h"
#include "studies/job/job.h"

namespace gurney::study {

/// Loads what `key` of a job's table names; an error in the name is noted there, errors in the
/// file after ours. Empty without the key or with an error.
template <typename Load>
auto load_named(config::Table& table, const std::string& key, equipment::DataKind kind, Load load)
    -> std::optional<decltype(load(std::string()))> {
  if (!table.has(key)) return {};
  const std::string name = table.text(key);
  if (!table.is_text(key)) return {};
  std::string file;
  try {
    file = equipment::find_data(kind, name, table.document().path());
  } catch (const Error& error) {
    table.note(key, " = \"" + name + "\": " + error.what());
    return {};
  }
  try {
    return load(file);
  } catch (const Error& error) {
    table.document().note(error);
    return {};
  }
}

/// A job with what its scene is put together from.
struct JobParts : Job {
  std::optional<equipment::FloorCovering> covering;
  equipment::RoomDescription room;
  std::vector<equipment::MaterialContact> usual_contacts;
  /// What hangs and stands on each item of the job, and where it is in the scene, after these.
  struct Unfolded {
    std::vector<equipment::LoadedPart> parts;
    std::vector<equipment::LoadedContent> contents;
    std::size_t first = 0;  ///< index in Scene::items of the first part
  };
  std::vector<Unfolded> unfolded;  ///< one for each item of the job
  /// Each item's own: against anything, and last against the floor; empty: none.
  std::vector<std::vector<ContactConstants>> item_contacts;
};

using JobReading = equipment::Uncertain<JobParts>;

/// Where the description of an item is stated.
inline config::Spot description_spot(config::Table& item) {
  return item.spot(item.has("inline") ? "inline" : "equipment");
}

}  // namespace gurney::study
