#include "studies/calibration/fit/caster_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"
#include "engine/base/toml_string.h"
#include "engine/base/units.h"
#include "engine/config/document.h"
#include "engine/config/node.h"
#include "engine/config/table.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/catalogue.h"

namespace gurney::calibration {
namespace {

using config::Node;

constexpr double kSameWheel = 0.02;
constexpr double kLeastScatter = 1e-3;  // below it a distribution is noise

std::string value_text(const Node& node) {
  switch (node.kind) {
    case Node::Kind::kBoolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::kInteger:
      return fmt::format("{}", node.integer);
    case Node::Kind::kNumber:
      return fmt::format("{}{}", node.number,
                         std::isfinite(node.number) && std::floor(node.number) == node.number &&
                                 std::abs(node.number) < 1e15
                             ? ".0"
                             : "");
    case Node::Kind::kArray: {
      std::string text;
      for (const Node& each : node.elements) text += (text.empty() ? "" : ", ") + value_text(each);
      return "[" + text + "]";
    }
    case Node::Kind::kText:
    case Node::Kind::kOther:
    case Node::Kind::kTable:
      break;
  }
  return toml_string(node.text);
}

/// Keys with values first, then tables, but those that stand in `replaced` by their path.
std::string table_text(const Node& table, const std::string& path,
                       const std::map<std::string, std::string>& replaced) {
  std::string text, tables;
  for (const Node& each : table.elements) {
    const std::string name = path.empty() ? each.key : path + "." + each.key;
    const auto found = replaced.find(name);
    if (found != replaced.end())
      tables += fmt::format("\n[{}]\n{}", name, found->second);
    else if (each.kind == Node::Kind::kTable)
      tables += fmt::format("\n[{}]\n{}", name, table_text(each, name, replaced));
    else if (path.empty() && (each.key == "name" || each.key == "description"))
      continue;
    else
      text += fmt::format("{} = {}\n", each.key, value_text(each));
  }
  return text + tables;
}

std::string source_of(const Constant& c, bool simulated) {
  std::string names;
  for (const std::string& each : c.trials) names += (names.empty() ? "" : ", ") + each;
  return fmt::format("{}gurney calibrate, {} from {} trials: {}{}",
                     simulated ? "SIMULATED, not measured: " : "", c.about(), c.trials.size(),
                     names,
                     c.at_least                       ? "; a lower bound"
                     : std::isfinite(c.interval.high) ? "; range is the 95 % interval"
                                                      : "; one trial, no interval");
}

/// The lines of a quantity; `scale` makes the key's unit.
std::string quantity_text(const Constant& c, double scale, bool simulated, const char* group) {
  std::string text = fmt::format("value = {:.6g}\nsource = {}\n", c.value * scale,
                                 toml_string(source_of(c, simulated)));
  if (std::isfinite(c.interval.high))
    text +=
        fmt::format("range = [{:.6g}, {:.6g}]\n", c.interval.low * scale, c.interval.high * scale);
  if (c.scatter > kLeastScatter)
    text += fmt::format(
        "distribution = {{ kind = \"lognormal\", median = {:.6g}, beta = {:.4g}, "
        "group = \"{}\", source = \"scatter between the trials\" }}\n",
        c.value * scale, c.scatter, group);
  return text;
}

/// Friction without a distribution: mu_s >= mu_k must hold in every draw.
std::string plain_text(const Constant& c, bool simulated) {
  Constant plain = c;
  plain.scatter = 0;
  return quantity_text(plain, 1, simulated, "");
}

class Maker {
 public:
  Maker(const Calibration& calibration, const std::string& file)
      : document_(file),
        type_(equipment::load_caster_type(file).stated()),
        simulated_(calibration.simulated > 0) {}

  void add(const Constant& c) {
    const double mm = kMillimetersPerMeter;
    const Caster& base = type_.properties;
    switch (c.kind) {
      case ConstantKind::kRolling:
        replaced_["tread.rolling_resistance_mm"] =
            quantity_text(c, base.wheel_radius * mm, simulated_, "rolling resistance");
        break;
      case ConstantKind::kStaticFriction:
        static_ = c;
        break;
      case ConstantKind::kKineticFriction:
        kinetic_ = c;
        break;
      case ConstantKind::kSwivelTorque:
        torque_ = c;
        break;
      case ConstantKind::kStartUp:
      case ConstantKind::kRestitution:
        break;  // neither is a constant of a caster file
    }
  }

  CasterFile finish(const std::string& caster, const std::string& floor, double load) {
    double friction = type_.properties.tread.static_friction;
    if (static_ && kinetic_) {
      friction = static_->value;
      if (kinetic_->value > static_->value) kinetic_->value = static_->value;
      replaced_["tread.static_friction"] = plain_text(*static_, simulated_);
      replaced_["tread.kinetic_friction"] = kinetic_text();
    }
    if (torque_) add_width(friction, load);
    CasterFile file;
    file.name = fmt::format("{}_on_{}", caster, floor);
    std::ranges::replace_if(
        file.name, [](char c) { return c == '/' || c == ' ' || c == '\\'; }, '_');
    for (const auto& [key, text] : replaced_) file.calibrated.push_back(key);
    file.text = fmt::format(
        "# Written by gurney calibrate{}. Numbers that no trial gave are those of {}.\n"
        "schema = \"gurney-caster/1\"\nname = {}\ndescription = {}\n",
        simulated_ ? " from SIMULATED trials" : "", type_.name, toml_string(file.name),
        toml_string(fmt::format("{} calibrated on {}: use it with a floor covering of factor 1",
                                caster, floor)));
    std::string rest = table_text(document_.tree(), "", replaced_);
    const std::string schema = "schema = \"gurney-caster/1\"\n";
    rest.erase(rest.find(schema), schema.size());
    file.text += rest;
    file.name += ".toml";
    return file;
  }

 private:
  std::string kinetic_text() const {
    Constant c = *kinetic_;
    c.interval.low = std::min(c.interval.low, c.value);
    return plain_text(c, simulated_);
  }

  /// mu w / 4 + T / N = torque, T of the base.
  void add_width(double friction, double load) {
    const double widest = type_.properties.wheel_width;
    const double bearing = type_.properties.swivel.coulomb / load;
    const auto width = [&](double torque) {
      return std::clamp(4 * (torque - bearing) / friction, 0.0, widest);
    };
    Constant c = *torque_;
    c.value = width(torque_->value);
    c.interval.low = width(torque_->interval.low);
    if (std::isfinite(c.interval.high)) c.interval.high = width(torque_->interval.high);
    c.scatter = 0;
    if (c.interval.low < c.interval.high)
      replaced_["tread.patch_width_mm"] =
          quantity_text(c, kMillimetersPerMeter, simulated_, "patch width");
  }

  config::Document document_;
  equipment::CasterType type_;
  bool simulated_;
  std::map<std::string, std::string> replaced_;
  std::optional<Constant> static_, kinetic_, torque_;
};

/// Mean load of a wheel in crosswise pulls; 1 where there is none, and nobody asks.
double load_of_wheel(const Calibration& calibration, const std::string& caster) {
  double sum = 0;
  int count = 0;
  for (const CrosswiseFit& fit : calibration.crosswise)
    if (fit.caster == caster) {
      sum += fit.load;
      ++count;
    }
  return count > 0 ? sum / count : 1;
}

void require_caster(const std::string& name) {
  try {
    equipment::find_data(equipment::DataKind::kCaster, name, "");
  } catch (const Error& error) {
    throw Error("'" + name + "': " + error.what());
  }
}

/// Reason against a file for these trials; empty: none.
std::string why_not(const std::string& caster, const std::string& base, double radius) {
  const std::vector<std::string> known = equipment::catalogue_names(equipment::DataKind::kCaster);
  if (!base.ends_with(".toml") && std::ranges::find(known, base) == known.end())
    return fmt::format(
        "{}: the catalogue has no caster '{}'; --base names the one with the parameters "
        "that no trial gives",
        caster, base);
  const equipment::CasterType type =
      equipment::load_caster_type(find_data(equipment::DataKind::kCaster, base, "")).stated();
  const double mm = 2 * kMillimetersPerMeter;
  if (radius > 0 && std::abs(radius / type.properties.wheel_radius - 1) > kSameWheel)
    return fmt::format("{}: its wheels have {:.4g} mm in the trials, but {:.4g} mm in {}", caster,
                       radius * mm, type.properties.wheel_radius * mm, type.file);
  return "";
}

}  // namespace

std::vector<CasterFile> caster_files(const Calibration& calibration, const std::string& base,
                                     std::vector<std::string>& without) {
  if (!base.empty()) require_caster(base);
  std::map<std::pair<std::string, std::string>, std::vector<const Constant*>> groups;
  for (const Constant& each : calibration.constants)
    if (each.kind != ConstantKind::kStartUp && each.kind != ConstantKind::kRestitution)
      groups[{each.caster, each.floor}].push_back(&each);
  std::vector<CasterFile> files;
  for (const auto& [key, constants] : groups) {
    const std::string& caster = key.first;
    const std::string from = base.empty() ? caster : base;
    double radius = 0;
    for (const Constant* each : constants) radius = std::max(radius, each->wheel_radius);
    if (const std::string reason = why_not(caster, from, radius); !reason.empty()) {
      without.push_back(reason);
      continue;
    }
    Maker maker(calibration, equipment::find_data(equipment::DataKind::kCaster, from, ""));
    for (const Constant* each : constants) maker.add(*each);
    files.push_back(maker.finish(caster, key.second, load_of_wheel(calibration, caster)));
  }
  return files;
}

}  // namespace gurney::calibration
