#include "studies/loss/consequences.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/config/document.h"
#include "equipment/catalogue/catalogue.h"
#include "tests/support/cart_prices.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

const std::string kFile = kCartPrices + R"([[consequence]]
limit_state = "moved"
cost_ratio = 0.1
days = 1
injury = "none"
service = "check"
[[consequence]]
limit_state = "fell"
cost_ratio = { value = 0.5, assumption = "a guess", range = [0.1, 1], distribution = { kind = "lognormal", median = 0.4, beta = 0.5, low = 0.1, high = 1, assumption = "a guess" } }
days = 7
injury = "serious"
service = "lost"
[[consequence]]
limit_state = "moved"
items = ["cart"]
cost_ratio = 0.2
days = 2
injury = "minor"
service = "kept"
)";

Consequences read(const std::string& text) {
  config::Document document(text, "c.toml");
  return Consequences::read(document);
}

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kFile;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Consequences, TheLastThatFitsAnItemCounts) {
  const Consequences all = read(kFile);
  EXPECT_EQ(all.money(), "EUR (2025)");
  EXPECT_EQ(all.of("cart", 0)->cost_ratio.value, 0.2);
  EXPECT_EQ(all.of("bed", 0)->cost_ratio.value, 0.1);
  EXPECT_EQ(all.of("bed", 0)->service, Service::kCheck);
  EXPECT_EQ(all.price_of("bed"), nullptr);
}

TEST(Consequences, SamplesHaveTheDistributionAndItsMean) {
  const Consequences all = read(kFile);
  const equipment::StatedQuantity& ratio = all.of("cart", 1)->cost_ratio;
  double sum = 0, squares = 0;
  constexpr int kSamples = 4000;
  for (int i = 0; i < kSamples; ++i) {
    const double value = sampled(ratio, "fell", 1, static_cast<std::uint64_t>(i));
    EXPECT_GE(value, 0.1);
    EXPECT_LE(value, 1);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kSamples, sd = std::sqrt(squares / kSamples - mean * mean);
  EXPECT_NEAR(mean, mean_of(ratio), 4 * sd / std::sqrt(kSamples));  // 4 standard errors
  EXPECT_NE(mean_of(ratio), ratio.value);
  EXPECT_EQ(sampled(ratio, "fell", 1, 5), sampled(ratio, "fell", 1, 5));
}

TEST(Consequences, ErrorsHavePlaces) {
  const auto error = [](const std::string& from, const std::string& to) {
    return error_text([&] { read(changed(from, to)); });
  };
  EXPECT_THAT(error("\"EUR\"", "\"euros\""),
              HasSubstr("c.toml:2:12: currency = \"euros\": must be a code of three capitals"));
  EXPECT_THAT(error("price = 1000", "price = -5"),
              HasSubstr("c.toml:6:9: price[0].price = -5: must be a finite number > 0"));
  EXPECT_THAT(error("cost_ratio = 0.1", "cost_ratio = -0.1"),
              HasSubstr("c.toml:17:14: consequence[0].cost_ratio = -0.1: must be a finite number "
                        ">= 0"));
  EXPECT_THAT(error("\"lost\"", "\"gone\""), HasSubstr("kept"));
  EXPECT_THAT(error("limit_state = \"fell\"", "limit_state = \"felt\""),
              HasSubstr("did you mean 'fell'?"));
  EXPECT_THAT(error("items = [\"cart\"]", "items = [\"cars\"]"),
              HasSubstr("consequence[2].items[0] = \"cars\": has no price; did you mean 'cart'?"));
  EXPECT_THAT(error("days = 1", "dais = 1"), HasSubstr("did you mean 'days'?"));
  EXPECT_THAT(error("gurney-consequences/1", "gurney-hazard/1"),
              HasSubstr("the file is a hazard curve, not a list of consequences"));
}

TEST(Consequences, ThoseShippedHaveAPriceForEveryItemOfTheCatalogue) {
  const Consequences all = Consequences::read(usual_consequences());
  for (const std::string& item : equipment::catalogue_names(equipment::DataKind::kItem)) {
    ASSERT_NE(all.price_of(item), nullptr) << item;
    for (std::size_t state = 0; state < all.limit_states().size(); ++state) {
      const Consequence* const of = all.of(item, state);
      ASSERT_NE(of, nullptr) << item << ", " << all.limit_states()[state].name;
      EXPECT_LE(of->cost_ratio.high, 1);
    }
  }
}

}  // namespace
}  // namespace gurney::study
