#pragma once

#include "groundmotions/formats/format.h"
#include "tests/groundmotions/formats/array_samples.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/groundmotions/formats/page_example.h"
#include "tests/groundmotions/formats/sac_sample.h"

/// A small file in every format, for tests that go over all formats.
namespace gurney::groundmotions {

struct FormatSample {
  std::string format;  ///< as formats() calls it
  std::string bytes;
  bool states_count = true;  ///< the file says how many samples it has, or ends with a mark
  ReadOptions options = {};
};

inline const std::vector<FormatSample>& format_samples() {
  static const std::vector<FormatSample> samples = {
      {"SAC", sac_file(), true, {.unit = "g"}},
      {"USGS SMC", smc_file()},
      {"USGS SMC", smc_pairs()},
      {"GeoNet", geonet_file()},
      {"GeoNet", geonet_file({.is_corrected = true})},
      {"UNAM", unam_file()},
      {"CWB", cwb_file()},
      {"NSMN", page_example("## NSMN")},
      {"COSMOS", cosmos_file()},
      {"CSMIP volume", csmip_volume1()},
      {"CSMIP volume",
       pairs_volume1({0, 0.005, 0.01, 0.015, 0.02, 0.025, 0.035, 0.04, 0.045, 0.05})},
      {"CSMIP volume", csmip_volume2()},
      {"BHRC volume", bhrc_channel("L1")},
      {"USC blocks", usc_block("AC") + usc_block("VL")},
      {"USC volume",
       pairs_volume1({0, 0.005, 0.01, 0.015, 0.02, 0.025, 0.03, 0.035, 0.04, 0.045},
                     {.first = "FILE 0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:"})},
      {"K-NET", page_example("## K-NET and KiK-net")},
      {"CSMNC", page_example("## CSMNC")},
      {"ESM", page_example("## ESM, ITACA and AFAD")},
      {"SIMBAD", page_example("### SIMBAD")},
      {"PEER AT2", page_example("## PEER AT2")},
      {"BBP", page_example("## SCEC BBP"), false},
      {"EMOD3D", page_example("## EMOD3D and ucgmsim"), true, {.unit = "g"}},
      {"columns CSV", page_example("## CSV"), false},
      {"plain text", page_example("## Plain text"), false},
      {"plain text", "# comment\n.1\n-.2\n.3\n", false, {.unit = "g", .time_step = 0.02}},
  };
  return samples;
}

}  // namespace gurney::groundmotions
