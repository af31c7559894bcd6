#include "equipment/catalogue/quantity.h"

#include <gtest/gtest.h>

#include "equipment/catalogue/uncertainty.h"
#include "tests/support/error_text.h"

namespace gurney::equipment {
namespace {

using config::Document;
using config::Range;

std::string errors(const std::string& text, bool vector = false) {
  return error_text([&] {
    Document document(text, "a.toml");
    Quantities in(document.root());
    if (vector)
      in.vector("x", Range::positive());
    else
      in.number("x", Range::positive());
    document.finish();
  });
}

TEST(Quantity, ReadsTheFormsAndKeepsTheAssumptions) {
  Document document(R"(
a_mm = 34
b_mm = { value = 34, source = "a paper" }
[part]
c_mm = { value = 34, assumption = "a guess", range = [30, 84] }
v_mm = { value = [1, 2, 3], assumption = "another", low = [1, 1, 3], high = [1, 4, 3] }
type = { value = "R100", assumption = "likely" }
)",
                    "a.toml");
  std::vector<Assumption> assumptions;
  SampleErrors errors;
  Sampler as_stated(assumptions, errors);
  Quantities root(document.root());
  EXPECT_EQ(as_stated(root.length_mm("a_mm", Range::positive())), 0.034);
  EXPECT_EQ(as_stated(root.length_mm("b_mm", Range::positive())), 0.034);
  EXPECT_EQ(as_stated(root.length_mm("absent_mm", Range::positive(), 5.0)), 0.005);
  EXPECT_TRUE(assumptions.empty());
  Quantities part(*document.root().table("part"));
  EXPECT_EQ(as_stated(part.length_mm("c_mm", Range::positive())), 0.034);
  EXPECT_EQ(as_stated(part.vector_mm("v_mm", Range::positive())), Vector3(0.001, 0.002, 0.003));
  const StatedText type = part.text("type");
  as_stated.note(type.choice);
  EXPECT_EQ(type.text, "R100");
  document.finish();
  ASSERT_EQ(assumptions.size(), 3u);
  EXPECT_EQ(assumptions[0].key, "part.c_mm");
  EXPECT_EQ(assumptions[0].value, 34);
  EXPECT_EQ(assumptions[0].low, 30);
  EXPECT_EQ(assumptions[0].high, 84);
  EXPECT_EQ(assumptions[0].reason, "a guess");
  EXPECT_EQ(assumptions[0].file, "a.toml");
  EXPECT_EQ(assumptions[1].key, "part.v_mm.y");  // the others cannot differ from their value
  EXPECT_EQ(assumptions[1].high, 4);
  EXPECT_EQ(assumptions[2].choice, "R100");
}

TEST(Quantity, SaysWhatIsWrong) {
  EXPECT_EQ(errors("x = -1"), "a.toml:1:5: x = -1: must be a finite number > 0");
  EXPECT_EQ(errors("x = { value = 0, source = 's' }"),
            "a.toml:1:15: x.value = 0: must be a finite number > 0");
  EXPECT_EQ(errors("x = { value = 1 }"),
            "a.toml:1:5: x: must have a source, an assumption with its range, or both");
  EXPECT_EQ(errors("x = { value = 1, assumption = 'a' }"),
            "a.toml:1:5: x.range: missing; must be an array of 2 numbers");
  EXPECT_EQ(errors("x = { value = 1, assumption = 'a', range = [2, 3] }"),
            "a.toml:1:44: x.range = [2, 3]: must be [low, high] with low < high around 1");
  EXPECT_EQ(errors("x = { value = 1, assumption = 'a', range = [0.1, 0.5] }"),
            "a.toml:1:44: x.range = [0.1, 0.5]: must be [low, high] with low < high around 1");
  EXPECT_EQ(errors("x = { value = 1, sauce = 's' }"),
            "a.toml:1:5: x: must have a source, an assumption with its range, or both\n"
            "a.toml:1:18: x.sauce: unknown key; did you mean 'source'?");
  EXPECT_EQ(
      errors("x = { value = [1,1,1], assumption = 'a', low = [1,1,1], high = [1,1,0.5] }", true),
      "a.toml:1:48: x.low: low <= value <= high must hold for each number, and low < high "
      "for one");
}

TEST(Assumptions, AreListedOnce) {
  std::vector<Assumption> list;
  Assumption one;
  one.key = std::string("trail_mm");
  one.file = std::string("a.toml");
  Assumption other = one;
  other.file = std::string("b.toml");
  add_assumptions(list, {one, one, other});
  add_assumptions(list, {one});
  EXPECT_EQ(list.size(), 2u);
}

}  // namespace
}  // namespace gurney::equipment
