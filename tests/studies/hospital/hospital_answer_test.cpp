#include "studies/hospital/hospital_answer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"
#include "tests/support/cart_prices.h"
#include "tests/support/error_text.h"
#include "tests/support/spreadsheet_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

const std::string kConsequences = kCartPrices + R"([[consequence]]
limit_state = "moved"
cost_ratio = 0.1
days = 1
injury = "none"
service = "kept"
[[consequence]]
limit_state = "fell"
cost_ratio = 0.6
days = 7
injury = "serious"
service = "lost"
)";

constexpr const char* kCurves =
    "item,floor,place,brakes,limit_state,measure,unit,theta,theta_low,theta_high,beta,reason\n"
    "cart,ground,open,off,moved,PGV larger,m/s,0.3,0.25,0.36,0.5,\n"
    "cart,ground,open,off,fell,PGV larger,m/s,0.6,0.5,0.72,0.4,\n"
    "cart,ground,open,on,moved,PGV larger,m/s,0.8,0.7,0.9,0.5,\n"
    "cart,ground,open,on,fell,PGV larger,m/s,0.5,0.4,0.6,0.4,\n"
    "cart,high,open,off,fell,PGV larger,m/s,,,,,no run exceeds: median above 1.5 m/s\n"
    "cart,high,open,on,fell,PGV larger,m/s,,,,,no run exceeds: median above 1.5 m/s\n";

constexpr const char* kHospital = R"TOML(schema = "gurney-hospital/1"
title = "Carts"
consequences = "consequences.toml"
curves = "curves.csv"
[motion]
pgv_m_per_s = [0.2, 0.5]
correlation = 0.5
[[storey]]
name = "first"
[[room]]
name = "bay"
storey = "first"
count = 3
beds = 2
works = "at_least(3, cart)"
[[room.item]]
name = "cart"
equipment = "cart"
count = 5
[[service]]
name = "all bays"
works = "bay"
[[service]]
name = "one bay"
works = "any(bay)"
[[action]]
name = "tether"
items = "bay/cart"
tether_holds = 0.5
cost = 20
[[action]]
name = "brakes"
items = ["bay/cart"]
brakes = "on"
cost = 1
)TOML";

class HospitalTest : public testing::Test {
 protected:
  HospitalTest() {
    folder_.write("consequences.toml", kConsequences);
    folder_.write("curves.csv", kCurves);
  }

  Hospital hospital(const std::string& from = "", const std::string& to = "") {
    std::string text = kHospital;
    if (!from.empty()) {
      EXPECT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    return read_hospital(folder_.write("h.toml", text));
  }

  HospitalAnswer answer(const Hospital& of, HospitalRequest request = {}) {
    request.samples = kSamples;
    return hospital_answer(of, Consequences::read(of.consequences), request);
  }

  std::string error(const std::string& from, const std::string& to) {
    return error_text([&] { answer(hospital(from, to)); });
  }

  static constexpr std::size_t kSamples = 10000;
  /// Bernstein's inequality: a share of n samples is farther off with a probability of at most 2
  /// exp(-15), one in two million, also where it is rare.
  static double bound(double p) {
    const double n = kSamples;
    return std::sqrt(2 * 15 * p * (1 - p) / n) + 15 / (3 * n);
  }

  TempFolder folder_;
};

/// P(at least 3 of 5 work).
double bay_works(double fails) { return 1 - statistics::binomial_cdf(2, 5, 1 - fails); }

double falls(double im, double theta = 0.6, double beta = 0.4) {
  return normal_cdf(std::log(im / theta) / beta);
}

/// Of a function of P(fails | z), over the common normal score z: Simpson's rule on [-8, 8].
double over_motions(double correlation, double im, const std::function<double(double)>& of) {
  constexpr int kPanels = 4000;
  const double step = 16.0 / kPanels, threshold = std::log(im / 0.6) / 0.4;
  double sum = 0;
  for (int i = 0; i <= kPanels; ++i) {
    const double z = -8 + step * i;
    const double fails =
        normal_cdf((threshold - std::sqrt(correlation) * z) / std::sqrt(1 - correlation));
    const double weight = i == 0 || i == kPanels ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * step / 3 * statistics::normal_density(z) * of(fails);
  }
  return sum;
}

TEST_F(HospitalTest, IndependentPiecesHaveTheBinomialClosedForm) {
  const HospitalAnswer found = answer(hospital("correlation = 0.5", "correlation = 0"));
  for (const LevelAnswer& level : found.levels) {
    const double bay = bay_works(falls(level.pgv)), all = std::pow(bay, 3),
                 one = 1 - std::pow(1 - bay, 3);
    EXPECT_NEAR(level.services[0].works.value, all, bound(all));
    EXPECT_NEAR(level.services[1].works.value, one, bound(one));
    // Means of 3 bays, which are no wider than one of them.
    EXPECT_NEAR(level.rooms[0].works.value, bay, bound(bay));
    EXPECT_NEAR(level.beds_out.value, 6 * (1 - bay), 6 * bound(bay));
  }
}

TEST_F(HospitalTest, PiecesOfOneMotionHaveTheMixtureOfBinomials) {
  const HospitalAnswer found = answer(hospital());
  for (const LevelAnswer& level : found.levels) {
    const double all =
        over_motions(0.5, level.pgv, [](double fails) { return std::pow(bay_works(fails), 3); });
    const double one = over_motions(
        0.5, level.pgv, [](double fails) { return 1 - std::pow(1 - bay_works(fails), 3); });
    EXPECT_NEAR(level.services[0].works.value, all, bound(all));
    EXPECT_NEAR(level.services[1].works.value, one, bound(one));
    // The motion alone decides: all fall or none.
    const double none = 1 - falls(level.pgv);
    EXPECT_NEAR(*level.services[0].dependent, none, bound(none));
    EXPECT_EQ(*level.services[0].dependent, *level.services[1].dependent);
  }
  // Dependence helps what needs all, and hurts what needs one.
  const LevelAnswer& strong = found.levels[1];
  EXPECT_GT(strong.services[0].works.value, *strong.services[0].independent);
  EXPECT_LT(strong.services[1].works.value, *strong.services[1].independent);
}

TEST_F(HospitalTest, TheLossIsThatOfTheWorstStateWhateverTheCorrelation) {
  for (const char* correlation : {"correlation = 0", "correlation = 1"}) {
    const HospitalAnswer found = answer(hospital("correlation = 0.5", correlation));
    for (const LevelAnswer& level : found.levels) {
      const double moved = falls(level.pgv, 0.3, 0.5), fell = falls(level.pgv);
      // States share the score of a piece. It falls at scores below a, moves at those below b > a.
      const double expected = 15 * (100 * std::max(moved, fell) + 500 * fell);
      // The loss of a piece is at most 600: its standard deviation is at most 300.
      EXPECT_NEAR(level.loss.value, expected, 5 * 15 * 300 / std::sqrt(kSamples));
    }
  }
}

TEST_F(HospitalTest, DoesNotDependOnThreads) {
  HospitalRequest threads;
  threads.threads = 3;
  const HospitalAnswer one = answer(hospital()), three = answer(hospital(), threads);
  for (std::size_t i = 0; i < one.levels.size(); ++i) {
    EXPECT_EQ(one.levels[i].loss.value, three.levels[i].loss.value);
    EXPECT_EQ(one.levels[i].loss.interval.low, three.levels[i].loss.interval.low);
    EXPECT_EQ(one.levels[i].services[0].works.interval.high,
              three.levels[i].services[0].works.interval.high);
  }
  EXPECT_EQ(one.ranking[0].gain.interval.low, three.ranking[0].gain.interval.low);
}

TEST_F(HospitalTest, RanksByTheGainForTheCost) {
  HospitalRequest by_loss;
  by_loss.by = "loss";
  const HospitalAnswer found = answer(hospital(), by_loss);
  ASSERT_EQ(found.ranking.size(), 2);
  // Brakes make carts fall, but keep them from moving: at 0.5 m/s both cost more than they save.
  EXPECT_EQ(found.ranking[0].name, "tether");
  EXPECT_EQ(found.ranking[0].pieces, 15);
  EXPECT_EQ(found.ranking[0].cost, 300);
  EXPECT_EQ(found.ranked_at, 0.5);
  const double before = 15 * (100 * falls(0.5, 0.3, 0.5) + 500 * falls(0.5));
  // Half of the tethers hold. Pieces have a deviation of at most 300, 15 of them if all are alike.
  const double error = 5 * 15 * 300 / std::sqrt(kSamples);
  EXPECT_NEAR(found.before, before, error);
  // The same samples, as sums of whole numbers.
  EXPECT_EQ(found.before, found.levels[1].loss.value) << "one number for one thing";
  EXPECT_NEAR(found.ranking[0].gain.value, before / 2, error);
  EXPECT_TRUE(found.ranking[0].taken);
  EXPECT_LE(found.ranking[0].gain.interval.low, found.ranking[0].gain.value);
  // States share the score of a piece: what falls has moved.
  const double fell = falls(0.5, 0.5, 0.4), moved = std::max(falls(0.5, 0.8, 0.5), fell);
  const double braked = 15 * (100 * moved + 500 * fell);
  EXPECT_NEAR(found.ranking[1].gain.value, before / 2 - braked / 2, error);
}

TEST_F(HospitalTest, ReadsCurvesOfASpreadsheet) {
  const double loss = answer(hospital()).levels[1].loss.value;
  folder_.write("curves.csv", spreadsheet_text(kCurves));
  EXPECT_EQ(answer(hospital()).levels[1].loss.value, loss);
}

TEST_F(HospitalTest, FewOutcomesAreBoundedByThoseJustAbove) {
  folder_.write("curves.csv",
                "item,floor,place,brakes,limit_state,measure,unit,runs,exceed,theta,theta_low,"
                "theta_high,beta,reason\n"
                "cart,few,open,off,fell,PGV larger,m/s,128,8,,,,,quasi-complete separation\n"
                "cart,few,open,on,fell,PGV larger,m/s,128,0,,,,,no run exceeds\n"
                "cart,curve,open,off,fell,PGV larger,m/s,128,2,0.3,0.2,inf,0.4,\n"
                "cart,curve,open,on,fell,PGV larger,m/s,128,40,0.3,0.25,0.36,0.4,\n");
  folder_.write("above.csv",
                "item,floor,place,brakes,limit_state,measure,0.2,0.5,0.8\n"
                "cart,few,open,off,fell,PGV larger,0/32,1/32,8/32\n"
                "cart,curve,open,off,fell,PGV larger,0/32,0/32,2/32\n"
                "cart,curve,open,on,fell,PGV larger,0/32,0/32,2/32\n");
  const auto on = [&](const std::string& floor, const std::string& brakes,
                      const std::string& levels) {
    std::string text = kHospital;
    const auto put = [&](const std::string& from, const std::string& to) {
      text.replace(text.find(from), from.size(), to);
    };
    put("\"curves.csv\"", "[\"curves.csv\", \"above.csv\"]");
    put("name = \"first\"", "name = \"first\"\nfloor = \"" + floor + "\"");
    put("equipment = \"cart\"", "equipment = \"cart\"\nbrakes = \"" + brakes + "\"");
    put("[0.2, 0.5]", levels);
    text.erase(text.find("[[action]]"));
    return answer(read_hospital(folder_.write("h.toml", text)));
  };
  // 15 carts, 600 each that falls; a share of 15 x 10000 outcomes that a motion decides in part.
  const auto chance = [](const HospitalAnswer& of, std::size_t level) {
    return of.levels[level].loss.value / (15 * 600);
  };
  const auto jeffreys = [](double k, double n) {
    return statistics::beta_quantile(0.5, k + 0.5, n - k + 0.5);
  };
  const auto expect = [&](double found, double expected) {
    EXPECT_NEAR(found, expected, bound(expected)) << expected;
  };
  const HospitalAnswer few = on("few", "off", "[0.5, 0.6, 2]");
  expect(chance(few, 0), jeffreys(1, 32));
  expect(chance(few, 1), jeffreys(8, 32));  // as just above, at 0.8 m/s
  expect(chance(few, 2), jeffreys(8, 32));
  EXPECT_THAT(few.cautions, testing::Contains(HasSubstr("2 m/s: beyond the runs of the curves")));
  EXPECT_GT(few.levels[0].loss.interval.high, 2 * few.levels[0].loss.value)
      << "1 of 32 is not known to be 1 of 32";
  expect(chance(on("few", "on", "[0.5, 0.6]"), 1), jeffreys(0, 128));
  // The curve of two falls has 0.9 at 0.5 m/s, where none of 32 fell just above; that of 40 is believed.
  expect(chance(on("curve", "off", "[0.2, 0.5]"), 1), jeffreys(0, 32));
  expect(chance(on("curve", "on", "[0.2, 0.5]"), 1), falls(0.5, 0.3, 0.4));
}

// With a scatter of the floors' velocities each sample is bounded at its own: the mean of both sides of a count.
TEST_F(HospitalTest, FewOutcomesAreBoundedAtTheVelocityOfTheSample) {
  folder_.write("curves.csv",
                "item,floor,place,brakes,limit_state,measure,unit,runs,exceed,theta,theta_low,"
                "theta_high,beta,reason\n"
                "cart,ground,open,off,fell,pfv,m/s,128,8,,,,,quasi-complete separation\n");
  folder_.write("above.csv",
                "item,floor,place,brakes,limit_state,measure,0.5,5\n"
                "cart,ground,open,off,fell,pfv,0/32,8/32\n");
  std::string text = kHospital;
  const auto put = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  put("\"curves.csv\"", "[\"curves.csv\", \"above.csv\"]");
  put("name = \"first\"", "name = \"first\"\npfv_over_pgv = 1\npfv_beta = 0.4");
  put("[0.2, 0.5]", "[0.5]");
  text.erase(text.find("[[action]]"));
  const HospitalAnswer found = answer(read_hospital(folder_.write("h.toml", text)));
  const double expected =
      (statistics::beta_quantile(0.5, 0.5, 32.5) + statistics::beta_quantile(0.5, 8.5, 24.5)) / 2;
  EXPECT_NEAR(found.levels[0].loss.value / (15 * 600), expected, bound(expected));
}

TEST_F(HospitalTest, SaysWhatHasNoCurve) {
  const HospitalAnswer high =
      answer(hospital("name = \"first\"", "name = \"first\"\nfloor = \"high\""));
  EXPECT_EQ(high.levels[1].loss.value, 0);
  EXPECT_THAT(high.cautions, testing::IsSupersetOf(
                                 {HasSubstr("'moved': no curve of this limit state, which counts "
                                            "as never reached (cart)"),
                                  HasSubstr("fell: too few runs exceed for a curve")}));
}

TEST_F(HospitalTest, ErrorsHavePlaces) {
  EXPECT_THAT(error("equipment = \"cart\"", "equipment = \"card\""),
              HasSubstr("h.toml:18:13: 'card': no curves of this item; did you mean 'cart'?"));
  EXPECT_THAT(error("works = \"bay\"", "works = \"bays\""),
              HasSubstr("h.toml:22:9: service[0].works: at character 1: 'bays': no such item, room "
                        "or service; did you mean 'bay'?"));
  EXPECT_THAT(error("works = \"bay\"", "works = \"all(bay, 'x')\""), HasSubstr("at character 10"));
  EXPECT_THAT(error("works = \"bay\"", "works = 'any(\"one bay\", bay)'"), HasSubstr("(no error)"));
  EXPECT_THAT(error("works = \"any(bay)\"", "works = 'all(bay, \"one bay\")'"),
              HasSubstr("h.toml:25:9: service[1].works: at character 10: a circle: one bay -> one "
                        "bay"));
  EXPECT_THAT(error("at_least(3, cart)", "at_least(6, cart)"),
              HasSubstr("room[0].works: at character 1: at_least(6, ...) of 5 parts: must be 1 to "
                        "5"));
  EXPECT_THAT(error("works = \"bay\"", "works = \"not_reached(bay/cart, fallen)\""),
              HasSubstr("'fallen': no such limit state; known: moved, fell"));
  EXPECT_THAT(error("cost = 20", "cost = -20"),
              HasSubstr("action[0].cost = -20: must be a finite number >= 0"));
  EXPECT_THAT(error("tether_holds = 0.5", "tether_holds = 1.5"),
              HasSubstr("action[0].tether_holds = 1.5: must be"));
  EXPECT_THAT(error("correlation = 0.5", "correlation = 2"), HasSubstr("motion.correlation = 2"));
  EXPECT_THAT(error("items = \"bay/cart\"", "items = \"bay/bed\""),
              HasSubstr("action[0].items = \"bay/bed\": no such item; known: bay/cart"));
  EXPECT_THAT(error("storey = \"first\"", "storey = \"frist\""),
              HasSubstr("storey = \"frist\": must be \"first\""));
  EXPECT_THAT(error("name = \"first\"", "name = \"first\"\nfloor = \"grond\""),
              HasSubstr("h.toml:9:8: floor 'grond': no curves on it; did you mean 'ground'?"));
  EXPECT_THAT(error("count = 5", "items = \"none.csv\""), HasSubstr("unknown key"));
  EXPECT_THAT(error("[0.2, 0.5]", "[0.5, 0.2]"), HasSubstr("motion.pgv_m_per_s: must increase"));
}

TEST_F(HospitalTest, ReadsItemsFromATable) {
  const std::string items = "name,equipment,count,brakes,share_braked\ncart,cart,5,on,0.4\n";
  folder_.write("items.csv", items);
  const auto with_table = [&] {
    std::string text = kHospital;
    const std::string table = "[[room.item]]\nname = \"cart\"\nequipment = \"cart\"\ncount = 5\n";
    text.replace(text.find(table), table.size(), "items = \"items.csv\"\n");
    return read_hospital(folder_.write("h.toml", text));
  };
  const Hospital read = with_table();
  ASSERT_EQ(read.rooms[0].items.size(), 1);
  EXPECT_EQ(read.rooms[0].items[0].count, 5);
  EXPECT_EQ(read.rooms[0].items[0].securing.share, 0.4);
  folder_.write("items.csv", spreadsheet_text(items));
  EXPECT_EQ(with_table().rooms[0].items[0].securing.share, 0.4) << "a table of a spreadsheet";
  const double fails = 0.4 * falls(0.5, 0.5, 0.4) + 0.6 * falls(0.5);
  // The share is of each piece by itself; the mean over bays has no larger deviation than one.
  Hospital independent = read;
  independent.correlation = 0;
  const double bay = bay_works(fails);
  EXPECT_NEAR(answer(independent).levels[1].rooms[0].works.value, bay, bound(bay));
  folder_.write("items.csv", "name,equipment,count\r\ncart,cart,many\r\n");
  EXPECT_THAT(error_text(with_table),
              HasSubstr("items.csv:2:11: count = 'many': must be a number"));
  folder_.write("items.csv", "name,equipment,brakes\ncart,cart,onn\n");
  EXPECT_THAT(error_text(with_table), HasSubstr("items.csv:2:1: brakes = \"onn\": must be one of"));
  folder_.write("items.csv", "name,equipement\ncart,cart\n");
  EXPECT_THAT(error_text(with_table), HasSubstr("unknown column; did you mean 'equipment'?"));
}

}  // namespace
}  // namespace gurney::study
