#include <gmock/gmock.h>

#include "groundmotions/formats/plain_facts.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

const std::string kRows = "0.01;0.5\n0.02;0.7\n0.03;0.9\n0.04;0.8\n";

std::string error(const std::string& title) {
  return error_text([&] { read_text(title + "\n" + kRows, {.unit = "g"}); });
}

// Evenly spaced periods or frequencies look like times.
TEST(SpectrumText, SpectraAreNoMotions) {
  for (const char* title :
       {"T(s),Sa(g)", "T [s],Se [m/s2]", "T(sec),RSA(g)", "Tn (s),A (g)", "f (Hz),FAS (g)",
        "T (s) Sa (g)", "Period;Acc (g)", "T;Sd", "Frequency [Hz];A", "freq,fas", "T,PSA",
        "Natural period (s),A (g)", "Periodo (s);Sa (g)", "T_n,A", "Hz;g", "T (s);SA_RotD50 (g)",
        "T (sec),Target (g)", "[s];[g]\nT;Sa", "T;Sa\n[s];[g]"})
    EXPECT_THAT(error(title), AnyOf(HasSubstr("a record must be an acceleration history, but"),
                                    HasSubstr("a record must be a history, but the first column")))
        << title;
}

TEST(SpectrumText, MotionsOfLikeNamesAreRead) {
  for (const char* title : {"Time (s),A (g)", "T (s),A (g)", "t,a", "Time,SE", "T,Acc", "sec,g",
                            "Time (s);Station SA NS", "Sampling period 0.01 s", "t;S"})
    EXPECT_EQ(error(title), "(no error)") << title;
}

}  // namespace
}  // namespace gurney::groundmotions
