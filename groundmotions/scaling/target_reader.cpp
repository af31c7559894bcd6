#include "groundmotions/scaling/target_reader.h"

#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

using config::Range;
using config::Table;

TargetSpectrum read_asce7(Table& in) {
  const double sds = in.number("sds_g", Range::positive()) * kStandardGravity;
  const double sd1 = in.number("sd1_g", Range::positive()) * kStandardGravity;
  return asce7_spectrum(sds, sd1, in.number("tl_s", Range::positive(), 8));
}

char read_letter(Table& in, const char* key) {
  static const std::vector<std::string> kLetters = {"A", "B", "C", "D", "E"};
  return kLetters[in.choice(key, kLetters)][0];
}

TargetSpectrum read_eurocode8(Table& in) {
  Eurocode8 parameters;
  parameters.type = in.integer("type", 1, 2, 1);
  parameters.ground = read_letter(in, "ground");
  parameters.ground_acceleration = in.number("ag_g", Range::positive()) * kStandardGravity;
  parameters.damping =
      in.number("damping_ratio", Range::within(0, 1).open_below().open_above(), 0.05);
  parameters.vertical = in.boolean("vertical", false);
  return eurocode8_spectrum(parameters);
}

TargetSpectrum read_nzs1170(Table& in) {
  Nzs1170 parameters;
  parameters.site_class = read_letter(in, "site_class");
  parameters.hazard = in.number("hazard_factor", Range::positive());
  parameters.return_period = in.number("return_factor", Range::positive(), 1.0);
  parameters.fault_distance = in.number("fault_distance_km", Range::not_negative(), 1e3);
  return nzs1170_spectrum(parameters);
}

TargetSpectrum read_ac156(Table& in) {
  const double sds = in.number("sds_g", Range::positive()) * kStandardGravity;
  const double height = in.number("height_ratio", Range::within(0, 1), 1.0);
  return ac156_spectrum(sds, height, in.boolean("vertical", false));
}

TargetSpectrum read_table(Table& in) {
  const std::filesystem::path folder = std::filesystem::path(in.document().path()).parent_path();
  return table_spectrum(SourceFile(folder / in.text("file")));
}

}  // namespace

std::optional<TargetSpectrum> read_target(Table& in) {
  constexpr TargetSpectrum (*kReaders[])(Table&) = {read_asce7, read_eurocode8, read_nzs1170,
                                                    read_ac156, read_table};
  const std::size_t errors = in.document().errors();
  const std::size_t kind = in.choice("target", {"asce7", "eurocode8", "nzs1170", "ac156", "table"});
  if (in.document().errors() > errors) {
    for (const std::string& key : in.keys()) in.has(key);  // of which target is not known
    return {};
  }
  try {
    TargetSpectrum target = kReaders[kind](in);
    if (in.document().errors() == errors) return target;
  } catch (const Error& error) {
    if (in.document().errors() == errors) in.note("target", std::string(": ") + error.what());
  }
  return {};
}

}  // namespace gurney::groundmotions
