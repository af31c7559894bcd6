#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/units.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/cumulative.h"
#include "groundmotions/measures/response_spectrum.h"
#include "groundmotions/measures/rotation.h"

/// Values that others published of real files, in a folder named by GURNEY_RECORDS.
namespace gurney {
namespace {

using Eigen::VectorXd;

class Published : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("GURNEY_RECORDS");
    if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
    folder_ = folder;
  }
  std::filesystem::path folder_;
};

std::string unzipped(const std::filesystem::path& path) {
  FILE* pipe = popen(("gzip -dc '" + path.string() + "'").c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe))
    text.append(buffer, count);
  pclose(pipe);
  return text;
}

VectorXd vector_of(const nlohmann::json& numbers) {
  const auto values = numbers.get<std::vector<double>>();
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// Spectra of PEER NGA-West2 for RSN 8883, 111 periods from 0.01 to 20 s. PEER takes peaks at the
// samples, but of a finer series where the period is short: they are compared from 10 dt on.
TEST_F(Published, PeerSpectraAtTheSamples) {
  const auto all = nlohmann::json::parse(
      unzipped(folder_ / "published_reference" / "pyrotd_peer_nga_west2.json.gz"));
  const auto& record = all.at(0);
  std::vector<Component> components;
  for (const auto& file : record.at("fnames"))
    components.push_back(read_components(folder_ / "peer_nga_at2" / file.get<std::string>()).at(0));
  const double dt = components[0].time_step;
  const VectorXd periods = vector_of(record.at("period"));
  const VectorXd &h1 = components[0].acceleration, &h2 = components[1].acceleration;
  int compared = 0;
  for (const auto& each : record.at("spectra")) {
    const double damping = each.at("damping");
    std::map<std::string, VectorXd> computed;
    computed["rotd50"] = rotated_spectrum(dt, h1, h2, periods, damping).rotd50;
    computed["h1"] = response_spectrum(dt, h1, periods, damping).pseudo_acceleration;
    computed["h2"] = response_spectrum(dt, h2, periods, damping).pseudo_acceleration;
    for (const auto& [name, psa] : computed) {
      if (!each.contains(name)) continue;
      const VectorXd reference = vector_of(each.at(name)) * kStandardGravity;
      for (Eigen::Index i = 0; i < periods.size(); ++i) {
        SCOPED_TRACE(name + " at " + std::to_string(periods[i]) + " s");
        const double ratio = psa[i] / reference[i];
        if (periods[i] < 10 * dt)
          EXPECT_LT(ratio, 1 + 1e-4);
        else
          EXPECT_NEAR(ratio, 1, 1e-4);
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, 4);
}

/// Two lines of header, then numbers in g.
VectorXd ucgmsim_samples(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  std::getline(stream, line);
  std::vector<double> values;
  for (double value; stream >> value;) values.push_back(value * kStandardGravity);
  return Eigen::Map<VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// The benchmark values of ucgmsim's IM_calculation. It takes 1 g as 9.81 m/s2, integrates |a| and
// a^2 between the samples and CAV with its own interpolation; its spectra are of another
// resolution, so PSA is compared at the level of 1 % from 0.5 s on.
TEST_F(Published, UcgmsimBenchmark) {
  constexpr double kTheirs = 9.81 / kStandardGravity;
  for (const std::string name : {"3366146_DFHS_HN_20", "3468635_CCCC_HN_20"}) {
    SCOPED_TRACE(name);
    const auto folder = folder_ / "ucgmsim_emod3d_text";
    std::ifstream stream(folder / (name + ".im_benchmark.csv"));
    std::vector<std::string> names;
    std::map<std::string, std::map<std::string, std::string>> table;
    for (std::string line; std::getline(stream, line);) {
      std::istringstream cells(line);
      std::vector<std::string> row;
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
      if (names.empty()) names = row;
      for (std::size_t i = 1; i < row.size(); ++i) table[row[0]][names[i]] = row[i];
    }
    Record record;
    const char* endings[] = {".000", ".090", ".ver"};
    for (std::size_t i = 0; i < 3; ++i)
      record.components[i] = Component{
          .time_step = 0.005, .acceleration = ucgmsim_samples(folder / (name + endings[i]))};
    const auto compare = [&](const char* column, const char* measure, const char* row,
                             Combination combination, double to_si, double tolerance) {
      const double theirs = *number(table.at(row).at(column)) * to_si;
      const double ours = value_of(parse_measure(measure), combination, record);
      std::printf("%s %s %s %.5f\n", name.c_str(), measure, row, ours / theirs - 1);
      EXPECT_NEAR(ours / theirs, 1, tolerance) << measure << " " << row;
    };
    const std::pair<const char*, Combination> kinds[] = {
        {"000", Combination::kH1},        {"090", Combination::kH2},
        {"ver", Combination::kVertical},  {"geom", Combination::kGeometricMean},
        {"rotd50", Combination::kRotD50}, {"rotd100", Combination::kRotD100},
        {"rotd0", Combination::kRotD00}};
    for (const auto& [row, combination] : kinds) {
      compare("PGA", "PGA", row, combination, kStandardGravity, 1e-6);
      compare("PGV", "PGV", row, combination, 0.01 / kTheirs, 1e-4);
      compare("pSA_0.5", "Sa(0.5)", row, combination, kStandardGravity, 0.01);
      compare("pSA_1.0", "Sa(1.0)", row, combination, kStandardGravity, 0.01);
      compare("pSA_2.0", "Sa(2.0)", row, combination, kStandardGravity, 0.01);
      if (std::string(row).starts_with("rotd")) continue;
      compare("AI", "Arias", row, combination, 1 / kTheirs, 0.01);
      compare("CAV", "CAV", row, combination, 1 / kTheirs, 0.02);
      compare("Ds575", "D5-75", row, combination, 1, 0.001);
      compare("Ds595", "D5-95", row, combination, 1, 0.001);
    }
  }
}

}  // namespace
}  // namespace gurney
