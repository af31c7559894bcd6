#include "tests/system/records/real_records.h"

#include <algorithm>

namespace gurney::groundmotions {
namespace {

/// What the samples are in the reference values.
enum class Values { kSame, kWithoutMean, kInCounts };

/// Files of the folder that are read alike or refused alike.
struct Files {
  std::string start, end;  ///< of their path from the folder
  std::size_t count;
  std::string verdict;  ///< the format that reads them, or a part of the reason
  ReadOptions options = {};
  Values values = Values::kSame;
};

const char* const kVelocity = "a record must be acceleration, but this is a velocity file";
const char* const kPsa = "a record must be an acceleration history, but the header speaks of 'psa'";
const char* const kUnknown = "not a record in a known format";
const ReadOptions kG = {.unit = "g"}, kSi = {.unit = "m/s2"};
const ReadOptions kG10 = {.unit = "g", .time_step = 0.01};
const ReadOptions kG10Rows = {.unit = "g", .time_step = 0.01, .columns = "samples"};
const ReadOptions kG20Rows = {.unit = "g", .time_step = 0.02, .columns = "samples"};

// Whoever adds a file to the folder must add it here.
const std::vector<Files> kFolder = {
    {"PROVENANCE.md", "", 1, kUnknown},
    {"SHA256SUMS", "", 1, kUnknown},
    {"component_sets.csv", "", 1, kUnknown},
    {"published_vs_computed.csv", "", 1, kUnknown},
    {"reference_values.csv", "", 1, kUnknown},
    {"at2_variants/", ".AT2", 7, "PEER AT2"},
    {"at2_variants/", ".at2", 2, "PEER AT2"},
    {"at2_variants/", ".DT2", 1, "acceleration, but this is a displacement file"},
    {"peer_nga_at2/", ".AT2", 29, "PEER AT2"},
    {"peer_nga_at2/", ".VT2", 6, kVelocity},
    {"bbp/", ".bbp", 2, "BBP"},
    {"bbp/", ".rd50", 1, kPsa},
    {"cosmos/", ".V1C", 1, "COSMOS"},
    {"cosmos/", ".v1", 2, "COSMOS"},
    {"cosmos/", ".V0c", 1, "COSMOS", {}, Values::kInCounts},
    {"csmip_v1_v2_v3/", ".V1", 1, "CSMIP volume"},
    {"csmip_v1_v2_v3/", ".V2", 2, "CSMIP volume"},
    {"csmip_v1_v2_v3/", ".RAW", 1, "CSMIP volume"},
    {"csmip_v1_v2_v3/", ".V3", 1, "response spectra, not an acceleration history; take the .V2"},
    {"csmip_v1_v2_v3/", ".zip", 1, "a zip archive; unpack it first"},
    {"esm_asc/", ".ASC", 3, "ESM"},
    {"fema_p695_text/1207", ".th", 4, "plain text", kG10},
    {"fema_p695_text/1211", ".th", 2, "plain text", {.unit = "g", .time_step = 0.02}},
    {"fema_p695_text/RSN", ".txt", 4, "plain text", kG},
    {"fema_p695_text/GM Data.txt", "", 1, kUnknown},
    {"fema_p695_text/MetaData.txt", "", 1, kUnknown},
    {"geonet_v1a_v2a/", "A", 2, "GeoNet"},
    {"itaca_cor_acc/", ".cor.acc", 3, "SIMBAD"},
    {"itaca_cor_acc/", ".rs", 3, kPsa},
    {"itaca_cor_acc/", ".metadata", 1, kUnknown},
    {"kiknet/", "2", 3, "K-NET"},
    {"knet/", "", 9, "K-NET"},
    {"miniseed/", ".mseed", 3, "a miniSEED file, not a record"},
    {"miniseed/", ".xml", 1, "a StationXML file"},
    {"other_networks/1-EAS.dat", "", 1, "CWB"},
    {"other_networks/5526-1.V1", "", 1, "BHRC volume"},
    {"other_networks/ACAC8903.101", "", 1, "UNAM"},
    {"other_networks/CUP50401.012", "", 1, "UNAM"},
    {"other_networks/cuya0911131.v1", "", 1, "CSMIP volume"},
    {"plain_text/ARL360", ".g3", 2, "plain text", kG20Rows},
    {"plain_text/BM68elc.acc", "", 1, "plain text", kG10Rows},
    {"plain_text/ChiChi.dat", "", 1, "plain text", kSi},
    {"plain_text/Christchurch2011HVPS_UP.dat", "", 1, "plain text", kSi},
    {"plain_text/IELC180.acc", "", 1, "plain text", kG10},
    // Velocities that do not say so.
    {"plain_text/ImperialValleyElCentroArray4.txt", "", 1, "plain text", kSi},
    {"plain_text/Northridge.dat", "", 1, "plain text"},
    {"plain_text/Northridge_Sylmar_County.dat", "", 1, "plain text", kSi},
    {"plain_text/RSN1063_NORTHR_RRS228.txt", "", 1, "plain text", kSi},  // velocities, too
    {"plain_text/Sample GM - ElCentro.txt", "", 1, "plain text", kG},
    {"plain_text/SanSalvador1986GIC090.txt", "", 1, "plain text", kSi},
    {"plain_text/elCentro.dat", "", 1, "plain text", kG20Rows},
    {"plain_text/elcentro_NS_full.dat", "", 1, "plain text", kG},
    {"plain_text/eqsig_test_motion_dt0p01.txt", "", 1, "plain text", kSi},
    {"plain_text/record01.txt", "", 1, "plain text", kG10},
    {"plain_text/rrsmv1_1.txt", "", 1, "plain text", kG10},
    // A body of K-NET without its header.
    {"plain_text/sample-MYG",
     ".csv",
     1,
     "plain text",
     {.time_step = 0.01, .si_per_count = 39.20 / 6182761, .columns = "samples"},
     Values::kWithoutMean},
    {"published_reference/NGA_no_1063", ".ref", 1, "the header speaks of 'arias'"},
    {"published_reference/PEER_SearchResults", ".csv", 1, kUnknown},
    {"published_reference/eqsig", ".csv", 1, "the header speaks of 'spectral'"},
    {"published_reference/pyrotd", ".json.gz", 1, "a gzip archive; unpack it first"},
    {"sac/", ".sac", 3, "SAC", kG, Values::kWithoutMean},
    {"ucgmsim_emod3d_text/", "0", 4, "EMOD3D", kG},
    {"ucgmsim_emod3d_text/", ".ver", 2, "EMOD3D", kG},
    {"ucgmsim_emod3d_text/", ".csv", 2, kPsa, kG},
    {"usc_volume/", "a", 2, "USC volume"},
    {"usc_volume/", ".044", 1, "USC blocks"},
    {"usgs_smc/", ".smc", 6, "USGS SMC"},
};

class RealFolder : public RealRecords {
 protected:
  bool is_format(const std::string& name) const {
    return std::ranges::find(formats(), name, &Format::name) != formats().end();
  }

  /// @returns how many reference values there are for the file
  std::size_t check(const std::string& file, const Files& row) const {
    if (!is_format(row.verdict)) {
      EXPECT_THAT(error(file, row.options), testing::HasSubstr(row.verdict));
      return 0;
    }
    const auto components = read(file, row.options);
    EXPECT_EQ(components.at(0).format, row.verdict);
    const auto rows = references(file + ",");
    EXPECT_TRUE(rows.empty() || rows.size() == components.size());
    for (std::size_t i = 0; i < std::min(rows.size(), components.size()); ++i) {
      if (row.values == Values::kInCounts) {
        EXPECT_EQ(components[i].acceleration.size(), rows[i].samples);
        continue;
      }
      Component component = components[i];
      const double mean = component.acceleration.mean();
      if (row.values == Values::kWithoutMean) {
        component.acceleration.array() -= mean;
      } else {
        EXPECT_NEAR(mean, rows[i].mean, 1e-5 * rows[i].pga);
      }
      expect_values(rows[i], component);
    }
    return rows.size();
  }
};

TEST_F(RealFolder, EveryFileIsReadOrRefusedAsListed) {
  std::vector<std::size_t> counts(kFolder.size());
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    if (!entry.is_regular_file()) continue;
    const std::string file = std::filesystem::relative(entry.path(), folder_).generic_string();
    SCOPED_TRACE(file);
    std::size_t rows = 0;
    for (std::size_t i = 0; i < kFolder.size(); ++i) {
      if (!file.starts_with(kFolder[i].start) || !file.ends_with(kFolder[i].end)) continue;
      ++rows;
      ++counts[i];
      compared += check(file, kFolder[i]);
    }
    EXPECT_EQ(rows, 1u) << "rows of the table are for this file";
  }
  for (std::size_t i = 0; i < kFolder.size(); ++i)
    EXPECT_EQ(counts[i], kFolder[i].count) << kFolder[i].start << "*" << kFolder[i].end;
  EXPECT_EQ(compared, references().size());
}

}  // namespace
}  // namespace gurney::groundmotions
