#include "studies/analysis/record_ranking.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/base/random/normal_draw.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class RecordRankingTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SyntheticRun>& runs, std::size_t records) {
    study_of_records(records, runs).write(folder_.file("s.h5"));
    return StudyData(folder_.file("s.h5"));
  }
  TempFolder folder_;
};

/// Two draws of each record at two levels, ruled by PFV. The first record moves the item least at the higher
/// level, and has the largest displacement at the lower one, which is not asked for.
std::vector<SyntheticRun> ruled_by_pfv(std::size_t records) {
  std::vector<SyntheticRun> runs;
  for (std::size_t i = 0; i < records; ++i)
    for (int level = 1; level <= 2; ++level)
      for (int draw = 0; draw < 2; ++draw) {
        SyntheticRun run{0, i, double(level)};
        run.draw = draw;
        run.pfv = 0.1 * std::pow(1.3, double(i));
        run.displacement = level == 1 ? 9 - double(i)
                                      : 0.5 * std::pow(run.pfv, 1.2) *
                                            std::exp(0.2 * normal_draw(7, i, std::uint64_t(draw)));
        runs.push_back(run);
      }
  return runs;
}

/// a + b x at x[k] by least squares through all other points.
double by_the_others(const std::vector<double>& x, const std::vector<double>& y, std::size_t k) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i == k) continue;
    n += 1, sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  }
  const double b = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  return (sy - b * sx) / n + b * x[k];
}

TEST_F(RecordRankingTest, PredictsEachRecordByALineThroughTheOthers) {
  constexpr std::size_t kRecords = 8;
  const StudyData study = data(ruled_by_pfv(kRecords), kRecords);
  const std::vector<RecordRanking> rankings = rank_records({&study, 0}, {});
  ASSERT_EQ(rankings.size(), 1);
  const RecordRanking& ranking = rankings[0];
  ASSERT_EQ(ranking.records.size(), kRecords);
  ASSERT_THAT(ranking.measures, testing::Not(IsEmpty()));
  EXPECT_EQ(ranking.measures[0].name, "pfv");
  EXPECT_EQ(ranking.predicted, kRecords);
  std::vector<double> x, y;
  for (std::size_t i = 0; i < kRecords; ++i) {
    const RankedRecord& of = ranking.records[i];
    EXPECT_EQ(of.runs.size(), 2);
    x.push_back(std::log(ranking.measures[0].values[i]));
    y.push_back(std::log(of.demand));
  }
  EXPECT_TRUE(std::ranges::is_sorted(y, std::ranges::greater()));
  double of_line = 0, of_mean = 0, sum = 0;
  for (const double each : y) sum += each;
  for (std::size_t i = 0; i < kRecords; ++i) {
    const double predicted = by_the_others(x, y, i);
    // Sums of eight numbers of order 1 to 10.
    EXPECT_NEAR(std::log(ranking.records[i].predicted), predicted, 1e-12) << i;
    of_line += std::pow(y[i] - predicted, 2);
    of_mean += std::pow(y[i] - (sum - y[i]) / (kRecords - 1), 2);
  }
  EXPECT_NEAR(ranking.measures[0].explained, 1 - of_line / of_mean, 1e-12);
  EXPECT_GT(ranking.measures[0].explained, 0.5);
}

TEST_F(RecordRankingTest, PutsOverturningFirstAndPredictsTheOthersOnly) {
  std::vector<SyntheticRun> runs = ruled_by_pfv(7);
  for (SyntheticRun& run : runs)
    if (run.level == 2 && (run.record == 1 || (run.record == 2 && run.draw == 1))) run.fell = true;
  const StudyData study = data(runs, 7);
  const RecordRanking ranking = rank_records({&study, 0}, {}).at(0);
  EXPECT_EQ(ranking.records[0].name, "r1");
  EXPECT_EQ(ranking.records[0].overturned, 2);
  EXPECT_EQ(ranking.records[1].name, "r2");
  EXPECT_EQ(ranking.records[1].overturned, 1);
  EXPECT_TRUE(std::isnan(ranking.records[0].predicted));
  EXPECT_TRUE(std::isnan(ranking.records[1].predicted));
  EXPECT_GT(ranking.records[2].predicted, 0);
  EXPECT_EQ(ranking.predicted, 5);
}

TEST_F(RecordRankingTest, PredictsNothingFromFourRecords) {
  const StudyData four = data(ruled_by_pfv(4), 4);
  const RecordRanking ranking = rank_records({&four, 0}, {.level = 0}).at(0);
  EXPECT_EQ(ranking.records.front().name, "r0");
  EXPECT_THAT(ranking.measures, IsEmpty());
}

TEST_F(RecordRankingTest, RefusesOneRecordAndALevelThatIsNotThere) {
  const StudyData one = data(ruled_by_pfv(1), 1);
  EXPECT_THAT(error_text([&] { rank_records({&one, 0}, {}); }), HasSubstr("has one record at"));
  EXPECT_THAT(error_text([&] {
                rank_records({&one, 0}, {.level = 2});
              }),
              HasSubstr("--level 3: the study has 2 levels"));
}

}  // namespace
}  // namespace gurney::study
