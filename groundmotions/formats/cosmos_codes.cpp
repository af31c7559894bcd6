#include "groundmotions/formats/cosmos_codes.h"

#include <array>

#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

struct Code {
  int code;
  const char* meaning;
};

constexpr std::array kQuantities = {
    Code{1, "acceleration"},          Code{2, "velocity"},
    Code{3, "absolute displacement"}, Code{4, "relative displacement"},
    Code{10, "angular acceleration"}, Code{11, "angular velocity"},
    Code{12, "angular displacement"}, Code{20, "absolute pressure"},
    Code{21, "relative pressure"},    Code{30, "volumetric strain"},
    Code{31, "linear strain"}};

constexpr std::array kStructures = {Code{5, "the base of a building"},
                                    Code{10, "a building"},
                                    Code{11, "a bridge"},
                                    Code{12, "a dam"},
                                    Code{13, "a wharf"},
                                    Code{14, "a tunnel"},
                                    Code{15, "a lifeline structure"},
                                    Code{20, "a structure"}};

constexpr std::array kOrientations = {Code{kCosmosUp, "up"},
                                      Code{kCosmosDown, "down"},
                                      Code{kCosmosVertical, "vertical, its sense not stated"},
                                      Code{500, "radial, inward"},
                                      Code{501, "transverse, 90 degrees clockwise from radial"},
                                      Code{600, "longitudinal, relative to the structure"},
                                      Code{601, "tangential, relative to the structure"},
                                      Code{700, "H1, azimuth unknown"},
                                      Code{701, "H2, azimuth unknown"},
                                      Code{2000, "other, described in the comments"}};

struct UnitCode {
  int code;
  AccelerationUnit unit;
};

constexpr double kMetersPerInch = 0.0254;  // international inch, exact

constexpr std::array kUnits = {UnitCode{2, {"g", kStandardGravity}},
                               UnitCode{4, {"cm/s2", 0.01}},
                               UnitCode{7, {"in/s2", kMetersPerInch}},
                               UnitCode{10, {"cm/s2", 0.01}},
                               UnitCode{11, {"mg", 1e-3 * kStandardGravity}},
                               UnitCode{12, {"micro g", 1e-6 * kStandardGravity}}};

template <std::size_t N>
const char* meaning(const std::array<Code, N>& codes, int code) {
  for (const Code& entry : codes)
    if (entry.code == code) return entry.meaning;
  return nullptr;
}

}  // namespace

const char* cosmos_quantity(int code) { return meaning(kQuantities, code); }

const char* cosmos_structure(int code) { return meaning(kStructures, code); }

const char* cosmos_orientation(int code) { return meaning(kOrientations, code); }

std::optional<AccelerationUnit> cosmos_unit(int code) {
  for (const UnitCode& entry : kUnits)
    if (entry.code == code) return entry.unit;
  return {};
}

}  // namespace gurney::groundmotions
