#include "studies/analysis/stored_histories.h"

#include <gmock/gmock.h>

#include "studies/results/results_file.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/support/error_text.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(StoredHistories, OfOneRunAreItsSamples) {
  const TempFolder folder;
  const Response response = synthetic_response();
  const std::string path = folder.write("r.h5", results_image(synthetic_facts(), response));
  const StoredHistories stored(path);
  EXPECT_THAT(stored.names(), testing::AllOf(Contains("displacement"), Contains("normal_force")));
  EXPECT_THAT(stored.names(), testing::Not(Contains("orientation")));
  EXPECT_THAT(stored.runs(), ElementsAre(0));
  const std::vector<Sample>& samples = response.items[0].history;
  const StoredHistory displacement = stored.history("displacement", 0);
  ASSERT_EQ(displacement.series.size(), 3u);
  EXPECT_EQ(displacement.series[1].axis, "y");
  EXPECT_EQ(displacement.series[1].part, "") << "the only item";
  ASSERT_EQ(displacement.time.size(), samples.size());
  const StoredHistory force = stored.history("normal_force", 0);
  ASSERT_EQ(force.series.size(), 4u);
  EXPECT_EQ(force.series[2].part, synthetic_facts().scene.items[0].model.casters[2].name);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(displacement.series[1].values[i], samples[i].displacement.y());
    EXPECT_EQ(force.series[2].values[i], samples[i].wheels[2].normal_force);
  }
  EXPECT_THAT(error_text([&] { stored.history("displacment", 0); }),
              HasSubstr("did you mean 'displacement'?"));
  EXPECT_THAT(error_text([&] { stored.history("tilt", 3); }),
              HasSubstr("no histories of run 3; it has those of 1 runs: 0"));
}

TEST(StoredHistories, OfSeveralItemsNameThem) {
  const TempFolder folder;
  const Response response = synthetic_ward_response();
  const study::RunFacts facts = synthetic_ward();
  const std::string path = folder.write("r.h5", results_image(facts, response));
  const StoredHistory displacement = StoredHistories(path).history("displacement", 0);
  ASSERT_EQ(displacement.series.size(), 3 * response.items.size());
  const std::size_t last = response.items.size() - 1;
  EXPECT_EQ(displacement.series[3 * last].part, facts.scene.items[last].model.name);
  ASSERT_EQ(displacement.time.size(), response.items[last].history.size());
  for (std::size_t i = 0; i < displacement.time.size(); ++i)
    EXPECT_EQ(displacement.series[3 * last + 1].values[i],
              response.items[last].history[i].displacement.y());
}

TEST(StoredHistories, OfAStudyAreTheRowsOfARun) {
  const TempFolder folder;
  {
    Hdf5Writer file(folder.file("s.h5"));
    file.set_attribute("/", "filetype", std::string("gurney-study"));
    file.set_attribute("/", "title", std::string("rows"));
    GrowingTable table(file, "histories");
    table.add_whole("run", "run");
    table.add_text("item", "item", 4);
    for (const char* name : {"time", "displacement_x", "displacement_y", "tilt"})
      table.add_number(name, "m", name);
    for (const double run : {2.0, 5.0})
      for (const double time : {0.0, 0.5})
        for (const char* item : {"a", "b"})
          table.put(run).put(item).put(time).put(run + time + *item).put(7.0).put(run).end_row();
    table.finish();
    file.finish();
  }
  const StoredHistories stored(folder.file("s.h5"));
  EXPECT_THAT(stored.names(), ElementsAre("displacement", "tilt"));
  EXPECT_THAT(stored.runs(), ElementsAre(2, 5));
  const StoredHistory of = stored.history("displacement", 5);
  EXPECT_THAT(of.time, ElementsAre(0, 0.5));
  ASSERT_EQ(of.series.size(), 4u);
  EXPECT_EQ(of.series[2].part, "b");
  EXPECT_EQ(of.series[2].axis, "x");
  EXPECT_THAT(of.series[2].values, ElementsAre(5.0 + 'b', 5.5 + 'b'));
}

TEST(StoredHistories, SayWhatIsMissing) {
  const TempFolder folder;
  write_small_study(folder.file("s.h5"), {{0, 1, 0.2}});
  const StoredHistories none(folder.file("s.h5"));
  EXPECT_TRUE(none.names().empty());
  EXPECT_TRUE(none.runs().empty());
  EXPECT_THAT(error_text([&] { none.history("tilt", 0); }), HasSubstr("study.keep.histories"));
}

}  // namespace
}  // namespace gurney::study
