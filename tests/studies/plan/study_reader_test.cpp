#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/plan/study.h"
#include "tests/studies/small_study.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

/// What is reported of a job whose table [study] is in line 10.
std::string errors(const std::string& study) {
  return error_text([&] { StudyJob(small_job(study), "a.toml"); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(StudyReader, AnEmptyTableIsOneRunWithEveryNumberAtItsValue) {
  const SmallStudy small(small_job(""));
  const Study& study = small.job.study();
  EXPECT_EQ(study.angles, std::vector<double>{0});
  EXPECT_EQ(study.intensity.levels, std::vector<double>{1});
  EXPECT_EQ(study.draws, 0);
  EXPECT_EQ(study.measures.size(), 7u);
  EXPECT_EQ(small.plan.tasks(), 1u);
  EXPECT_FALSE(small.plan.draw({}));
}

TEST(StudyReader, ReadsTheKeysOfEarlierVersionsWithANote) {
  const std::string levels = "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\n",
                    steps = "first = 0.1\nincrement = 0.2\nuntil = \"overturned\"\n";
  const StudyJob job(small_job("step_check = 0.1\n" + levels + "[study.intensity.ida]\n" + steps),
                     "a.toml");
  EXPECT_THAT(job.notes(), testing::IsEmpty());
  const StudyJob old(small_job("certificate = 0.1\n" + levels + "[study.intensity.hunt]\n" + steps),
                     "a.toml");
  EXPECT_EQ(old.study().step_check, job.study().step_check);
  EXPECT_EQ(old.study().intensity.kind, IntensityPlan::Kind::kIda);
  EXPECT_THAT(old.notes(),
              testing::ElementsAre("a.toml:11:1: study.certificate: the key is now called "
                                   "step_check; the old name is still read",
                                   "a.toml:15:18: study.intensity.hunt: the key is now called ida; "
                                   "the old name is still read"));
  EXPECT_EQ(
      errors("step_check = 1\ncertificate = 1\n"),
      "a.toml:12:1: study.certificate: unknown key; known: angles_deg, combinations, draws, "
      "factor, hazard, intensity, keep, limit_state, measures, performance, replicas, sampling, "
      "seed, step_check, synthetic_records");
}

TEST(StudyReader, ReplicasAreCountedAndNotOfASaltelliDesign) {
  EXPECT_EQ(SmallStudy(small_job("replicas = 7\n")).job.study().replicas, 7);
  EXPECT_EQ(SmallStudy(small_job("")).job.study().replicas, 1);
  EXPECT_EQ(errors("replicas = 0\n"),
            "a.toml:11:12: study.replicas = 0: must be a whole number in 1..10000");
  EXPECT_EQ(
      errors("draws = 4\nsampling = \"saltelli\"\nreplicas = 2\n"),
      "a.toml:13:12: study.replicas: must not go with sampling = \"saltelli\", whose rows are "
      "compared one by one");
}

TEST(StudyReader, NamesUnknownKeysAndWrongTypesTogether) {
  EXPECT_EQ(errors(R"(drawz = 3
draws = 0
seed = -1
step_check = 1.5
sampling = "latin"
[study.intensity]
levels_g = [0.1]
[study.keep]
histories = "some"
evnts = true
)"),
            "a.toml:11:1: study.drawz: unknown key; did you mean 'draws'?\n"
            "a.toml:12:9: study.draws = 0: must be a whole number in 1..2147483647\n"
            "a.toml:13:8: study.seed = -1: must be a whole number in 0..2147483647\n"
            "a.toml:14:14: study.step_check = 1.5: must be a finite number >= 0 and <= 1\n"
            "a.toml:15:12: study.sampling = \"latin\": must be one of monte-carlo, "
            "latin-hypercube, sobol, saltelli; did you mean 'latin-hypercube'?\n"
            "a.toml:17:1: study.intensity.levels_g: unknown key; did you mean 'levels'?\n"
            "a.toml:19:13: study.keep.histories = \"some\": must be one of none, failed, "
            "overturned, all; did you mean 'none'?\n"
            "a.toml:20:1: study.keep.evnts: unknown key; did you mean 'events'?");
}

TEST(StudyReader, MoreStagesNeedLevelsAndALimitState) {
  const std::string stripes =
      "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\nlevels = [1]\nadaptive = ";
  EXPECT_EQ(errors(stripes + "{ stages = 0, limit_state = \"movd\" }\n"),
            "a.toml:15:23: study.intensity.adaptive.stages = 0: must be a whole number in 1..100\n"
            "a.toml:15:40: study.intensity.adaptive.limit_state = \"movd\": must be one of moved, "
            "rolled, hit, overturned; did you mean 'moved'?");
  EXPECT_EQ(
      errors("[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\nadaptive = { stages = 1, "
             "limit_state = \"hit\" }\nhunt = { first = 0.1, increment = 0.1, until = "
             "\"hit\" }\n"),
      "a.toml:14:12: study.intensity.adaptive: must not be combined with an IDA, which finds its "
      "own levels");
  EXPECT_EQ(errors("[study.intensity]\nscales = [1]\nadaptive = { stages = 1, limit_state = "
                   "\"hit\" }\n"),
            "a.toml:11:1: study.intensity.measure: missing; needed for adaptive");
}

TEST(StudyReader, LevelsAndScalesMustGoUp) {
  EXPECT_EQ(
      errors("[study.intensity]\nscales = [1, 2, 2]\n"),
      "a.toml:12:10: study.intensity.scales[2] = 2: must be more than the value before it, 2");
  EXPECT_EQ(errors("[study.intensity]\nscales = []\n"),
            "a.toml:12:10: study.intensity.scales = []: must have 1 or more values");
  EXPECT_EQ(errors("[study.intensity]\nscales = [0, 1]\n"),
            "a.toml:12:11: study.intensity.scales[0] = 0: must be a finite number > 0");
  const std::string levels = "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\n";
  EXPECT_EQ(errors(levels + "levels = [0.3, 0.1]\n"),
            "a.toml:14:10: study.intensity.levels[1] = 0.1: must be more than the value before "
            "it, 0.3");
  EXPECT_EQ(errors(levels + "levels = []\n"),
            "a.toml:14:10: study.intensity.levels = []: must have 1 or more values");
  EXPECT_EQ(errors(levels),
            "a.toml:11:1: study.intensity.levels: must be given, or a table ida, not both");
  EXPECT_EQ(errors(levels + "levels = [1]\nscales = [1]\n"),
            "a.toml:15:10: study.intensity.scales: must go without a measure, which has levels or "
            "an IDA");
  EXPECT_EQ(
      errors(levels + "levels = [1]\nhunt = { first = 0.1, increment = 0.1, until = \"hit\" }\n"),
      "a.toml:14:10: study.intensity.levels: must be given, or a table ida, not both");
}

TEST(StudyReader, KnowsTheMeasuresAndTheirUnits) {
  EXPECT_EQ(
      errors("[study.intensity]\nmeasure = \"PGB\"\nunit = \"g\"\nlevels = [1]\n").substr(0, 51),
      "a.toml:12:11: study.intensity.measure: measure 'PGB");
  EXPECT_EQ(errors("[study.intensity]\nmeasure = \"PGV\"\nunit = \"g\"\nlevels = [1]\n"),
            "a.toml:13:8: study.intensity.unit = \"g\": must be one of m/s, cm/s");
  EXPECT_EQ(errors("[study.intensity]\nmeasure = \"D5-95\"\nlevels = [1]\n"),
            "a.toml:12:11: study.intensity.measure: a record cannot be scaled to a measure in s");
  EXPECT_EQ(errors("measures = [\"PGA\", \"Sa(1.0) RotD50\", \"Sa(1.0) resultant\"]\n"),
            "a.toml:11:12: study.measures = \"Sa(1.0) resultant\": Sa(1) has no resultant; PGA, "
            "PGV and PGD have");
  EXPECT_EQ(errors("measures = [\"PGA\", \"PGV\", \"PGA geomean\"]\n"),
            "a.toml:11:12: study.measures: PGA geomean is there twice");
}

TEST(StudyReader, AnIdaNeedsItsSteps) {
  const std::string ida =
      "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\n[study.intensity.ida]\n";
  EXPECT_EQ(
      errors(ida +
             "first = 0\nincrement = -1\nmost_runs = 2\nresolution = 0\nuntil = \"fallen\"\n"),
      "a.toml:15:9: study.intensity.ida.first = 0: must be a finite number > 0\n"
      "a.toml:16:13: study.intensity.ida.increment = -1: must be a finite number > 0\n"
      "a.toml:17:13: study.intensity.ida.most_runs = 2: must be a whole number in "
      "3..1000\n"
      "a.toml:18:14: study.intensity.ida.resolution = 0: must be a finite number > 0 and "
      "<= 10\n"
      "a.toml:19:9: study.intensity.ida.until = \"fallen\": must be one of moved, rolled, "
      "hit, overturned");
  const StudyJob job(small_job(ida + "first = 0.1\nincrement = 0.2\nuntil = \"overturned\"\n"),
                     "a.toml");
  const IntensityPlan& plan = job.study().intensity;
  EXPECT_EQ(plan.kind, IntensityPlan::Kind::kIda);
  EXPECT_DOUBLE_EQ(plan.increment, 0.2 * 9.80665);
  EXPECT_EQ(plan.most_runs, 12);
  EXPECT_EQ(job.study().limit_states[plan.until].name, "overturned");
}

TEST(StudyReader, FactorsNeedLevelsWithNamesThatDiffer) {
  EXPECT_EQ(errors("[[study.factor]]\nname = \"brakes\"\n"),
            "a.toml:11:1: study.factor[0].level: must be given, tables [study.factor.level.NAME], "
            "or key and values");
  EXPECT_EQ(errors("[[study.factor]]\nkey = \"item.brakes\"\nvalues = []\n"),
            "a.toml:13:10: study.factor[0].values = []: must be an array of 1 or more values");
  EXPECT_EQ(errors("[[study.factor]]\nkey = \"item.brakes\"\nvalues = [true, true]\n"),
            "a.toml:13:10: study.factor[0].values: two levels are named 'true'");
  EXPECT_EQ(errors("[[study.factor]]\nvalues = [true]\n"),
            "a.toml:11:1: study.factor[0].key: missing; must be text in quotes");
  EXPECT_EQ(errors("[[study.factor]]\nkey = \"\"\nvalues = [true]\n"),
            "a.toml:12:7: study.factor[0].key = \"\": must name a key of the job");
  EXPECT_EQ(errors("[[study.factor]]\nlevel = { a = 3 }\n"),
            "a.toml:12:9: study.factor[0].level.a = 3: must be a table");
  EXPECT_EQ(errors("[[study.factor]]\nname = \"a\"\nkey = \"item.brakes\"\nvalues = [true]\n"
                   "[[study.factor]]\nname = \"a\"\nkey = \"item.yaw_deg\"\nvalues = [1]\n"),
            "a.toml:16:8: study.factor[1].name = \"a\": two factors have this name");
}

TEST(StudyReader, EachFactorHasKeysOfItsOwnAndLevelsThatDiffer) {
  const auto factor = [](const std::string& key, const std::string& values) {
    return "[[study.factor]]\nkey = \"" + key + "\"\nvalues = " + values + "\n";
  };
  const std::string brakes = factor("item.brakes", "[true, false]");
  const std::string rule =
      "as the factor 'factor 1' does; must not set a key of another factor, or "
      "a part of it";
  EXPECT_EQ(errors(brakes + brakes),
            "a.toml:15:7: study.factor[1].key: sets 'item.brakes', " + rule);
  for (const std::string other : {"item.mass_kg.value", "item.mass_kg", "*.mass_kg"})
    EXPECT_EQ(errors(factor("item.mass_kg", "[8, 9]") + factor(other, "[8, 9]")).substr(0, 70),
              ("a.toml:15:7: study.factor[1].key: sets '" + other + "', " + rule).substr(0, 70));
  EXPECT_EQ(errors(factor("settings.duration_s", "[0.1, 0.2]") +
                   "[[study.factor]]\n[study.factor.level.a]\nsettings.time_step_s = 0.002\n"
                   "[study.factor.level.b]\nsettings.duration_s = 0.3\n"),
            "a.toml:15:1: study.factor[1].level: sets 'settings.duration_s', " + rule);
  EXPECT_EQ(errors(brakes + factor("item.yaw_deg", "[0, 1]")), "(no error)");
  EXPECT_EQ(errors("[[study.factor]]\n[study.factor.level.a]\nitem.brakes = true\n"
                   "[study.factor.level.b]\nitem.brakes = true\n"),
            "a.toml:12:1: study.factor[0].level: the levels 'a' and 'b' are the same");
  EXPECT_EQ(errors(factor("study.draws", "[1, 3]")),
            "a.toml:13:10: study.factor[0].values: sets study.draws, which is of the whole study");
  EXPECT_EQ(
      errors(factor("title", "[\"a\"]")),
      "a.toml:13:10: study.factor[0].values: sets the title, which changes no run; a level has a "
      "name of its own");
}

TEST(StudyReader, AnAngleStandsOnce) {
  EXPECT_EQ(
      errors("angles_deg = [0, 30, 360, -330.0]\n"),
      "a.toml:11:22: study.angles_deg[2] = 360: is the direction of angles_deg[0] = 0 again\n"
      "a.toml:11:27: study.angles_deg[3] = -330: is the direction of angles_deg[1] = 30 again");
  EXPECT_EQ(errors("angles_deg = [0.1, 0.1000001, 359.9]\n"), "(no error)");
}

TEST(StudyReader, LevelsOfAWrongTypeAreReportedOnce) {
  EXPECT_EQ(errors("[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\nlevels = \"0.1\"\n"),
            "a.toml:14:10: study.intensity.levels = \"0.1\": must be an array of numbers");
  EXPECT_EQ(error_text([] { StudyJob(replaced(small_job(""), "[study]", "[[study]]"), "a.toml"); }),
            "a.toml:10:1: study = [a table]: must be a table [study]");
}

TEST(StudyReader, AHazardIsReadInItsUnitAndReportedOnce) {
  const std::string head =
      "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\nlevels = [0.1]\n"
      "[study.hazard]\n";
  EXPECT_EQ(
      errors(head + "im = [0.2, 0.1]\nrate_per_year = [0.1, 0.2]\n"),
      "a.toml:16:12: study.hazard.im[1] = 0.1: must be more than the value before it, 0.2\n"
      "a.toml:17:23: study.hazard.rate_per_year[1] = 0.2: must be less than the value before it, "
      "0.1");
  EXPECT_EQ(errors(head + "im = [0.1, 0.2]\nrate_per_year = [0.1]\n"),
            "a.toml:17:17: study.hazard.rate_per_year = [0.1]: must be an array of 2 numbers");
  EXPECT_EQ(errors(head + "im = [0.1]\nrate_per_year = [0.1]\n"),
            "a.toml:16:6: study.hazard.im: must have 2 or more values");
}

TEST(StudyReader, FactorsAreColumnsOfTheResults) {
  const std::string factor = "[[study.factor]]\nkey = \"item.brakes\"\nvalues = [true]\n";
  for (const std::string bad : {"name", "row", "a/b", ".", ""})
    EXPECT_EQ(errors(factor + "name = \"" + bad + "\"\n"),
              "a.toml:14:8: study.factor[0].name = \"" + bad +
                  "\": names a column of the results: must not be empty, '.', 'name' or 'row', or "
                  "have a '/'");
}

TEST(StudyReader, RefusesWhatContradictsTheRestOfTheJob) {
  const std::string levels = "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\nlevels = [0.1]\n";
  const auto with = [&](const std::string& record, const std::string& study) {
    const std::string job = replaced(small_job(study), "[settings]", record + "\n[settings]");
    return error_text([&] { StudyJob(job, "a.toml"); });
  };
  const std::string scale_to =
      "scale_to = { measure = \"PGA\", value = 0.2, unit = \"g\" }\nangle_deg = 10";
  EXPECT_EQ(with(scale_to, "angles_deg = [0, 90]\n" + levels),
            "a.toml:5:1: scale_to must not go with study.intensity, which scales the records\n"
            "a.toml:5:1: angle_deg must not go with study.angles_deg");
  EXPECT_EQ(with(scale_to, ""), "(no error)");
  EXPECT_EQ(
      with("scale = 2", levels),
      "a.toml:7:9: excitation.record.scale = 2: has no effect with levels of a measure, to which "
      "study.intensity scales the records");
  EXPECT_EQ(with("scale = 1", levels), "(no error)");
  EXPECT_EQ(with("scale = 2", "[study.intensity]\nscales = [1, 2]\n"), "(no error)");
  const auto output = [&](const std::string& histories, const std::string& study) {
    return with("[output]\nhistories = " + histories, study);
  };
  EXPECT_EQ(output("true", ""),
            "a.toml:8:13: output.histories: has no effect in a study, which keeps "
            "those of study.keep.histories");
  EXPECT_EQ(
      output("false", "keep.histories = \"all\"\n"),
      "a.toml:8:13: output.histories = false: must not go with study.keep.histories, which asks "
      "for them");
  EXPECT_EQ(output("true", "keep.histories = \"all\"\n"), "(no error)");
  EXPECT_EQ(
      errors("[[study.limit_state]]\nname = \"x\"\nevent = \"overturned\"\nat_least = 2\n"),
      "a.toml:11:1: study.limit_state[0]: at_least = 2: must be at most 1, the items and contents "
      "of the job");
  EXPECT_EQ(errors("angles_deg = []\n"),
            "a.toml:11:14: study.angles_deg = []: must have 1 or more values");
  EXPECT_EQ(errors("sampling = \"latin-hypercube\"\n"),
            "a.toml:11:12: study.sampling: must go with draws");
  EXPECT_EQ(errors("draws = 3\nsampling = \"saltelli\"\n[study.intensity]\nmeasure = \"PGA\"\nunit "
                   "= \"g\"\nhunt = { first = 0.1, increment = 0.1, until = \"hit\" }\n"),
            "a.toml:12:12: study.sampling = \"saltelli\": must not go with intensity.ida, whose "
            "intensities differ from draw to draw; state levels");
  EXPECT_EQ(errors("draws = 3\n[uncertainty]\ndraw = 1\n"),
            "a.toml:12:2: uncertainty: must not go with [study], which has draws and a seed of its "
            "own");
  EXPECT_EQ(errors("synthetic_records = 3\n"),
            "a.toml:5:1: study.synthetic_records needs a synthetic motion that has a seed");
  EXPECT_EQ(error_text([&] {
              StudyJob(small_job("synthetic_records = 3\n", "kind = \"ac156\", seed = 7"),
                       "a.toml");
            }),
            "a.toml:5:1: study.synthetic_records gives the seeds 1, 2, ...; leave the seed out");
  std::string calm = small_job("angles_deg = [0, 90]\n");
  calm = calm.erase(calm.find("[excitation"), calm.find("[settings]") - calm.find("[excitation"));
  EXPECT_EQ(error_text([&] { StudyJob(calm, "a.toml"); }),
            "a.toml:1:1: a study of intensities or angles needs [excitation.record]");
}

TEST(StudyReader, ASuiteMustHaveRecords) {
  std::string job = small_job("");
  job = replaced(job, "synthetic = { kind = \"ricker\", period_s = 0.1 }", "suite = []");
  const std::string text = error_text([&] { SmallStudy{job}; });
  EXPECT_NE(text, "(no error)");
  EXPECT_NE(text.find("a.toml:"), std::string::npos) << text;
}

TEST(StudyReader, AJobMustHaveATableStudy) {
  EXPECT_EQ(error_text([] { StudyJob("schema = \"gurney-job/1\"\n", "a.toml"); }),
            "a.toml: the job has no table [study]");
}

}  // namespace
}  // namespace gurney::study
