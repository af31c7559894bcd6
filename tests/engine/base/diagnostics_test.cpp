#include "engine/base/diagnostics.h"

#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

TEST(Diagnostics, ReportAllErrorsByPlaceAndThenThoseWithoutOne) {
  Diagnostics errors;
  EXPECT_EQ(error_text([&] { errors.raise(); }), "(no error)");
  errors.add("of another file");
  errors.add(7, 1, "seventh line");
  errors.add(2, 9, "second line, later");
  errors.add(2, 3, "second line");
  errors.add(2, 9, "the same place");
  EXPECT_EQ(errors.count(), 5u);
  errors.sort();
  EXPECT_EQ(error_text([&] { errors.raise(); }),
            "second line\nsecond line, later\nthe same place\nseventh line\nof another file");
  EXPECT_EQ(error_text([&] { errors.raise(2, "and ", " more"); }),
            "second line\nsecond line, later\nand 3 more");
}

TEST(Diagnostics, HaveEachNewLineOnce) {
  Diagnostics errors;
  errors.add_new("one\ntwo");
  errors.add_new("two\nthree", " (variant 'a')");
  EXPECT_EQ(error_text([&] { errors.raise(); }), "one\ntwo\nthree (variant 'a')");
}

TEST(Diagnostics, OnlyCountThoseBeyondTheKept) {
  Diagnostics errors(2);
  for (const char* each : {"a", "b", "c", "d"}) errors.add(each);
  EXPECT_EQ(errors.count(), 4u);
  EXPECT_EQ(error_text([&] { errors.raise(2, "and ", " of the kind"); }),
            "a\nb\nand 2 of the kind");
}

}  // namespace
}  // namespace gurney
