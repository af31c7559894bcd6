#include "studies/explanation/explain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "studies/explanation/events.h"
#include "studies/explanation/overturning.h"
#include "studies/explanation/words.h"
#include "studies/figures/explanation_figure.h"
#include "studies/render/render.h"
#include "studies/report/explanation_report.h"
#include "studies/report/run_report.h"
#include "studies/verification/scenes/blocks.h"

namespace gurney::explanation {
namespace {

constexpr double kPi = std::numbers::pi, kStep = 0.004, kMass = 100, kMu = 0.3;
constexpr double kBegins = 1, kLasts = 0.5;  // of the half sine [s]

/// A half sine of the floor along +x, then at rest.
FloorMotion half_sine(double peak) {
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 1501);
  for (int i = 500; i <= 750; ++i)
    motion(0, i) = peak * std::sin(kPi * (i * 0.002 - kBegins) / kLasts);
  return {0.002, motion};
}

study::RunFacts facts_of(const Scene& scene, const FloorMotion& floor) {
  study::RunFacts facts;
  facts.title = "a block";
  facts.scene = scene;
  facts.floor = floor;
  facts.settings = RunOptions{blocks::run_for(3, kStep, kStep)};
  if (!floor.at_rest()) facts.record = study::RecordFacts{};
  if (facts.record) facts.record->name = "half sine";
  return facts;
}

ContactConstants floor_of(double friction) {
  ContactConstants constants;
  constants.friction = friction;
  // While it sticks, the block follows the floor with the elastic speed of four corners, at most
  // 2 m A pi / (4 k T) = 0.2 mm/s: below the 1 mm/s that count as motion.
  constants.stiffness = 1e7;
  return constants;
}

/// How far a sample nearest to the peak of the sine may lie below it [-].
const double kOffPeak = std::pow(kPi * kStep / 2 / kLasts, 2) / 2;

study::RunFacts shaken_block(double peak) {
  return facts_of(blocks::block(kMass, {0.6, 0.6, 0.3}, floor_of(kMu)), half_sine(peak));
}

Explanation explained(const study::RunFacts& facts) {
  return explain(facts, simulate(facts.scene, facts.floor, facts.settings));
}

/// The text in one line, wherever lines were broken.
std::string one_line(const Explanation& of) {
  std::istringstream all(render::text(report::explanation_findings(of)));
  std::string line;
  for (std::string word; all >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

const Event* find(const Explanation& of, EventKind kind) {
  for (const Event& event : of.events)
    if (event.kind == kind) return &event;
  return nullptr;
}

TEST(Explain, FindsThePulseThatPushedABlock) {
  constexpr double kPeak = 6;
  const Explanation found = explained(shaken_block(kPeak));
  EXPECT_EQ(found.item().finding, Finding::kMoved);
  EXPECT_NEAR(found.resolution, kStep, 1e-9);
  // Friction is exceeded where a = mu g.
  const double ratio = kMu * kStandardGravity / kPeak;
  const double slips = kBegins + kLasts / kPi * std::asin(ratio);
  const ItemFacts& item = found.item();
  EXPECT_NEAR(item.grip.time_exceeded, slips, kStep) << "one sample after it";
  EXPECT_NEAR(item.grip.peak_demand, kMass * kPeak, kOffPeak * kMass * kPeak);
  EXPECT_NEAR(item.grip.grip, kMu * kMass * kStandardGravity, 1e-6);
  EXPECT_NEAR(item.grip.time, kBegins + kLasts / 2, kStep);
  // From there the relative acceleration grows with j = A pi / T cos: 1 mm/s is reached after
  // sqrt(2 v / j). The onset is the last sample before.
  const double jerk = kPeak * kPi / kLasts * std::sqrt(1 - ratio * ratio);
  const Event* const moved = find(found, EventKind::kMoved);
  ASSERT_NE(moved, nullptr);
  EXPECT_NEAR(moved->time, slips + std::sqrt(2e-3 / jerk), kStep);
  EXPECT_TRUE(moved->sampled);
  // The block lags behind the floor, towards -x; the pulse drove the floor towards +x.
  EXPECT_NEAR(found.direction.x(), -1, 1e-9);
  ASSERT_TRUE(found.pulse);
  EXPECT_NEAR(found.pulse->start, kBegins, 0.002);
  EXPECT_NEAR(found.pulse->end, kBegins + kLasts, 0.002);
  EXPECT_NEAR(found.pulse->peak_acceleration, kPeak, 1e-9);
  // 2 A T / pi; trapezoids miss (pi dt / T)^2 / 12 = 1.3e-5 of it.
  EXPECT_NEAR(found.pulse->velocity_change, 2 * kPeak * kLasts / kPi, 1e-4);
  EXPECT_NEAR(found.pulse->peak_velocity, 2 * kPeak * kLasts / kPi, 1e-4) << "it starts from rest";
}

TEST(Explain, NamesTheHalfCycleThatTheReportOfTheRunNames) {
  // A slender block falls in waves whose half cycles are 0.5 s long.
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 2501);
  for (int i = 500; i <= 2000; ++i)
    motion(0, i) = 3 * (i * 0.002 - kBegins) * std::sin(2 * kPi * (i * 0.002 - kBegins));
  study::RunFacts facts =
      facts_of(blocks::block(kMass, {0.4, 0.4, 2}, floor_of(0.8)), {0.002, motion});
  facts.settings.duration = 6;
  facts.settings.history_step = 0.02;
  const Response of_run = simulate(facts.scene, facts.floor, facts.settings);
  const Response again =
      simulate(facts.scene, facts.floor, finely_stored(facts.settings, facts.floor, 1));
  const auto fall = overturnings_of(facts, of_run), fall_again = overturnings_of(facts, again);
  ASSERT_EQ(fall.size(), 1u);
  ASSERT_GT(again.items[0].history.size(), 4 * of_run.items[0].history.size());
  ASSERT_LT(fall[0].start, fall[0].time);
  EXPECT_EQ(fall[0].start, fall_again[0].start) << "whatever the spacing of the histories";
  const Explanation found = explain(facts, again);
  ASSERT_TRUE(fall[0].half_cycle && found.pulse);
  EXPECT_EQ(found.pulse->start, fall[0].half_cycle->start);
  EXPECT_EQ(found.pulse->end, fall[0].half_cycle->end);
  const std::string words = sentence(*fall[0].half_cycle, {});
  EXPECT_NE(one_line(found).find(words), std::string::npos) << one_line(found);
  bool has_words = false;
  for (const std::string& line : findings::lines_of(report::narrative(facts, of_run)))
    has_words |= line.find(words) != std::string::npos;
  EXPECT_TRUE(has_words);
}

TEST(Explain, BalancesTheEnergyOfEachStage) {
  const Explanation found = explained(shaken_block(6));
  ASSERT_GE(found.stages.size(), 4u);
  EXPECT_EQ(found.stages.front().name, "start");
  EXPECT_EQ(found.stages.back().name, "end");
  for (const Stage& s : found.stages) {
    // What closes the balance of the engine: far below the work of the floor, tens of joules.
    const double stored = s.kinetic + s.potential + s.elastic;
    const double lost = s.friction + s.rolling + s.impacts + s.other_loss;
    EXPECT_NEAR(stored + lost, s.floor_work + s.other_work, 0.05) << s.name;
  }
  EXPECT_NEAR(found.stages.back().kinetic, 0, 1e-6);
}

TEST(Explain, SaysPlainlyThatNothingHappened) {
  constexpr double kPeak = 2;  // mu g = 2.9 m/s2
  const Explanation found = explained(shaken_block(kPeak));
  EXPECT_EQ(found.item().finding, Finding::kStill);
  EXPECT_LT(found.item().grip.time_exceeded, 0);
  EXPECT_NEAR(found.item().grip.demand, kMass * kPeak, kOffPeak * kMass * kPeak);
  EXPECT_EQ(find(found, EventKind::kMoved), nullptr);
  const std::string words = one_line(found);
  EXPECT_NE(words.find("block did nothing"), std::string::npos) << words;
  EXPECT_EQ(words.find("What drove it"), std::string::npos) << words;
  EXPECT_NE(words.find("200 N of 294 N"), std::string::npos) << words;
}

// A drawer in a block that hardly moves meets its stop: sqrt(2 a L) along the floor's constant acceleration.
TEST(Explain, APartMeetsItsStop) {
  Scene scene = blocks::block(100, {1, 1, 1}, {});
  scene.items[0].name = "cabinet";
  for (Guide& guide : scene.items[0].fixture.guides) guide.kind = Guide::Kind::kHeld;
  PlacedItem drawer = blocks::block(4, Vector3::Constant(0.2), {}).items[0];
  drawer.name = "cabinet/drawer";
  drawer.model.chassis_center_of_mass = drawer.model.shape[0].center = {0, 0, 0.5};
  scene.items.push_back(drawer);
  Joint slider;
  slider.kind = Joint::Kind::kSlider;
  slider.part = 1;
  slider.point = {0, 0, 0.5};
  slider.axis = Vector3::UnitX();
  slider.upper = 0.3;
  scene.joints = {slider};
  scene.pairs.push_back({"steel", "steel", {}});
  study::RunFacts facts;
  facts.job_name = "drawer";
  facts.scene = scene;
  facts.settings = RunOptions{blocks::run_for(0.8, 0.002, 0.01)};
  facts.floor = {2, (Eigen::Matrix3Xd(3, 2) << -2, -2, 0, 0, 0, 0).finished()};
  const Explanation found = explain(facts, simulate(facts.scene, facts.floor, facts.settings));
  const std::string words = one_line(found);
  EXPECT_NE(words.find("cabinet/drawer moved up to"), std::string::npos) << words;
  EXPECT_NE(words.find("and met its stop with 1.09"), std::string::npos)
      << words;  // sqrt(2 2 0.3) less what a step misses
  EXPECT_EQ(words.find("hit nothing"), std::string::npos) << words;
}

TEST(Explain, FindsAHitAtItsTime) {
  constexpr double kGap = 0.5, kSpeed = 1;
  Scene scene = blocks::block(kMass, {0.6, 0.6, 0.3}, floor_of(0));
  blocks::add_wall(scene, 0.3 + kGap, floor_of(0));
  scene.items[0].initial.velocity = {kSpeed, 0, 0};
  const Explanation found = explained(facts_of(scene, {}));
  EXPECT_EQ(found.item().finding, Finding::kHit);
  ASSERT_TRUE(found.hit);
  // The engine resolves impacts within a step.
  EXPECT_NEAR(found.worst_time, kGap / kSpeed, kStep);
  EXPECT_NEAR(found.hit->approach_speed, kSpeed, 1e-6);
  EXPECT_NEAR(found.direction.x(), 1, 1e-6);
  EXPECT_FALSE(found.pulse);
  EXPECT_NE(headline(found).find("hit wall with 1.00 m/s at 0.50 s"), std::string::npos)
      << headline(found);
  const std::string svg = figures::explanation_figure(found),
                    data = render::json(report::explanation_findings(found));
  EXPECT_NE(svg.find("hits wall with 1.00 m/s"), std::string::npos);
  EXPECT_NE(data.find("\"kind\": \"impact\""), std::string::npos);
}

TEST(Explain, ChoosesTheItemToWhichTheWorstHappened) {
  study::RunFacts facts = shaken_block(6);
  facts.scene.items[0].name = "light";
  PlacedItem second = facts.scene.items[0];
  second.name = "sticky";
  second.initial.position = {0, 3, 0};
  second.model.material = "rubber";
  facts.scene.items.insert(facts.scene.items.begin(), second);
  facts.scene.pairs.push_back({"rubber", "concrete", floor_of(0.9)});
  facts.scene.pairs.push_back({"rubber", "steel", floor_of(0.4)});
  const Explanation found = explained(facts);
  EXPECT_EQ(found.item().name, "light");
  EXPECT_EQ(found.items[0].finding, Finding::kStill);
  EXPECT_NE(one_line(found).find("sticky did nothing"), std::string::npos);
}

// A bag of 10 kg hangs in the middle of a block that slides: it swings by far more than the block moves.
TEST(Explain, TakesPartsAsOnesOfTheirItem) {
  study::RunFacts facts = shaken_block(6);
  facts.scene.items[0].name = "block";
  PlacedItem bag = facts.scene.items[0];
  bag.name = "block/bag";
  bag.model.chassis_mass = 10;
  bag.model.chassis_center_of_mass = {0, 0, 0.9};
  bag.model.chassis_inertia = 0.05 * Matrix3::Identity();
  bag.model.shape = {{{0, 0, 0.9}, {0.2, 0.2, 0.2}}};
  facts.scene.items.push_back(bag);
  facts.scene.pairs.push_back({bag.model.material, bag.model.material, floor_of(kMu)});
  Joint hook;
  hook.kind = Joint::Kind::kBall;
  hook.name = "bag";
  hook.part = 1;
  hook.point = {0, 0, 1.4};
  facts.scene.joints = {hook};
  const Explanation of = explained(facts);
  EXPECT_GT(of.items[1].peak_displacement, of.items[0].peak_displacement);
  EXPECT_EQ(of.subject, 0U);
  EXPECT_NEAR(of.items[0].mass, kMass + 10, 1e-9);
  EXPECT_NEAR(of.items[0].grip.peak_demand, 6 * (kMass + 10), 6 * (kMass + 10) * kOffPeak + 1e-9);
  EXPECT_FALSE(of.items[1].on_floor);
  EXPECT_EQ(of.items[1].tilt.ratio(), 0);
  for (const Event& event : of.events) EXPECT_NE(event.item, of.items[1].name);
}

TEST(Explain, HasNothingToSayOfARunThatFailed) {
  Response response;
  response.outcome = Outcome::kDiverged;
  response.cause = "no solution";
  const Explanation found = explain(shaken_block(6), response);
  EXPECT_TRUE(found.failed);
  EXPECT_NE(one_line(found).find("no solution"), std::string::npos);
  EXPECT_NE(render::json(report::explanation_findings(found)).find("\"finding\": null"),
            std::string::npos);
  EXPECT_NE(figures::explanation_figure(found).find("no solution"), std::string::npos);
}

TEST(FinelyStored, KeepsStepsUntilThereAreTooMany) {
  const RunOptions settings{blocks::run_for(100, 0.01, 1)};
  EXPECT_NEAR(finely_stored(settings, {}, 4).history_step, 0.01, 1e-12) << "40,000 samples";
  EXPECT_NEAR(finely_stored(settings, {}, 5).history_step, 0.02, 1e-12);
}

// --- what histories state

EquipmentModel box_on_casters() {
  EquipmentModel item;
  item.chassis_mass = 50;
  item.chassis_center_of_mass = {0, 0, 0.5};
  item.shape = {{{0, 0, 0.5}, {0.2, 0.4, 1.0}}};
  const char* const names[] = {"front left", "", "third", "rear right"};
  for (int i = 0; i < 4; ++i) {
    Caster caster;
    caster.name = names[i];
    caster.mount = {i < 2 ? 0.3 : -0.3, i % 2 == 0 ? 0.2 : -0.2, 0.131};
    item.casters.push_back(caster);
  }
  return item;
}

/// Samples 0.1 s apart; each text is of one caster: L lifted, S skids, . neither.
std::vector<Sample> samples_of(const std::vector<std::string>& casters) {
  std::vector<Sample> history(casters.front().size());
  for (std::size_t k = 0; k < history.size(); ++k) {
    history[k].time = 0.1 * static_cast<double>(k);
    for (std::size_t i = 0; i < casters.size(); ++i) {
      const char c = casters[i][k];
      history[k].wheels[i].mode = c == 'L'   ? WheelMode::kLifted
                                  : c == 'S' ? WheelMode::kSkids
                                             : WheelMode::kRolls;
    }
  }
  return history;
}

TEST(Lifts, GoFromTheFirstCasterUntilAllAreBack) {
  const auto lifts = lifts_of(box_on_casters(), samples_of({
                                                    "..LL....L",
                                                    ".........",
                                                    "...LL...L",
                                                    ".........",
                                                }));
  ASSERT_EQ(lifts.size(), 2u);
  EXPECT_NEAR(lifts[0].from, 0.2, 1e-12);
  EXPECT_NEAR(lifts[0].until, 0.5, 1e-12);
  EXPECT_TRUE(lifts[0].landed);
  EXPECT_EQ(lifts[0].casters, (std::vector<std::size_t>{0, 2}));
  EXPECT_NEAR(lifts[1].from, 0.8, 1e-12);
  EXPECT_FALSE(lifts[1].landed);
}

/// Casters that hop one after the other make one lift, in which none of them is off for long.
TEST(Lifts, DoNotMakeOneFlightOfSeparateHops) {
  const auto lifts = lifts_of(box_on_casters(), samples_of({
                                                    ".LL...LL.",
                                                    "..LLLL...",
                                                    "....LLL..",
                                                    "....L....",
                                                }));
  ASSERT_EQ(lifts.size(), 1u);
  EXPECT_NEAR(lifts[0].from, 0.1, 1e-12);
  EXPECT_NEAR(lifts[0].until, 0.8, 1e-12);
  EXPECT_EQ(lifts[0].casters, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(lifts[0].most, 3u);
  EXPECT_EQ(lifts[0].together, 0);
  EXPECT_NEAR(lifts[0].longest, 0.4, 1e-12);
  EXPECT_EQ(lifts[0].longest_caster, 1u);
}

TEST(Lifts, KnowHowLongAllCastersAreOff) {
  const auto lifts =
      lifts_of(box_on_casters(), samples_of({".LLLL.", "..LLL.", "..LL..", "..LLL."}));
  ASSERT_EQ(lifts.size(), 1u);
  EXPECT_EQ(lifts[0].most, 4u);
  EXPECT_NEAR(lifts[0].together, 0.2, 1e-12);
  EXPECT_NEAR(lifts[0].longest, 0.4, 1e-12);
}

/// The first, the last of what overturned, and the longest of the others, in their order.
TEST(Lifts, AreStatedByThrees) {
  const auto starts = [](const std::vector<double>& lengths, bool overturned) {
    std::vector<Lift> lifts;
    for (const double length : lengths) {
      const double from = 10 * static_cast<double>(lifts.size());
      lifts.push_back({from, from + length, true, {0}, 1, 0, length, 0});
    }
    std::vector<double> found;
    for (const Lift& lift : stated_lifts(lifts, overturned)) found.push_back(lift.from);
    return found;
  };
  using Times = std::vector<double>;
  EXPECT_EQ(starts({}, true), Times{});
  EXPECT_EQ(starts({1, 2, 3}, true), (Times{0, 10, 20}));
  EXPECT_EQ(starts({1, 2, 5, 3, 4}, true), (Times{0, 20, 40}));
  EXPECT_EQ(starts({1, 2, 3, 4, 5}, true), (Times{0, 30, 40})) << "the last is the longest";
  EXPECT_EQ(starts({5, 1, 2, 3, 4}, false), (Times{0, 30, 40}));
}

TEST(Words, OfALiftAreThoseOfItsCasters) {
  const Uplift hops{4, 3, 0, 0.3, "front right"}, flight{4, 4, 0.04, 0.3, "front right"},
      one{1, 1, 0.25, 0.25, "front left"};
  const auto words = [](double until, const std::string& part, const Uplift& uplift) {
    return sentence(Event{1, EventKind::kLiftOff, "cart", part, until, true, uplift}, {});
  };
  EXPECT_EQ(words(1.8, "a, b, c and d", hops),
            "one or more casters off the floor until 1.800 s, up to 3 at once; a single caster for "
            "0.3 s at most (front right): a, b, c and d");
  EXPECT_EQ(words(1.8, "a, b, c and d", flight),
            "one or more casters off the floor until 1.800 s, up to 4 at once, all 4 for 0.04 s; a "
            "single caster for 0.3 s at most (front right): a, b, c and d");
  EXPECT_EQ(words(1.25, "front left", one), "off the floor for 0.25 s: front left");
  EXPECT_EQ(words(std::nan(""), "front left", one),
            "off the floor to the end of the run: front left");
  // Lifts after the overturning are not counted.
  const Uplift fall{2, 2, 0.04, 0.3, "front right", true};
  EXPECT_EQ(words(std::nan(""), "a and b", fall),
            "one or more casters off the floor until it overturned, up to 2 at once, all 2 for "
            "0.04 s; a single caster for 0.3 s at most (front right): a and b");
}

TEST(Words, OfItemsThatCarryAndThatOverturnAreTheirs) {
  Explanation of;
  of.record = "shake";
  of.items.resize(2);
  ItemFacts &cart = of.items[0], &pump = of.items[1];
  cart.name = "cart";
  cart.mass = 91;
  cart.grip.time_exceeded = 1;
  pump.name = "pump";
  pump.finding = Finding::kOverturned;
  pump.tilt.tilt = 0.91;
  pump.tilt.critical = 1;
  const auto text = [&] { return one_line(of); };
  EXPECT_NE(text().find("takes its mass (91 kg) times"), std::string::npos);
  cart.carries = true;
  EXPECT_NE(text().find("takes its mass (91 kg with all that it carries) times"),
            std::string::npos);
  EXPECT_NE(text().find("pump: overturned; moved up to 0.00 mm."), std::string::npos)
      << "a tilt until it overturned is no margin";
  pump.finding = Finding::kToppled;
  EXPECT_NE(text().find("pump: toppled; moved up to 0.00 mm."), std::string::npos);
}

TEST(Words, OfAShrinkingChangeDoNotSayThatItGrows) {
  Predictability of;
  of.time_of_peaks = 2;
  of.horizon = 2;
  const auto words = [&](double amplification) {
    of.amplification_at_peaks = amplification;
    return sentence(of);
  };
  EXPECT_EQ(words(0.46),
            "Predictable: a change of mass by one part in a billion shrinks to 0.46 of its size "
            "until the peaks of displacement and tilt at 2.00 s");
  EXPECT_NE(words(4.44).find("grows 4.4-fold until"), std::string::npos);
  EXPECT_NE(words(1234).find("grows 1234-fold until"), std::string::npos);
}

TEST(Skids, AreOfBrakedCasters) {
  EquipmentModel item = box_on_casters();
  const auto history = samples_of({".S...", "...S.", ".....", "....."});
  EXPECT_LT(first_skid(item, history).time, 0);
  item.casters[1].brake_torque = 10;
  EXPECT_NEAR(first_skid(item, history).time, 0.3, 1e-12);
  EXPECT_EQ(first_skid(item, history).caster, 1u);
}

TEST(CasterWords, NameThePlaceWhereTheNameDoesNot) {
  const EquipmentModel item = box_on_casters();
  EXPECT_EQ(caster_words(item, 0), "front left");
  EXPECT_EQ(caster_words(item, 1), "front right caster");
  EXPECT_EQ(caster_words(item, 2), "third (rear left)");
}

TEST(Tilt, IsCriticalWhereTheCentreOfMassIsAboveTheEdge) {
  const EquipmentModel item = blocks::block(10, {0.2, 0.4, 1}, floor_of(0.5)).items[0].model;
  Sample sample;
  for (const double side : {1.0, -1.0}) {
    // Leaning to the front or the rear, then to a side.
    sample.tilt = 5 * kRadiansPerDegree;
    sample.orientation = Eigen::AngleAxisd(side * sample.tilt, Vector3::UnitY());
    EXPECT_NEAR(critical_tilt(item, sample), std::atan(0.1 / 0.5), 1e-9);
    sample.orientation = Eigen::AngleAxisd(side * sample.tilt, Vector3::UnitX());
    EXPECT_NEAR(critical_tilt(item, sample), std::atan(0.2 / 0.5), 1e-9);
  }
  const TiltMargin margin = tilt_margin(item, {sample}, 1);
  EXPECT_NEAR(margin.ratio(), sample.tilt / std::atan(0.2 / 0.5), 1e-9);
  // Turned about -x its top goes towards +y, which is its left.
  EXPECT_NEAR(margin.direction, kPi / 2, 1e-9);
  EXPECT_LT(margin.time_passed, 0);
  EXPECT_EQ(tilt_margin(item, {sample}, -1).tilt, 0) << "it had overturned before";
  sample.tilt = 0;
  EXPECT_TRUE(std::isnan(critical_tilt(item, sample)));
}

TEST(Grip, IsThatOfBrakesAndOfRolling) {
  study::RunFacts facts = shaken_block(6);
  facts.scene.items[0].model = box_on_casters();
  EquipmentModel& item = facts.scene.items[0].model;
  const double mass = whole_item(item).mass;
  Sample sample;
  sample.time = kBegins + kLasts / 2;
  for (std::size_t i = 0; i < 4; ++i) {
    sample.wheels[i].normal_force = 100;
    item.casters[i].tread.static_friction = 0.6;
    item.casters[i].tread.rolling_friction_length = 1e-3;
    item.casters[i].wheel_radius = 0.05;
  }
  EXPECT_NEAR(grip_of(facts, 0, mass, sample).grip, 4 * 100 * 1e-3 / 0.05, 1e-9);
  EXPECT_NEAR(grip_of(facts, 0, mass, sample).demand, mass * 6, 1e-6);
  item.casters[0].brake_torque = 100;  // more than the tread: 60 N
  item.casters[1].brake_torque = 2;    // less: 40 N
  EXPECT_NEAR(grip_of(facts, 0, mass, sample).grip, 60 + 40 + 2 * 2, 1e-9);
  const GripMargin margin = grip_margin(facts, 0, mass, {sample}, 10);
  EXPECT_TRUE(margin.braked && margin.rolls);
  EXPECT_NEAR(margin.grip, 104, 1e-9);
}

}  // namespace
}  // namespace gurney::explanation
