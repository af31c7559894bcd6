#include "groundmotions/selection/selection_target.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::groundmotions {
namespace {

const Eigen::VectorXd kPeriods{{0.1, 0.3, 1, 3}};

SelectionTarget read(const std::string& text, const std::string& path = "job.toml") {
  config::Document document(text, path);
  config::Table root = document.root();
  const auto target = read_selection_target(root, kPeriods);
  document.finish();
  return *target;
}

TEST(SelectionTarget, OfAScenario) {
  const SelectionTarget t = read(
      "target = 'bssa14'\nmagnitude = 7\ndistance_km = 10\nvs30_m_per_s = 400\nfaulting = "
      "'reverse'\n");
  EXPECT_EQ(t.name, "Boore et al. (2014), M 7, R_JB 10 km, V_S30 400 m/s, reverse");
  EXPECT_FALSE(t.conditioning);
  EXPECT_NEAR(std::exp(t.spectrum.mean[2]), bssa14_sa({7, 10, 400, Faulting::kReverse}, 1).median,
              1e-12);
}

// The ranges of Boore et al. (2014) [their abstract]: M 3 to 8.5, 0 to 400 km, V_S30 150 to 1500 m/s.
TEST(SelectionTarget, TakesScenariosToTheEndsOfTheModel) {
  const auto scenario = [](double magnitude, double distance, double vs30) {
    return read(
        fmt::format("target = 'bssa14'\nmagnitude = {}\ndistance_km = {}\nvs30_m_per_s = {}\n",
                    magnitude, distance, vs30));
  };
  EXPECT_NO_THROW(scenario(3, 0, 150));
  EXPECT_NO_THROW(scenario(8.5, 400, 1500));
  EXPECT_ERROR(scenario(2.9, 10, 400), "magnitude = 2.9: must be");
  EXPECT_ERROR(scenario(8.6, 10, 400), "magnitude = 8.6: must be");
  EXPECT_ERROR(scenario(7, 401, 400), "distance_km = 401: must be");
  EXPECT_ERROR(scenario(7, 10, 149), "vs30_m_per_s = 149: must be");
  EXPECT_ERROR(scenario(7, 10, 1501), "vs30_m_per_s = 1501: must be");
}

TEST(SelectionTarget, OfAConditionalSpectrum) {
  const std::string scenario = "target = 'conditional'\nmagnitude = 7\ndistance_km = 10\n";
  const SelectionTarget by_epsilon = read(scenario + "period_s = 0.5\nepsilon = 1\n");
  const Prediction p = bssa14_sa({7, 10}, 0.5);
  EXPECT_EQ(*by_epsilon.conditioning, 2);  // T* is added to the periods
  EXPECT_EQ(by_epsilon.spectrum.periods[2], 0.5);
  EXPECT_EQ(by_epsilon.spectrum.periods.size(), 5);
  EXPECT_NEAR(by_epsilon.spectrum.mean[2], std::log(p.median) + p.sigma(), 1e-12);
  EXPECT_EQ(read(scenario + "period_s = 0.3000000001\nepsilon = 1\n").spectrum.periods.size(), 4);
  const SelectionTarget by_sa = read(scenario + "period_s = 1\nsa_g = 0.6\n");
  EXPECT_EQ(by_sa.spectrum.periods.size(), 4);  // 1 s is among them
  EXPECT_NEAR(by_sa.spectrum.mean[2], std::log(0.6 * kStandardGravity), 1e-12);
  EXPECT_EQ(by_sa.spectrum.sigma()[2], 0);
  EXPECT_THAT(by_sa.name, testing::StartsWith("Sa(1 s) = 0.6 g, epsilon "));
}

TEST(SelectionTarget, ReportsAllErrors) {
  const std::string bad =
      "target = 'conditional'\nmagnitude = 9\ndistance_km = 10\nperiod_s = 5\nepsilonn = 1\n";
  EXPECT_ERROR(read(bad), "job.toml:2:13: magnitude = 9: must be");
  EXPECT_ERROR(read(bad), "job.toml:4:12: period_s = 5: must be");
  EXPECT_ERROR(read(bad), "a conditional spectrum needs epsilon or sa_g, one of the two");
  EXPECT_ERROR(read(bad), "did you mean 'epsilon'?");
  EXPECT_ERROR(read("target = 'conditonal'\n"), "did you mean 'conditional'?");
  EXPECT_ERROR(read("target = 'bssa14'\nmagnitude = 7\n"), "distance_km");
}

TEST(SelectionTarget, OfATable) {
  const TempFolder folder;
  folder.write("plain.csv", "period_s, sa_g\n0.1, 1\n3, 0.2\n");
  folder.write("sigma.csv", "period_s, sa_g, sigma_ln\n0.1, 1, 0.4\n1, 0.5, 0\n3, 0.2, 0.6\n");
  const auto table = [&](const std::string& more) {
    return read("target = 'table'\n" + more, folder.file("job.toml"));
  };
  const SelectionTarget plain = table("file = 'plain.csv'\n");
  EXPECT_TRUE(plain.spectrum.covariance.isZero(0));
  EXPECT_NEAR(std::exp(plain.spectrum.mean[0]), kStandardGravity, 1e-12);
  const SelectionTarget t = table("file = 'sigma.csv'\nperiod_s = 1\n");
  EXPECT_EQ(*t.conditioning, 2);
  EXPECT_NEAR(t.spectrum.sigma()[0], 0.4, 1e-12);
  EXPECT_NEAR(t.spectrum.sigma()[3], 0.6, 1e-12);
  EXPECT_EQ(t.spectrum.sigma()[2], 0);
  EXPECT_ERROR(table("file = 'none.csv'\n"), "none.csv");
}

}  // namespace
}  // namespace gurney::groundmotions
