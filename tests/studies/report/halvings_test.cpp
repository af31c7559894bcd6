#include <gtest/gtest.h>

#include <limits>

#include "studies/report/narrative.h"

namespace gurney::report {
namespace {

std::string text_of(long halvings, double change) {
  Response response;
  response.items.emplace_back();
  response.quality.step_halvings = halvings;
  response.quality.peak_change = change;
  return narrative_of_trust(response, {"cart"});
}

TEST(Halvings, SayWhetherTheDemandsSettled) {
  EXPECT_EQ(text_of(0, 0), "");
  EXPECT_EQ(text_of(3, 0.0037),
            "Time step: halved 3 times; the last two changed no judged demand by more than 0.37 "
            "%.\n");
  EXPECT_EQ(text_of(6, std::numeric_limits<double>::infinity()),
            "Time step: halved 6 times, no shorter is tried; the last two changed an outcome.\n");
}

}  // namespace
}  // namespace gurney::report
