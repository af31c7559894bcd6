// Layouts that users have; all files are synthetic.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>

#include "engine/base/units.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

const ReadOptions kG = {.unit = "g", .time_step = 0.01};

/// A column of 40 samples under a header.
std::string column(const std::string& header) {
  std::string text = header + "\n";
  for (int i = 0; i < 40; ++i) text += fmt::format("{:.6f}\n", 0.1 * std::sin(0.7 * i));
  return text;
}

/// Rows of a time and `count` samples under titles.
std::string table(const std::string& titles, int count, const std::string& separator = ",") {
  std::string text = titles + "\n";
  for (int i = 0; i < 40; ++i) {
    text += fmt::format("{:.2f}", 0.01 * i);
    for (int k = 1; k <= count; ++k)
      text += fmt::format("{}{:.6f}", separator, 0.1 * std::sin(0.7 * i * k));
    text += "\n";
  }
  return text;
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  return error_text([&] { read_text(text, options); });
}

TEST(UserFiles, TakeTheDirectionThatTheTextStates) {
  for (const char* header :
       {"Component: UP", "Component: Vertical", "Comp: UD", "VERTICAL COMPONENT", "Channel: HNZ",
        "# Componente: HNZ", "Direction: V", "Acceleration (VERTICAL)"})
    EXPECT_EQ(read_one(column(header), kG).direction, Direction::kVertical) << header;
  for (const char* header : {"Component: E-W", "Direction: 90", "EW component", "Dir. E"})
    EXPECT_DOUBLE_EQ(read_one(column(header), kG).azimuth.value_or(-1), std::numbers::pi / 2)
        << header;
  for (const char* header : {"El Centro 1940 North South Component", "Component: North South"})
    EXPECT_EQ(read_one(column(header), kG).azimuth, 0) << header;
  for (const char* header : {"Component: 2", "Component H1", "Vertical distance 3 km", "Roof (N)"})
    EXPECT_FALSE(read_one(column(header), kG).azimuth || read_one(column(header), kG).direction)
        << header;
  const Component at2 =
      read_one(column("ACCELERATION TIME HISTORY (VERTICAL), units of cm/s/s, dt=0.01"));
  EXPECT_EQ(at2.format, "PEER AT2");
  EXPECT_EQ(at2.direction, Direction::kVertical);
  EXPECT_EQ(read_one(table("Component: UP\ntime acc", 1), {.unit = "g"}).direction,
            Direction::kVertical);
}

TEST(UserFiles, NameQuantitiesInOtherLanguages) {
  for (const char* header : {"Desplazamiento (cm)", "Spostamento [cm]", "Verschiebung (mm)",
                             "Velocidad (cm/s)", "Vitesse (m/s)", "Geschwindigkeit [m/s]"})
    EXPECT_THAT(refusal(column(header), kG), HasSubstr("a record must be acceleration")) << header;
  for (const char* header : {"Aceleraci\xc3\xb3n (g)", "Beschleunigung (g)", "Accelerazione [g]"})
    EXPECT_EQ(read_one(column(header), {.time_step = 0.01}).unit, "g") << header;
}

TEST(UserFiles, StateUnitsAndStepsInOtherLanguages) {
  for (const char* header : {"Unidades: g", "Unidad = g", "Unit\xc3\xa0: g", "Einheit: g"}) {
    EXPECT_EQ(read_one(column(header), {.time_step = 0.01}).unit, "g") << header;
    EXPECT_THAT(refusal(column(header), {.unit = "gal", .time_step = 0.01}),
                HasSubstr("the file states the unit g, but unit = \"gal\" was given"));
  }
  for (const char* header :
       {"Frecuencia de muestreo: 200 Hz", "Tasa de muestreo: 200 muestras/segundo",
        "MUESTREO  : 200 (Hz)", "Sampling rate: 0.005", "Intervalo de muestreo = 0.005 s"})
    EXPECT_DOUBLE_EQ(read_one(column(header), {.unit = "g"}).time_step, 0.005) << header;
}

TEST(UserFiles, RefuseALoneLetterOfAnotherQuantity) {
  for (const char* titles : {"t,v", "t,d", "t,u"})
    EXPECT_THAT(refusal(table(titles, 1), {.unit = "g"}),
                HasSubstr("may be a velocity, a displacement or the vertical"));
  EXPECT_EQ(read_text(table("t,e,n,u", 3), {.unit = "g"})[2].direction, Direction::kVertical);
  EXPECT_EQ(read_text(table("t,a,d", 2), {.unit = "g"}).size(), 1u);
}

TEST(UserFiles, RefuseSpectraByTheirSymbols) {
  for (const char* titles : {"T(s),S_a(g)", "T (s),Response (g)"})
    EXPECT_THAT(refusal(table(titles, 1)), HasSubstr("is that of a spectrum")) << titles;
  EXPECT_EQ(read_one(table("Time (s),Response (g)", 1)).unit, "g");
}

TEST(UserFiles, RefuseTablesBesideEachOtherWithOtherTimes) {
  std::string same, other;
  for (int i = 0; i < 40; ++i) {
    const double a = 0.1 * std::sin(0.7 * i);
    same += fmt::format("{0:.2f},{1:.4f},{0:.2f},{2:.4f}\n", 0.01 * i, a, 0.5 * a);
    other += fmt::format("{:.2f},{:.4f},{:.2f},{:.4f}\n", 0.01 * i, a, 0.02 * i, a);
  }
  const std::string titles = "Time (s),Acc (g),Time (s),Acc (g)\n";
  EXPECT_EQ(read_text(titles + same).size(), 2u);
  EXPECT_THAT(refusal(titles + other), HasSubstr("f:1:1: columns 1 and 3 are both times"));
  EXPECT_EQ(read_text(table("Time (s),L (g),T (g),V (g)", 3)).size(), 3u);
}

TEST(UserFiles, SayThatAFactorWasNotApplied) {
  for (const char* header : {"scale factor: 2.5", "Scale = 0.001", "factor de escala: 980"})
    EXPECT_THAT(read_one(column(header), kG).warnings,
                Contains(fmt::format("line 1 states a factor ('{}'): it was not applied", header)));
  EXPECT_THAT(read_one(column("scale factor: 1.0"), kG).warnings,
              Each(Not(HasSubstr("states a factor"))));
}

TEST(UserFiles, AreCutInTheLastNumberOfATable) {
  const std::string whole = table("Time (s),Acc (g)", 1);
  EXPECT_THAT(refusal(whole.substr(0, whole.size() - 3)), HasSubstr("seems to be cut"));
  EXPECT_EQ(read_one(whole.substr(0, whole.size() - 1)).acceleration.size(), 40);
}

TEST(UserFiles, HaveTextOfOtherScripts) {
  EXPECT_EQ(read_one(column("\xe5\x8a\xa0\xe9\x80\x9f\xe5\xba\xa6(gal)"), {.time_step = 0.01}).unit,
            "cm/s2");
  // A minus of Unicode is no word: the row must not be taken for text.
  EXPECT_THAT(refusal("\xe2\x88\x92"
                      "0.1\n0.2\n0.3\n",
                      kG),
              HasSubstr("f:1:1: "));
}

// The CSV files of the Japan Meteorological Agency.
TEST(UserFiles, ReadTheCsvOfJma) {
  std::string text =
      "SITE CODE= 9CE00         ,\n LAT.=   32.7000          ,\n SAMPLING RATE= 100Hz     ,\n"
      " UNIT  = gal(cm/s/s)      ,\n INITIAL TIME = 2016 04 16 01 24 30 ,\nNS,EW,UD\n";
  for (int i = 0; i < 40; ++i)
    text += fmt::format("{:.3f},{:.3f},{:.3f}\n", 10 * std::sin(i), 20 * std::cos(i),
                        5 * std::sin(2 * i));
  const auto components = read_text(text);
  ASSERT_EQ(components.size(), 3u);
  EXPECT_EQ(components[0].unit, "cm/s2");
  EXPECT_DOUBLE_EQ(components[0].time_step, 0.01);
  EXPECT_EQ(components[0].azimuth, 0);
  EXPECT_DOUBLE_EQ(components[1].azimuth.value(), std::numbers::pi / 2);
  EXPECT_EQ(components[2].direction, Direction::kVertical);
  EXPECT_NEAR(components[1].acceleration[0], 0.2, 1e-12);
}

TEST(UserFiles, NameTheirColumnsInManyWays) {
  for (const char* titles :
       {"Este,Norte,Vertical", "E-O,N-S,Vert", "Est,Nord,Vert.", "Ost,Nord,Vertikal",
        "Dogu,Kuzey,Dusey", "N90E,N00E,UPDO", "aE,aN,aZ", "E_W,N_S,U_D", "Chan E,Chan N,Chan Z",
        "CH1-EW,CH2-NS,CH3-UD", "EW-dir,NS-dir,UD-dir", "STA.EW,STA.NS,STA.UD", "W-E,S-N,D-U",
        "EASTWEST,NORTHSOUTH,UPDOWN"}) {
    const auto components = read_text(table(fmt::format("Time (s),{}", titles), 3), {.unit = "g"});
    EXPECT_DOUBLE_EQ(components.at(0).azimuth.value_or(-1), std::numbers::pi / 2) << titles;
    EXPECT_EQ(components.at(1).azimuth, 0) << titles;
    EXPECT_EQ(components.at(2).direction, Direction::kVertical) << titles;
  }
  for (const char* titles : {"ax,ay,az", "accX,accY,accZ", "Long.,Tran.,Vert."}) {
    const auto components = read_text(table(fmt::format("Time (s),{}", titles), 3), {.unit = "g"});
    EXPECT_FALSE(components.at(0).azimuth || components.at(1).azimuth) << titles;
    EXPECT_EQ(components.at(2).direction, Direction::kVertical) << titles;
  }
  // The north side of a roof is no direction.
  EXPECT_FALSE(read_one(table("Time (s),Roof-N (g)", 1)).azimuth);
}

TEST(UserFiles, MayNameTheirTimeAsGurneyDoes) {
  const Component component = read_one(table("time_s,acc_g", 1));
  EXPECT_EQ(component.unit, "g");
  EXPECT_DOUBLE_EQ(component.time_step, 0.01);
  EXPECT_EQ(read_one(table("t_s,a_mps2", 1)).unit, "m/s2");
  EXPECT_EQ(read_one(table("// time acc in g", 1, " ")).unit, "g");
}

}  // namespace
}  // namespace gurney::groundmotions
