#include "groundmotions/assembly/file_names.h"

#include <gtest/gtest.h>

namespace gurney::groundmotions {
namespace {

// A vertical is a word that can be nothing else, or one that begins or ends the name; a V also begins the names of
// versions and stations.
TEST(VerticalMark, IsAWordOfTheName) {
  for (const char* name : {"X_UP.txt", "X.UD", "X_Z.acc", "UP.txt", "Z_first.txt", "a_UD_first.txt",
                           "a_VERT_b.txt", "park_V.txt", "a_Z_acc.txt"})
    EXPECT_TRUE(vertical_mark(name)) << name;
  for (const char* name : {"a_Z_first.txt", "V_first.txt", "first.txt", "vertical_park_NS.txt",
                           "lazy.txt", "X_E.txt", "U.txt"})
    EXPECT_FALSE(vertical_mark(name)) << name;
  EXPECT_EQ(vertical_mark("Z_first.txt")->pattern, "*first.txt");
}

TEST(MatchNames, JoinsTwoHorizontalsAndAVertical) {
  const auto marks_of = [](const std::vector<NamedFile>& files) {
    std::string all;
    for (const auto& mark : match_names(files).marks) all += (mark ? mark->text : "-") + " ";
    return all;
  };
  const auto file = [](const char* name, double time_step = 0.01, Eigen::Index samples = 1000) {
    return NamedFile{name, "", time_step, samples};
  };
  EXPECT_EQ(marks_of({file("s_E.txt"), file("s_N.txt"), file("s_Z.txt")}), "E N Z ");
  EXPECT_EQ(marks_of({file("s_000.txt"), file("s_090.txt")}), "000 090 ");
  EXPECT_EQ(marks_of({file("s_E.txt"), file("t_N.txt")}), "- - ");
  EXPECT_EQ(marks_of({file("s_E.txt"), file("s_N.txt", 0.02)}), "- - ");
  EXPECT_EQ(marks_of({file("s_E.txt"), file("s_N.txt", 0.01, 1010)}), "E N ") << "1 % longer";
  EXPECT_EQ(marks_of({file("s_E.txt"), file("s_N.txt", 0.01, 1020)}), "- - ");
}

}  // namespace
}  // namespace gurney::groundmotions
