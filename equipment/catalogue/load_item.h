#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/contact_pair.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/joint.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/item_file.h"

namespace gurney::equipment {

/// Changes that a job may make to an item. Empty: as the item's file has it.
struct ItemOptions {
  std::optional<CasterType> caster;     ///< at every place
  std::optional<FloorCovering> floor;   ///< none: the casters' constants as they are
  std::vector<double> headings;         ///< one for each caster [rad]
  std::vector<bool> brakes;             ///< one for each caster, true: on
  std::vector<double> brake_shares;     ///< one for each caster, of its torque where it is on, 0..1
  std::vector<bool> swivel_locks;       ///< one for each caster, true: locked
  std::vector<bool> brakes_drawn;       ///< as brakes, true: each draw decides
  std::vector<bool> locks_drawn;        ///< the same of swivel_locks
  std::map<std::string, int> payloads;  ///< how many of each kind the item knows
  std::optional<std::vector<std::string>> locked_parts;  ///< these and no others
  std::optional<std::vector<std::string>> contents;      ///< these and no others are there
};

/// A part of an item ready for the engine, in item axes.
struct LoadedPart {
  EquipmentModel model;
  Joint joint;            ///< base: 0 the chassis, i + 1 part i; part aside
  double coordinate = 0;  ///< q, or its angle, where `model` is (at_rest.h) [m], [rad]
};

/// A loose body that stands on an item, in the axes of one on the floor.
struct LoadedContent {
  EquipmentModel model;
  std::size_t on = 0;                  ///< 0 the chassis, i + 1 part i
  Vector3 position = Vector3::Zero();  ///< middle of its underside, item axes [m]
  double yaw = 0;                      ///< in item axes [rad]
  std::vector<MaterialPair> pairs;     ///< as LoadedItem::pairs
};

/// An item ready for the engine, with what its numbers rest on.
struct LoadedItem {
  EquipmentModel model;
  std::vector<LoadedPart> parts;
  std::vector<LoadedContent> contents;
  /// Against what has no material of its own, and last against `floor_material` where there is a
  /// covering: its factor is on the friction. These are all a scene without further materials
  /// needs.
  std::vector<MaterialPair> pairs;
  bool states_contact = false;          ///< `pairs` are those of its file
  std::string floor_material;           ///< name of the covering; empty: none
  std::vector<Assumption> assumptions;  ///< those in use: brakes that are off count for nothing
  std::vector<std::string> warnings;    ///< of equipment/catalogue/stability.h
};

/// Base axes become item axes: the base plate is as high as its casters, or where there are none as
/// high as it stands on the lowest of its shapes.
/// @throws Error with a line for each error (a brake that is on but does not exist, base heights
///         that differ between casters, constants outside the engine's ranges, contents that float or
///         stand in something), with the place of a caster or a content that was read from a file.
LoadedItem assemble_item(const ItemDescription& item, const ItemOptions& options = {});

/// The item with its parts and contents as payloads, its masses as it stands, and with the shapes and casters of
/// its parts.
EquipmentModel as_rigid(const LoadedItem& item);

/// Constants of the item's chassis, or its feet, against the floor.
const ContactConstants& floor_contact(const LoadedItem& item);

/// Every number at its value.
/// @throws Error for errors of the file and of `assemble_item`.
LoadedItem load_item(const std::string& file, const ItemOptions& options = {},
                     const std::vector<std::string>& variants = {});

}  // namespace gurney::equipment
