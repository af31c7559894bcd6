#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/joint.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// A body of an item on a joint: a drawer, a door, an arm, a mast, a bag. Base axes.
struct PartDescription {
  std::string name;
  std::string where;     ///< `file:line:column`; empty: not from a file
  std::size_t base = 0;  ///< what carries it: 0 the chassis, i + 1 part i, before this one
  Joint joint;           ///< its items aside
  bool locked = false;   ///< held at q = 0
  /// Frequency of a flexible joint with all parts on it, in place of its stiffness; 0: none [Hz].
  double frequency = 0;
  double damping_ratio = 0;
  double mass = 0;                           ///< [kg]
  Vector3 center_of_mass = Vector3::Zero();  ///< [m]
  Matrix3 inertia = Matrix3::Zero();         ///< about its centre of mass [kg m2]
  std::string material;                      ///< empty: that of the chassis
  std::vector<BodyShape> shape;
  std::vector<MarkedPoint> marked_points;
};

/// As item files name it.
const std::string& name_of(Joint::Kind kind);

/// A loose body that stands on an item. Base axes.
struct ContentDescription {
  std::string name;
  std::string where;                   ///< `file:line:column`; empty: not from a file
  std::size_t on = 0;                  ///< what carries it: 0 the chassis, i + 1 part i
  Vector3 position = Vector3::Zero();  ///< middle of the underside of the box around it [m]
  double yaw = 0;                      ///< [rad]
  double mass = 0;                     ///< [kg]
  std::vector<BodyShape> shape;        ///< uniform; anywhere in axes of its own [m]
  ItemContact contact;                 ///< with what it stands on, and all else
};

/// Index of the body that `key` names: 0 the chassis, i + 1 part i. An unknown name is noted.
std::size_t read_carrier(config::Table& table, const std::string& key,
                         const std::vector<PartDescription>& parts);

/// Reads a table [[part]] of an item. Errors are noted in its document.
/// @param before  the parts that may carry it
Uncertain<PartDescription> read_part(config::Table table,
                                     const std::vector<PartDescription>& before);

/// Reads a table [[content]] of an item. Errors are noted in its document.
Uncertain<ContentDescription> read_content(config::Table table,
                                           const std::vector<PartDescription>& parts);

}  // namespace gurney::equipment
