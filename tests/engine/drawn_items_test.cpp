#include "tests/engine/drawn_items.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "engine/base/error.h"
#include "engine/energy_balance.h"

namespace gurney {
namespace {

struct Counts {
  int runs = 0, refused = 0, diverged = 0, untrusted = 0;
  int without_source = 0;  ///< runs that pass as results
  long most_steps = 0;
  double fastest = 0;  ///< approach over the largest speed that the item's energy allows
};

/// The largest gain of energy between two samples that nothing paid for, over the largest energy.
double made(const Response& response) {
  EnergyBalance balance(response.items[0].stored_energy_at_start);
  for (const Sample& sample : response.items[0].history) balance.observe(sample.energy);
  return balance.error();
}

void count(unsigned seed, Counts& counts) {
  const drawn::Run run = drawn::run(seed);
  Response response;
  try {
    response = simulate(run.scene, run.floor, run.settings);
  } catch (const Error& error) {
    ++counts.refused;  // its centre of mass is outside its casters
    return;
  }
  ++counts.runs;
  counts.diverged += response.outcome == Outcome::kDiverged;
  counts.most_steps = std::max(counts.most_steps, response.quality.steps);
  // A verdict rests on samples each 0.1 s, this one on each 0.02 s: it may see a peak between.
  const double error = response.outcome == Outcome::kDiverged ? 0 : made(response);
  counts.untrusted += response.outcome == Outcome::kUntrusted;
  if (response.outcome != Outcome::kUntrusted && error > 2 * EnergyBalance::kTrusted) {
    ++counts.without_source;
    ADD_FAILURE() << "seed " << seed << ": " << name_of(response.outcome) << " with an error of "
                  << error;
  }
  if (std::getenv("GURNEY_DRAWN_PRINT") != nullptr)
    fmt::print("{} {} {:.3g} {:.3g} {:.3g} {} {:.3g}\n", seed, name_of(response.outcome), error,
               response.quality.energy_closure, response.quality.numerical_loss,
               response.quality.steps, response.items[0].demands.largest_approach_speed);
}

Counts counts_of(unsigned first, unsigned number) {
  Counts counts;
  for (unsigned seed = first; seed < first + number; ++seed) count(seed, counts);
  return counts;
}

// No energy without a source, or an outcome that says so. Of 734 drawn items 2 were untrusted:
// with that share more than 3 of 60 come in fewer than one of 10,000 draws.
TEST(DrawnItems, MakeNoEnergyOrAreUntrusted) {
  const Counts counts = counts_of(1000, 60);
  EXPECT_GT(counts.runs, 30);
  EXPECT_EQ(counts.diverged, 0);
  EXPECT_EQ(counts.without_source, 0);
  EXPECT_LE(counts.untrusted, 3);
}

// engine_test --gtest_also_run_disabled_tests --gtest_filter='*DrawnItems*'; takes minutes.
TEST(DrawnItems, DISABLED_Thousands) {
  const char* number = std::getenv("GURNEY_DRAWN_ITEMS");
  const Counts counts = counts_of(1000, number != nullptr ? std::atoi(number) : 2000);
  fmt::print(
      "{} runs, {} refused, {} diverged, {} untrusted, {} without a source, {} steps at most\n",
      counts.runs, counts.refused, counts.diverged, counts.untrusted, counts.without_source,
      counts.most_steps);
}

}  // namespace
}  // namespace gurney
