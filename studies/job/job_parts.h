#pragma once

#include <optional>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/uncertain.h"
#include "studies/job/job.h"

namespace gurney::study {

/// A job with what its scene is put together from.
struct JobParts : Job {
  std::optional<equipment::FloorCovering> covering;
  equipment::RoomDescription room;
  std::vector<equipment::MaterialContact> usual_contacts;
  /// Each item's own: against anything, and last against the floor; empty: none.
  std::vector<std::vector<ContactConstants>> item_contacts;
};

using JobReading = equipment::Uncertain<JobParts>;

/// Where the description of an item is stated.
inline config::Spot description_spot(config::Table& item) {
  return item.spot(item.has("inline") ? "inline" : "equipment");
}

}  // namespace gurney::study
