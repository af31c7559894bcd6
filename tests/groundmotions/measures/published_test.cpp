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
namespace gurney::groundmotions {
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

// The benchmark values of ucgmsim's IM_calculation, which takes 1 g as 9.81 m/s2, integrates
// exactly between the samples, and counts durations in samples. How its spectra are made is not
// stated; PSA agrees to 0.6 % from 0.5 s on, which is no more than a check of units and
// combinations.
TEST_F(Published, UcgmsimBenchmark) {
  constexpr double kTheirs = 9.81 / kStandardGravity, kTimeStep = 0.005;
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
    for (std::size_t i = 0; i < 3; ++i) {
      Component& component = record.components[i].emplace();
      component.time_step = kTimeStep;
      component.acceleration = ucgmsim_samples(folder / (name + endings[i]));
    }
    const auto theirs = [&](const char* row, const char* column) {
      return *number(table.at(row).at(column));
    };
    const std::pair<const char*, Combination> kinds[] = {
        {"000", Combination::kH1},        {"090", Combination::kH2},
        {"ver", Combination::kVertical},  {"geom", Combination::kGeometricMean},
        {"rotd50", Combination::kRotD50}, {"rotd100", Combination::kRotD100},
        {"rotd0", Combination::kRotD00}};
    for (const auto& [row, combination] : kinds) {
      SCOPED_TRACE(row);
      const auto ours = [&](const char* measure) {
        return value_of(parse_measure(measure), combination, record);
      };
      EXPECT_NEAR(ours("PGA") / kStandardGravity / theirs(row, "PGA"), 1, 1e-6);
      EXPECT_NEAR(ours("PGV") / 0.01 * kTheirs / theirs(row, "PGV"), 1, 1e-5);
      for (const std::string period : {"0.5", "1.0", "2.0"})
        EXPECT_NEAR(ours(("Sa(" + period + ")").c_str()) / kStandardGravity /
                        theirs(row, ("pSA_" + period).c_str()),
                    1, 0.006);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const char* row = kinds[i].first;
      SCOPED_TRACE(row);
      const VectorXd& a = record.components[i]->acceleration;
      const double cav = cumulative_absolute_velocity(kTimeStep, a, Rule::kExact);
      EXPECT_NEAR(cav * kTheirs / theirs(row, "CAV"), 1, 1e-5);
      EXPECT_NEAR(arias_intensity(kTimeStep, a) / theirs(row, "AI"), 1, 0.005);
      const double d575 = significant_part(kTimeStep, a, 0.05, 0.75).duration();
      const double d595 = significant_part(kTimeStep, a, 0.05, 0.95).duration();
      EXPECT_NEAR(d575, theirs(row, "Ds575"), kTimeStep);
      EXPECT_NEAR(d595, theirs(row, "Ds595"), 5 * kTimeStep);
    }
  }
}

}  // namespace
}  // namespace gurney::groundmotions
