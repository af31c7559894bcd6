#include "groundmotions/formats/format.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "groundmotions/acceleration_unit.h"
#include "groundmotions/formats/bbp.h"
#include "groundmotions/formats/bhrc.h"
#include "groundmotions/formats/columns_csv.h"
#include "groundmotions/formats/cosmos.h"
#include "groundmotions/formats/csmip_volume.h"
#include "groundmotions/formats/cwb.h"
#include "groundmotions/formats/emod3d.h"
#include "groundmotions/formats/esm.h"
#include "groundmotions/formats/foreign_file.h"
#include "groundmotions/formats/geonet.h"
#include "groundmotions/formats/knet.h"
#include "groundmotions/formats/nsmn.h"
#include "groundmotions/formats/peer_at2.h"
#include "groundmotions/formats/plain_text.h"
#include "groundmotions/formats/sac.h"
#include "groundmotions/formats/simbad.h"
#include "groundmotions/formats/unam_asa.h"
#include "groundmotions/formats/usc_blocks.h"
#include "groundmotions/formats/usc_volume.h"
#include "groundmotions/formats/usgs_smc.h"

namespace gurney {

const std::vector<Format>& formats() {
  static const std::vector<Format> table = {
      {"SAC", recognises_sac, read_sac, true},
      {"USGS SMC", recognises_smc, read_smc},
      {"GeoNet", recognises_geonet, read_geonet},
      {"UNAM", recognises_unam, read_unam},
      {"CWB", recognises_cwb, read_cwb},
      {"NSMN", recognises_nsmn, read_nsmn},
      {"COSMOS", recognises_cosmos, read_cosmos},
      {"USC volume", recognises_usc, read_usc},
      {"CSMIP volume", recognises_csmip, read_csmip},
      {"BHRC volume", recognises_bhrc, read_bhrc},
      {"USC blocks", recognises_usc_blocks, read_usc_blocks},
      {"K-NET", recognises_knet, read_knet},
      {"ESM", recognises_esm, read_esm},
      {"SIMBAD", recognises_simbad, read_simbad},
      {"PEER AT2", recognises_peer_at2, read_peer_at2},
      {"BBP", recognises_bbp, read_bbp},
      {"EMOD3D", recognises_emod3d, read_emod3d},
      {"columns CSV", recognises_columns_csv, read_columns_csv},
      {"plain text", recognises_plain_text, read_plain_text},
  };
  return table;
}

std::vector<Component> read_components(const std::filesystem::path& path,
                                       const ReadOptions& options) {
  return read_components(SourceFile(path), options);
}

std::vector<Component> read_components(const SourceFile& file, const ReadOptions& options) {
  require(options.unit.empty() || acceleration_unit(options.unit),
          fmt::format("'{}' is not a unit of acceleration: {} are allowed", options.unit,
                      kAccelerationUnits));
  require(!options.time_step || (*options.time_step > 0 && *options.time_step <= 1),
          fmt::format("the time step of a record must be in (0, 1] s, got {}",
                      options.time_step.value_or(0)));
  const auto foreign = foreign_file(file.bytes());
  require(!foreign, fmt::format("{}: {}", file.name(), foreign.value_or("")));
  std::string names;
  for (const Format& format : formats()) {
    if (format.is_binary != file.is_text() && format.recognises(file)) {
      auto components = format.read(file, options);
      for (Component& component : components) {
        component.file = file.name();
        component.format = format.name;
        component.sha256 = file.sha256();
      }
      return components;
    }
    names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
  }
  const std::string unknown = fmt::format("not a record in a known format ({})", names);
  require(file.is_text(), fmt::format("{}: a binary file, {}", file.name(), unknown));
  throw Error(fmt::format("{}:1:1: {}; the file starts with '{}'", file.name(), unknown,
                          file.lines().front().substr(0, 60)));
}

}  // namespace gurney
