#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/equipment_model.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/item_parts.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// One place for a caster on the base plate.
struct CasterPlace {
  std::string name;
  std::string where;   ///< `file:line:column`; empty: not from a file
  std::size_t on = 0;  ///< what stands on it: 0 the chassis, i + 1 part i
  CasterType type;
  Vector3 mount = Vector3::Zero();  ///< of the swivel axis, base axes [m]
  double heading = 0;               ///< initial [rad]
  double stated_heading = 0;        ///< before any draw [rad]
  bool swivels = true;
  bool brake_on = false;
  bool swivel_locked = false;
  bool brake_drawn = false, lock_drawn = false;  ///< each draw decides whether they are on
};

/// Something an item can carry, stacked upwards from `position`.
struct PayloadKind {
  std::string name;
  std::size_t on = 0;                  ///< what carries it: 0 the chassis, i + 1 part i
  double mass = 0;                     ///< of one [kg]
  Vector3 size = Vector3::Zero();      ///< of one, a uniform box [m]
  Vector3 position = Vector3::Zero();  ///< middle of the underside of the lowest, base axes [m]
  int count = 0;                       ///< unless a job says otherwise
  std::vector<Assumption> assumptions;
};

/// An item as its file describes it (docs/formats/equipment_file.md), in base axes: x forward,
/// y left, z up from the underside of the base plate, which rests on the casters, or on the lowest
/// of its shapes where it has none.
struct ItemDescription {
  std::string name;
  std::string description;
  std::string file;
  double chassis_mass = 0;                           ///< without casters and payloads [kg]
  Vector3 chassis_center_of_mass = Vector3::Zero();  ///< [m]
  Matrix3 chassis_inertia = Matrix3::Zero();         ///< about its centre of mass [kg m2]
  std::string material;                              ///< of its chassis; empty: not stated
  std::vector<BodyShape> shape;
  std::vector<CasterPlace> casters;  ///< none: it stands on the lowest of its shapes
  ItemContact contact;
  std::vector<PayloadKind> payloads;
  std::vector<MarkedPoint> marked_points;
  std::vector<PartDescription> parts;
  std::vector<ContentDescription> contents;
  std::vector<std::string> variants;    ///< names of all the file has, sorted
  std::vector<Assumption> assumptions;  ///< besides those of casters and payloads
};

/// Reads an item from its own file's root or from a table of a job. Errors are noted in the
/// table's document; the result is for use only after its `finish`.
Uncertain<ItemDescription> read_item(config::Table table);

/// Every variant is checked, whether selected or not.
/// @param variants  laid over the item in this order
/// @throws Error with every error of the file, its variants and the casters it names, and for a
///         variant it does not have.
Uncertain<ItemDescription> load_item_description(const std::string& file,
                                                 const std::vector<std::string>& variants = {});

/// Names of the variants of an item, the tables [variant.NAME] of its file, sorted.
/// @throws Error if the file is not TOML.
std::vector<std::string> variant_names(const std::string& item_file);

/// Empty if all are known; else what is wrong, with the nearest name.
std::string unknown_variant(const std::vector<std::string>& wanted,
                            const std::vector<std::string>& known);

}  // namespace gurney::equipment
