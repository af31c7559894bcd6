#include "groundmotions/buildings/building.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/base/names.h"
#include "engine/base/units.h"
#include "engine/config/table.h"
#include "groundmotions/buildings/isolation.h"
#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {
namespace {

using config::Range;
using config::Table;

constexpr double kLinerShear = 0.5;  ///< of a sliding surface [mm]; an assumption

double meters(double millimeters) { return millimeters / kMillimetersPerMeter; }

Isolation read_linear(Table& table) {
  const double period = table.number("period_s", Range::positive());
  const double damping = table.number("damping_ratio", Range::not_negative());
  return linear_isolation(period > 0 ? period : 1, damping);
}

Isolation read_lead_rubber(Table& table) {
  const std::size_t before = table.document().errors();
  const double period = table.number("period_s", Range::positive());
  const double strength = table.number("strength_ratio", Range::positive());
  const double yield = meters(table.number("yield_displacement_mm", Range::positive()));
  const double damping = table.number("damping_ratio", Range::not_negative(), 0.0);
  if (table.document().errors() > before) return linear_isolation(1, 0);
  return lead_rubber(period, strength, yield, damping);
}

Isolation read_friction_pendulum(Table& table) {
  const std::size_t before = table.document().errors();
  const double radius = table.number("radius_m", Range::positive());
  const double slow = table.number("friction_slow", Range::within(0, 1));
  const double fast = table.number("friction_fast", Range::within(0, 1));
  const double rate = table.number("friction_rate_s_per_m", Range::not_negative());
  const double yield =
      meters(table.number("yield_displacement_mm", Range::positive(), kLinerShear));
  const bool vertical = table.boolean("vertical_load", true);
  if (!(fast >= slow))
    table.note("friction_fast",
               fmt::format(" = {}: must be at least friction_slow = {}", fast, slow));
  if (table.document().errors() > before) return linear_isolation(1, 0);
  Isolation isolation = friction_pendulum(radius, slow, fast, rate, yield);
  isolation.follows_vertical = vertical;
  return isolation;
}

/// Reads the table `isolation` of a building; errors are noted in the table's document, and a
/// linear isolation that means nothing is returned.
Isolation read_isolation(Table& table) {
  Isolation isolation;
  switch (table.choice("kind", {"lead_rubber", "friction_pendulum", "linear"})) {
    case 0:
      isolation = read_lead_rubber(table);
      break;
    case 1:
      isolation = read_friction_pendulum(table);
      break;
    default:
      isolation = read_linear(table);
  }
  isolation.base_mass_ratio = table.number("base_mass_ratio", Range::within(0.01, 0.99));
  isolation.capacity =
      meters(table.number("displacement_capacity_mm", Range::positive().with_infinity(),
                          std::numeric_limits<double>::infinity()));
  return isolation;
}

using config::Range;
using config::Table;
using std::numbers::pi;

constexpr int kMaxStoreys = 200;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Range kDamping = Range::within(0, 0.99);

/// One value for both horizontal directions, or [h1, h2].
std::array<double, 2> read_pair(Table& table, const std::string& key, const Range& range) {
  if (table.is_array(key)) {
    const std::vector<double> values = table.numbers(key, range, 2);
    return {values[0], values[1]};
  }
  const double value = table.number(key, range);
  return {value, value};
}

Eigen::VectorXd vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A key that another one rules out.
void exclude(Table& table, const std::string& key, const std::string& by) {
  if (table.has(key)) table.note(key, ": must not be given with " + by);
}

/// Damping and number of modes of the two horizontal axes.
class Damper {
 public:
  Damper(Table& table, int storeys) {
    ratio_ = table.number("damping_ratio", kDamping);
    modes_ = static_cast<std::size_t>(table.integer("modes", 1, storeys, storeys));
    if (!table.has("rayleigh_modes")) return;
    const std::vector<double> pair =
        table.numbers("rayleigh_modes", Range::within(1, storeys), std::size_t{2});
    if (!(pair[0] < pair[1]) || pair[0] != std::floor(pair[0]) || pair[1] != std::floor(pair[1]))
      table.note(
          "rayleigh_modes",
          fmt::format(" = [{}, {}]: must be two whole numbers, the first lower", pair[0], pair[1]));
    else
      rayleigh_ = {static_cast<std::size_t>(pair[0]) - 1, static_cast<std::size_t>(pair[1]) - 1};
  }

  /// Sets it for all modes, and drops those not retained. Notes damping that is not below critical;
  /// false then.
  bool apply(Table& table, ModalAxis& axis) const { return apply(table, axis, modes_); }

  /// Likewise for modes of floors that twist, which are all retained.
  bool apply(Table& table, std::vector<TorsionMode>& modes) const {
    ModalAxis axis(modes.size());
    for (std::size_t i = 0; i < modes.size(); ++i) axis[i].omega = modes[i].omega;
    if (!apply(table, axis, axis.size())) return false;
    for (std::size_t i = 0; i < modes.size(); ++i) modes[i].damping = axis[i].damping;
    return true;
  }

 private:
  bool apply(Table& table, ModalAxis& axis, std::size_t retained) const {
    if (rayleigh_)
      set_rayleigh_damping(axis, ratio_, rayleigh_->first, rayleigh_->second);
    else
      set_damping(axis, ratio_);
    axis.resize(retained);
    for (std::size_t i = 0; i < axis.size(); ++i)
      if (!(axis[i].damping < 1)) {
        table.note("rayleigh_modes",
                   fmt::format(": gives mode {} the damping ratio {:.3g}; must be below 1: choose "
                               "a higher second mode, or fewer `modes`",
                               i + 1, axis[i].damping));
        return false;
      }
    return true;
  }

  double ratio_;
  std::size_t modes_;
  std::optional<std::pair<std::size_t, std::size_t>> rayleigh_;
};

/// The storeys of a shear building that yields; they keep the damping of its elastic modes.
/// @param axes    of the building, all modes
/// @param height  is set
YieldingStoreys read_yield(Table in, const Eigen::VectorXd& mass,
                           const std::array<Eigen::VectorXd, 2>& stiffness,
                           const std::array<ModalAxis, 2>& axes, std::optional<double>& height) {
  YieldingStoreys storeys{mass, stiffness, {}, {}, 0};
  const auto count = static_cast<std::size_t>(mass.size());
  const Range ratio = Range::within(0, 1).open_below();
  height = in.number("height_m", Range::positive());
  storeys.yield_drift =
      *height / static_cast<double>(count) *
      (in.is_array("drift_ratio")
           ? vector(in.numbers("drift_ratio", ratio, count))
           : Eigen::VectorXd::Constant(mass.size(), in.number("drift_ratio", ratio)));
  storeys.hardening = in.number("hardening_ratio", Range::within(0, 0.99));
  constexpr const char *kDrift = "pinching_drift_ratio", *kForce = "pinching_force_ratio";
  if (in.has(kDrift) || in.has(kForce))
    storeys.pinching = {in.number(kDrift, Range::within(0, 1)), in.number(kForce, ratio)};
  for (std::size_t i = 0; i < 2; ++i) {
    storeys.damping[i].resize(mass.size());
    for (std::size_t k = 0; k < axes[i].size(); ++k)
      storeys.damping[i][static_cast<Eigen::Index>(k)] = axes[i][k].damping;
  }
  return storeys;
}

/// One number for all floors, or one for each.
Eigen::VectorXd read_each(Table& in, const std::string& key, const Range& range,
                          Eigen::Index floors, std::optional<double> fallback = {}) {
  if (in.is_array(key)) return vector(in.numbers(key, range, static_cast<std::size_t>(floors)));
  return Eigen::VectorXd::Constant(floors, in.number(key, range, fallback));
}

/// Floors that twist where the table `torsion` has an eccentricity.
/// @param twisting  its mass and stiffness are those of the building
/// @returns all of it, where the table is there and right
std::optional<TorsionalBuilding> read_torsion(Table& table, TorsionalBuilding twisting,
                                              const Damper& damper, Building& building) {
  auto in = table.table("torsion");
  if (!in) return std::nullopt;
  const std::size_t before = table.document().errors();
  for (const char* other : {"modes", "isolation", "floor_rotation"})
    exclude(table, other, "torsion");
  const Eigen::Index floors = building.storeys;
  const Range ratio = Range::within(0.1, 10), far = Range::within(-100, 100);
  twisting.eccentricity.resize(2, floors);
  twisting.eccentricity.row(0) = read_each(*in, "eccentricity_h1_m", far, floors, 0.0).transpose();
  twisting.eccentricity.row(1) = read_each(*in, "eccentricity_h2_m", far, floors, 0.0).transpose();
  twisting.gyration = in->number("radius_of_gyration_m", Range::positive());
  twisting.frequency_ratio = in->number("frequency_ratio", ratio);
  if (table.document().errors() > before || twisting.mass.size() != floors) return std::nullopt;
  if (twisting.eccentricity.isZero(0)) return twisting;
  building.torsion = torsion_modes(twisting);
  damper.apply(table, building.torsion);
  return twisting;
}

/// Columns of storeys that yield below floors that twist: b from Omega^2 r^2 K_x = K_x b^2 + K_y a^2.
/// @param elastic  modes of the building
YieldingTwist read_columns(Table& in, const TorsionalBuilding& building,
                           const std::array<Eigen::VectorXd, 2>& stiffness,
                           const std::vector<TorsionMode>& elastic) {
  const double square = std::pow(building.frequency_ratio * building.gyration, 2);
  const Eigen::ArrayXd ratio = stiffness[1].array() / stiffness[0].array();
  Eigen::ArrayXd a = (square / (1 + ratio)).sqrt();  // b = a
  if (in.has("column_distance_h1_m"))
    a.setConstant(
        in.number("column_distance_h1_m", Range::within(0, std::sqrt(square / ratio.maxCoeff()))));
  YieldingTwist twist{building.eccentricity, building.gyration, Eigen::Matrix2Xd(2, a.size()),
                      Eigen::VectorXd(static_cast<Eigen::Index>(elastic.size()))};
  twist.columns.row(0) = a.transpose();
  twist.columns.row(1) = (square - ratio * a.square()).max(0.0).sqrt().transpose();
  for (std::size_t k = 0; k < elastic.size(); ++k)
    twist.damping[static_cast<Eigen::Index>(k)] = elastic[k].damping;
  return twist;
}

/// Storey by storey, from stiffnesses or from a period and a taper.
/// @param building  its height and its storeys that yield are set where the table has them
std::array<ModalAxis, 2> read_shear(Table& table, Building& building) {
  const int storeys = building.storeys;
  const auto count = static_cast<std::size_t>(storeys);
  const Damper damper(table, storeys);
  const std::vector<double> mass =
      table.numbers("storey_mass_kg", Range::positive(), count, std::vector<double>(count, 1));
  const char* kKeys[] = {"storey_stiffness_h1_n_per_m", "storey_stiffness_h2_n_per_m"};
  std::array<Eigen::VectorXd, 2> stiffness;
  std::optional<std::array<double, 2>> period;
  const std::size_t before = table.document().errors();
  if (table.has(kKeys[0]) || table.has(kKeys[1])) {
    exclude(table, "period_s", "storey stiffnesses");
    exclude(table, "top_stiffness_ratio", "storey stiffnesses");
    if (!table.has("storey_mass_kg"))
      table.note("storey_mass_kg", ": missing; storey stiffnesses need masses");
    for (std::size_t axis = 0; axis < 2; ++axis)
      stiffness[axis] = vector(table.numbers(kKeys[axis], Range::positive(), count));
  } else {
    period = read_pair(table, "period_s", Range::positive());
    const double top = table.number("top_stiffness_ratio", Range::within(0.01, 100), 1.0);
    stiffness.fill(tapered_storeys(storeys, top));
  }
  std::array<ModalAxis, 2> axes;
  if (table.document().errors() > before || vector(mass).minCoeff() <= 0) {
    for (const char* key : {"torsion", "yield"}) table.set_aside(key);
    return axes;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    axes[i] = modes_of(vector(mass), shear_stiffness(stiffness[i]));
    if (period) {
      stiffness[i] *= std::pow(2 * pi / (*period)[i] / axes[i].front().omega, 2);
      scale_to_period(axes[i], (*period)[i]);
    }
    if (!damper.apply(table, axes[i])) return axes;
  }
  const std::optional<TorsionalBuilding> twisting =
      read_torsion(table,
                   {.mass = vector(mass),
                    .stiffness = {shear_stiffness(stiffness[0]), shear_stiffness(stiffness[1])}},
                   damper, building);
  if (auto yield = table.table("yield")) {
    exclude(table, "modes", "yield; storeys that yield have no modes");
    exclude(table, "isolation", "yield: what stands on isolators is elastic");
    exclude(table, "floor_rotation", "yield: floors of storeys in shear stay level");
    if (!table.has("torsion"))
      exclude(*yield, "column_distance_h1_m", "storeys that do not twist: it goes with torsion");
    yield->has("column_distance_h1_m");  // is known, also where torsion has errors
    if (axes[1].size() == count)
      building.yielding = read_yield(*yield, vector(mass), stiffness, axes, building.height);
    if (building.yielding && twisting) {
      YieldingTwist columns = read_columns(*yield, *twisting, stiffness, building.torsion);
      if (!building.torsion.empty()) building.yielding->twist = std::move(columns);
    }
  }
  return axes;
}

/// @param building  its height and floors that twist are set where the table has them
std::array<ModalAxis, 2> read_generic(Table& table, Building& building) {
  const int storeys = building.storeys;
  std::optional<double>& height = building.height;
  const Damper damper(table, storeys);
  const std::size_t before = table.document().errors();
  std::array<double, 2> period;
  if (table.has("frame")) {
    exclude(table, "period_s", "frame");
    const std::vector<std::string> names = names_of(kFrameKinds);
    const FrameKind& frame = kFrameKinds[table.choice("frame", names)];
    height = table.number("height_m", Range::positive());
    if (*height > 0) period.fill(approximate_period(frame, *height));
  } else {
    exclude(table, "height_m", "period_s; it is for the period of a `frame`");
    period = read_pair(table, "period_s", Range::positive());
  }
  const double alpha0 = table.number(
      "shear_flexure_ratio", Range::within(0, 1000).open_above().with_infinity(), kInfinity);
  std::array<ModalAxis, 2> axes;
  if (table.document().errors() > before) return axes;
  TorsionalBuilding frame{.mass = Eigen::VectorXd::Ones(storeys)};
  frame.stiffness.fill(shear_flexure_stiffness(storeys, alpha0));
  for (std::size_t i = 0; i < 2; ++i) {
    axes[i] = modes_of(frame.mass, frame.stiffness[i]);
    frame.stiffness[i] *= std::pow(2 * pi / period[i] / axes[i].front().omega, 2);
    scale_to_period(axes[i], period[i]);
    if (!damper.apply(table, axes[i])) return axes;
  }
  read_torsion(table, std::move(frame), damper, building);
  return axes;
}

ModalAxis read_modes(Table& table, const std::string& key, int storeys) {
  ModalAxis axis;
  double mass = 0;
  for (Table& in : table.tables(key)) {
    Mode mode;
    const double period = in.number("period_s", Range::positive(), std::nullopt);
    mode.omega = period > 0 ? 2 * pi / period : 1;
    mode.damping = in.number("damping_ratio", kDamping);
    mode.effective_shape = Eigen::VectorXd::Zero(storeys + 1);
    mode.effective_shape.tail(storeys) =
        vector(in.numbers("effective_shape", Range::any(), static_cast<std::size_t>(storeys)));
    mode.effective_mass = in.number("effective_mass_ratio", Range::within(0, 1), 0.0);
    if (in.has("effective_rotation_rad_per_m")) {
      if (key == name_of(Direction::kVertical))
        in.note("effective_rotation_rad_per_m", ": must go with a mode of h1 or h2");
      mode.effective_rotation = Eigen::VectorXd::Zero(storeys + 1);
      mode.effective_rotation.tail(storeys) = vector(in.numbers(
          "effective_rotation_rad_per_m", Range::any(), static_cast<std::size_t>(storeys)));
    }
    mass += mode.effective_mass;
    if (!axis.empty() && !(mode.omega > axis.back().omega))
      in.note("period_s", fmt::format(" = {}: must be shorter than that of the mode before, {}",
                                      period, 2 * pi / axis.back().omega));
    axis.push_back(std::move(mode));
  }
  if (mass > 1 + 1e-6)
    table.note(key,
               fmt::format(": effective_mass_ratio adds up to {:.6g}; must be at most 1", mass));
  return axis;
}

ModalAxis read_vertical(Table in, int storeys) {
  VerticalFloors floors;
  const std::size_t before = in.document().errors();
  floors.floor_omega = 2 * pi * in.number("floor_frequency_hz", Range::positive());
  floors.damping = in.number("damping_ratio", kDamping);
  floors.column_omega =
      2 * pi * in.number("column_frequency_hz", Range::positive().with_infinity(), kInfinity);
  floors.mass_share = in.number("floor_mass_ratio", Range::within(0.01, 0.99), plate_mass_share());
  floors.participation =
      in.number("floor_participation", Range::not_negative(), plate_participation());
  if (in.document().errors() > before) return {};
  return vertical_modes(storeys, floors);
}

/// Rotation of the floors of a shear or generic building.
/// @param height  of a building whose keys state it; else it is set
void read_rotation(Table in, std::optional<double>& height, std::array<ModalAxis, 3>& axes) {
  const std::size_t before = in.document().errors();
  if (height)
    exclude(in, "height_m", "the height_m of a frame");
  else
    height = in.number("height_m", Range::positive());
  const double share = in.number("bending_share", Range::within(0, 1));
  if (in.document().errors() > before) return;
  for (const Direction direction : {Direction::kH1, Direction::kH2})
    set_rotation(axes[static_cast<std::size_t>(direction)], *height, share);
}

/// An isolated building moves its base by the effective masses of its modes.
void check_masses(Table& table, const Building& building) {
  for (const Direction direction : {Direction::kH1, Direction::kH2})
    for (const Mode& mode : building[direction])
      if (!(mode.effective_mass > 0))
        table.note(name_of(direction),
                   ": effective_mass_ratio must be > 0 for each mode of an isolated building");
}

}  // namespace

Building read_building(Table& table, const std::string& name) {
  const std::size_t before = table.document().errors();
  Building building;
  building.name = table.text("name", name);
  const std::size_t kind = table.choice("kind", {"shear", "generic", "modal", "tables"});
  if (kind == 3) {
    FloorTables tables = read_floor_tables(table);
    building.storeys = std::max(0, static_cast<int>(tables.floors.size()) - 1);
    if (table.document().errors() == before) building.tables = std::move(tables);
    return building;
  }
  building.storeys = table.integer("storeys", 1, kMaxStoreys);
  const bool modal = kind == 2;
  if (modal) {
    for (const Direction direction : kDirections)
      building.axes[static_cast<std::size_t>(direction)] =
          read_modes(table, name_of(direction), building.storeys);
  } else {
    const auto axes = kind == 0 ? read_shear(table, building) : read_generic(table, building);
    building.axes = {axes[0], axes[1], {}};
    if (auto vertical = table.table("vertical"))
      building.axes[2] = read_vertical(*vertical, building.storeys);
    if (auto rotation = table.table("floor_rotation"))
      read_rotation(*rotation, building.height, building.axes);
  }
  if (auto isolation = table.table("isolation")) {
    building.isolation = read_isolation(*isolation);
    if (modal) check_masses(table, building);
  }
  if (table.document().errors() == before) return building;
  Building rigid;
  rigid.name = building.name;
  rigid.storeys = building.storeys;
  return rigid;
}

std::string name_of_floor(const Building& building, int floor) {
  return building.tables ? building.tables->floors[static_cast<std::size_t>(floor)]
                         : std::to_string(floor);
}

std::optional<int> floor_of(const Building& building, const std::string& name) {
  for (int floor = 0; floor <= building.storeys; ++floor)
    if (name_of_floor(building, floor) == name) return floor;
  return name == "roof" ? std::optional(building.storeys) : std::nullopt;
}

std::string floor_names(const Building& building) {
  if (!building.tables) return fmt::format("roof, or a number from 0 to {}", building.storeys);
  std::vector<std::string> names = building.tables->floors;
  std::erase(names, "roof");
  return names.empty() ? "roof" : fmt::format("{} or roof", fmt::join(names, ", "));
}

int read_floor(Table& table, const Building& building) {
  const bool named = building.tables.has_value();
  if (!table.is_text("floor")) {
    const int number = table.integer("floor", 0, named ? kMaxStoreys : building.storeys);
    if (!named) return number;
    const std::optional<int> found = floor_of(building, std::to_string(number));
    if (!found)
      table.note("floor", fmt::format(" = {}: must be {}", number, floor_names(building)));
    return found.value_or(0);
  }
  if (!named) {
    if (const std::string name = table.text("floor"); name != "roof")
      table.note("floor", fmt::format(" = \"{}\": must be \"roof\" or a whole number in 0..{}",
                                      name, building.storeys));
    return building.storeys;
  }
  std::vector<std::string> names = building.tables->floors;
  if (std::ranges::find(names, "roof") == names.end()) names.emplace_back("roof");
  return std::min(static_cast<int>(table.choice("floor", names)), building.storeys);
}

Building building_from_file(const std::string& path) {
  config::Document document(path);
  Table root = document.root();
  root.choice("schema", {"gurney-building/1"});
  root.text("name");
  root.text("description", "");
  const Building building = read_building(root);
  document.finish();
  return building;
}

}  // namespace gurney::groundmotions
