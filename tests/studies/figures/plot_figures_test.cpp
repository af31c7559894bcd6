#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "studies/figures/chart.h"
#include "studies/figures/demand_figures.h"
#include "studies/figures/labels.h"
#include "studies/figures/plan_figures.h"
#include "studies/figures/record_figures.h"
#include "studies/results/columns.h"
#include "studies/results/results_file.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"
#include "tests/support/temp_folder.h"

namespace gurney::figures {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Two configurations of 5 records at three levels; demand = im, and record 4 of the second
/// overturns at the highest.
study::DemandRuns demands() {
  study::DemandRuns all{"ICU bed", "peak_tilt", {"deg", 0.5}, "PGA geomean", {"g", 10}};
  for (const char* name : {"off", "on"}) {
    study::DemandRuns::Configuration of{name, {}};
    for (std::size_t record = 0; record < 5; ++record)
      for (const double level : {1.0, 2.0, 4.0})
        of.runs.push_back({level, 0.1 * level * std::exp(0.1 * static_cast<double>(record)),
                           *name == 'o' && name[1] == 'n' && record == 4 && level == 4, record,
                           record, std::to_string(static_cast<int>(level)) + " g"});
    all.configurations.push_back(of);
  }
  return all;
}

void expect_drawn(const std::string& svg) {
  EXPECT_EQ(count(svg, "nan"), 0u);
  EXPECT_EQ(count(svg, "\"inf\""), 0u);  // a name may begin so
  EXPECT_EQ(count(svg, "\"inf "), 0u);
  EXPECT_EQ(count(svg, ",inf"), 0u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(Labels, AreTheFieldsWords) {
  EXPECT_EQ(label_of("peak_displacement"), "Peak displacement");
  EXPECT_EQ(label_of("pfv"), "Peak floor velocity");
  EXPECT_EQ(label_of("loss_rolling"), "Rolling loss");
  EXPECT_EQ(label_of("Sa(1) RotD50"), "Sa(1) RotD50");
  EXPECT_EQ(with_unit("Tilt", {"deg", 1}), "Tilt (deg)");
  EXPECT_EQ(with_unit("Floor acceleration", {"m/s2", 1}), "Floor acceleration (m/s\u00b2)");
  EXPECT_EQ(with_unit("Number of impacts", {"1", 1}), "Number of impacts");
  for (const auto& column : study::demand_columns())
    EXPECT_THAT(label_of(column.name), Not(HasSubstr("_"))) << column.name;
  for (const auto& column : study::wheel_sample_columns())
    EXPECT_THAT(label_of(column.name), Not(HasSubstr("_"))) << column.name;
}

TEST(Labels, OfInputsHaveNeitherKeysNorUnits) {
  EXPECT_EQ(input_label({"front left/tread.normal_damping_n_s_per_m", "b", "c", "d"}),
            "front left: tread normal damping and 3 equal to it");
  EXPECT_EQ(input_label({"chassis.center_of_mass_m.x"}), "chassis center of mass x");
  EXPECT_EQ(input_label({"yaw_deg"}), "yaw");
  EXPECT_EQ(input_label({"record"}), "record");
}

/// The ramp grows lighter: its order is seen in grey.
TEST(Colors, OfOrderedCurvesGrowLighter) {
  double before = -1;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::string color = ramp(i, 12);
    const auto part = [&](std::size_t at) { return std::stoi(color.substr(at, 2), nullptr, 16); };
    const double luma = 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);  // ITU-R BT.709
    EXPECT_GT(luma, before) << color;
    before = luma;
  }
}

/// Four panels in two columns, the first over two rows, the last across.
TEST(Chart, PlacesPanelsInAGrid) {
  const auto panel = [](const char* title) {
    return Panel{
        .title = title, .x_label = "", .y_label = "", .curves = {{"", {0, 1}, {0, 1}, {}}}};
  };
  Chart chart{.title = "title", .note = "", .columns = 2, .footnotes = {"below"}};
  chart.panels = of_height({panel("tall"), panel("b"), panel("c"), panel("wide")}, 100);
  chart.panels[0].down = 2;
  chart.panels[3].across = 2;
  const std::string svg = chart.svg({.width = 1000});
  expect_drawn(svg);
  std::vector<std::array<double, 4>> frames;
  const std::string clip = "\"><rect x=\"";
  for (auto at = svg.find(clip); at != std::string::npos; at = svg.find(clip, at + 1)) {
    std::array<double, 4> f{};
    std::sscanf(svg.c_str() + at + 2, "<rect x=\"%lf\" y=\"%lf\" width=\"%lf\" height=\"%lf\"",
                &f[0], &f[1], &f[2], &f[3]);
    frames.push_back(f);
  }
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0][1], frames[1][1]);
  EXPECT_NEAR(frames[0][1] + frames[0][3], frames[2][1] + frames[2][3], 0.011)
      << "to the second row";
  EXPECT_EQ(frames[1][0], frames[2][0]);
  EXPECT_EQ(frames[3][0], frames[0][0]);
  EXPECT_GT(frames[3][1], frames[2][1] + frames[2][3]);
  EXPECT_NEAR(frames[3][0] + frames[3][2], frames[1][0] + frames[1][2], 0.011);
  EXPECT_LT(svg.find(">wide<"), svg.find(">below<"));
}

/// Advances of DejaVu Sans, the widest of the figures' fonts, at 1000 px.
TEST(Text, IsMeasuredInTheWidestFont) {
  EXPECT_NEAR(text_width("free_width_at_end < 0.8 m", 1000), 13473, 60);  // without kerning
  EXPECT_NEAR(text_width("\u03c3 0.505", 1000), 634 + 318 + 4 * 636 + 318, 10);
}

/// Begin and end of every horizontal text [px].
std::vector<std::pair<double, double>> extents(const std::string& svg) {
  std::vector<std::pair<double, double>> found;
  for (auto at = svg.find("<text "); at != std::string::npos; at = svg.find("<text ", at + 1)) {
    double x = 0, y = 0, size = 0;
    char anchor[8] = "";
    EXPECT_EQ(std::sscanf(svg.c_str() + at,
                          "<text x=\"%lf\" y=\"%lf\" font-size=\"%lf\" text-anchor=\"%7[a-z]", &x,
                          &y, &size, anchor),
              4);
    const auto from = svg.find('>', at) + 1;
    if (svg.substr(at, from - at).find("rotate") != std::string::npos) continue;
    const double wide = text_width(svg.substr(from, svg.find('<', from) - from), size);
    const double left = x - (anchor[0] == 's' ? 0 : anchor[0] == 'm' ? wide / 2 : wide);
    found.emplace_back(left, left + wide);
  }
  return found;
}

TEST(Text, StaysOnThePaper) {
  study::DemandRuns all = demands();
  all.configurations[0].name = "beds braked, carts free";
  for (const double width : {300.0, 480.0, 700.0})
    for (const std::string& svg : {cloud_figure({.width = width}, "title", {all}),
                                   stripes_figure({.width = width}, "", {all}),
                                   distribution_figure({.width = width}, "", {all})})
      for (const auto& [from, to] : extents(svg)) {
        EXPECT_GE(from, 0);
        EXPECT_LE(to, width);
      }
}

/// A title that is wider than its panel goes on in a second line.
TEST(Text, OfTitlesIsWhole) {
  const std::string title =
      "no wheelchair passes: corridor: free_width_at_end below 0.8 m at the end";
  const Panel panel{
      .title = title, .x_label = "", .y_label = "", .curves = {{"", {0, 1}, {0, 1}, {}}}};
  const std::string svg = Chart{"", "", {{.panel = panel}}}.svg({.width = 480});
  EXPECT_THAT(svg, Not(HasSubstr("\u2026")));
  EXPECT_THAT(svg, HasSubstr(" at the end<"));
}

TEST(Axes, HaveTwoTicksOrMore) {
  EXPECT_EQ(axis_ticks({-8, 8}, 2), (std::vector<double>{-5, 0, 5}));
  EXPECT_EQ(axis_ticks({0, 10}, 5), ticks({0, 10}, 5));
}

TEST(Axes, OfDecadesHaveOneFormOfNumbers) {
  const Panel panel{.title = "",
                    .x_label = "",
                    .y_label = "",
                    .curves = {{"", {180, 6000}, {0, 1}, {}}},
                    .log_x = true};
  const std::string svg = Chart{"", "", {{.panel = panel}}}.svg();
  EXPECT_THAT(svg, HasSubstr(">200<"));
  EXPECT_THAT(svg, HasSubstr(">1000<"));
  EXPECT_THAT(svg, Not(HasSubstr("e+03<")));
}

/// Rounding of 1e-13 rad is a flat line.
TEST(Axes, DoNotMagnifyRounding) {
  const study::StoredHistory swivel{
      "swivel_angle", "rad", "wheel", {0, 1, 2}, {{"leg 1", "", {0, 8e-15, -3e-15}}}};
  const std::string svg = history_figure({}, "title", "", {swivel});
  EXPECT_EQ(count(svg, "e-1"), 0u);
  EXPECT_GE(count(svg, ">0.02<"), 1u);  // deg: of a span of 0.1 deg
}

TEST(Colors, ThatRepeatHaveDashes) {
  EXPECT_EQ(palette(7), palette(0));
  EXPECT_NE(pen(7).dash, pen(0).dash);
  EXPECT_NE(pen(14).dash, pen(7).dash);
  Panel panel{.title = "", .x_label = "", .y_label = "", .legend_columns = 3};
  for (std::size_t i = 0; i < 8; ++i)
    panel.curves.push_back({std::to_string(i), {0, 1}, {0, 1}, pen(i)});
  const std::string svg = Chart{"", "", {{.panel = panel}}}.svg();
  EXPECT_EQ(count(svg, "stroke-dasharray=\"" + pen(7).dash + '"'), 2u) << "curve and key";
}

/// A curve over 1 to 4 that is known from 1.5 to 3.
TEST(Curves, AreDottedWhereNothingIsKnown) {
  Panel panel{.title = "", .x_label = "", .y_label = ""};
  panel.curves = {{"", {1, 2, 4}, {0, 1, 3}, pen(0)}};
  EXPECT_EQ(count(Chart{"", "", {{.panel = panel}}}.svg(), "<polyline"), 1u);
  panel.curves.front().known = {1.5, 3};
  const std::string svg = Chart{"", "", {{.panel = panel}}}.svg();
  EXPECT_EQ(count(svg, "<polyline"), 3u);
  EXPECT_EQ(count(svg, "stroke-dasharray=\"1.5 3\""), 2u);
}

TEST(PlotFigures, IdaHasCurvesFractilesAndOverturnings) {
  const std::string svg = ida_figure({}, "title", {demands()});
  expect_drawn(svg);
  for (const char* text : {"ICU bed, off", "ICU bed, on", "16 %", "50 %", "84 %", ">overturns<"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(svg, HasSubstr("Peak tilt (deg)"));
  EXPECT_THAT(svg, HasSubstr("PGA geomean (g)"));
  // A curve for each record of each panel, and one key of the legend.
  EXPECT_EQ(count(svg, "<polyline") - 2 * 3, 2u * 5);
}

TEST(PlotFigures, StripesMarkWhatOverturned) {
  const std::string svg = stripes_figure({}, "title", {demands()});
  expect_drawn(svg);
  EXPECT_THAT(svg, HasSubstr("off, median"));
  EXPECT_THAT(svg, HasSubstr("on, overturned"));
  EXPECT_THAT(svg, Not(HasSubstr("off, overturned")));
  EXPECT_EQ(count(svg, "<circle"), 15u + 1) << "runs of the first configuration, and its key";
  EXPECT_EQ(count(svg, "<polygon"), 2u) << "areas between fractiles";
}

/// A page gives the command of the run behind a mark.
TEST(PlotFigures, MarksNameTheirRuns) {
  study::DemandRuns all = demands();
  std::size_t run = 100;
  for (auto& configuration : all.configurations)
    for (study::DemandRun& each : configuration.runs) each.run = run++;
  const std::string stripes = stripes_figure({}, "title", {all}),
                    cloud = cloud_figure({.most_marks = 10}, "title", {all});
  EXPECT_THAT(stripes, HasSubstr("data-name=\"off\" data-runs=\"100 101 102 103 104 105"));
  EXPECT_THAT(stripes, HasSubstr("data-name=\"on, overturned\" data-runs=\"129\""));
  EXPECT_THAT(cloud, HasSubstr("data-runs=\"100 103 106 109 112\"")) << "every third";
}

TEST(PlotFigures, PanelsApartArePicturesWithTheNote) {
  const std::string svg =
      distribution_figure({.width = 300, .apart = true}, "the title", {demands()});
  expect_drawn(svg);
  EXPECT_EQ(count(svg, "<svg "), 2u);
  EXPECT_EQ(count(svg, "<desc>empirical distribution"), 2u);
  EXPECT_EQ(count(svg, "<svg "), count(svg, "</svg>"));
  EXPECT_THAT(svg, Not(HasSubstr("the title")));
}

TEST(PlotFigures, CloudStatesItsRegression) {
  const std::string svg = cloud_figure({}, "title", {demands()});
  expect_drawn(svg);
  // ln(demand / 0.5) over ln(im / 10): slope 1, intercept ln(0.1 * 10 / 0.5) + mean of 0 to 0.4.
  EXPECT_THAT(svg, HasSubstr("off: ln D = 0.893 + 1 ln IM"));
  EXPECT_THAT(svg, HasSubstr("Peak tilt (deg), log scale"));
  EXPECT_THAT(svg, HasSubstr("PGA geomean (g), log scale"));
}

TEST(PlotFigures, DistributionsHaveACurveForEachLevel) {
  const std::string svg = distribution_figure({}, "title", {demands()});
  expect_drawn(svg);
  for (const char* level : {">1 g<", ">2 g<", ">4 g<"}) EXPECT_EQ(count(svg, level), 2u) << level;
  EXPECT_THAT(svg, HasSubstr("Fraction of runs"));
  // Curve and key of the lowest, the middle and the highest level in each panel.
  for (std::size_t level = 0; level < 3; ++level)
    EXPECT_EQ(count(svg, "stroke=\"" + ramp(level, 3) + '"'), 2u * 2) << level;
}

/// The wide demands of one item set the axis of the other, too.
TEST(PlotFigures, DistributionsOfADemandShareTheirAxis) {
  study::DemandRuns wide = demands();
  for (auto& configuration : wide.configurations)
    for (study::DemandRun& run : configuration.runs) run.demand *= 10;
  const std::string svg = distribution_figure({}, "title", {demands(), wide});
  // 0.4 exp(0.4) of the largest demand is 0.6, in its unit 1.2 deg, of the wide one 11.9 deg.
  EXPECT_EQ(count(svg, ">10<"), 4u);
  wide.column = "peak_yaw";
  EXPECT_EQ(count(distribution_figure({}, "title", {demands(), wide}), ">10<"), 2u);
}

/// A vertical component of several g does not flatten the horizontal ones.
TEST(PlotFigures, ComponentsOfTheFloorHaveAxesOfTheirOwn) {
  const study::StoredHistory floor{
      "floor_acceleration",
      "m/s2",
      "axis",
      {0, 1, 2},
      {{"", "x", {0, 0.2, 0}}, {"", "y", {0, 0.3, 0}}, {"", "z", {0, 30, 0}}}};
  const std::string svg = history_figure({}, "title", "", {floor});
  expect_drawn(svg);
  EXPECT_EQ(count(svg, "<clipPath"), 3u);
  EXPECT_EQ(count(svg, ">0.02<"), 2u);  // g
  EXPECT_THAT(svg, HasSubstr(">2<"));
}

TEST(PlotFigures, ManyWheelsHaveAxesOfTheirOwn) {
  study::StoredHistory force{"normal_force", "N", "wheel", {0, 1, 2}, {}};
  for (const char* wheel : {"a", "b", "c", "d"}) force.series.push_back({wheel, "", {1, 2, 3}});
  const study::StoredHistory tilt{"tilt", "rad", "item", {0, 1, 2}, {{"", "", {0, 0.1, 0}}}};
  const std::string svg = history_figure({}, "title", "run 3", {force, tilt});
  expect_drawn(svg);
  EXPECT_EQ(count(svg, "<clipPath"), 4u + 1);
  EXPECT_THAT(svg, HasSubstr("Normal force (N)"));
  EXPECT_THAT(svg, HasSubstr("Tilt (deg)"));
  EXPECT_EQ(count(svg, ">Time (s)<"), 2u);
}

TEST(PlotFigures, TrajectoriesShowRoomItemsAndImpacts) {
  const TempFolder folder;
  const std::string path =
      folder.write("ward.h5", study::results_image(synthetic_ward(), synthetic_ward_response()));
  const std::string svg = trajectory_figure({}, path);
  expect_drawn(svg);
  EXPECT_THAT(svg, HasSubstr("x (m)"));
  EXPECT_THAT(svg, HasSubstr(">impact<"));
  for (const auto& item : synthetic_ward().scene.items)
    EXPECT_THAT(svg, HasSubstr(">" + item.name)) << item.name;
}

TEST(PlotFigures, FitANarrowColumn) {
  const PlotPage narrow{.width = 240};
  study::DemandRuns all = demands();
  all.item = std::string(500, 'W');
  for (const std::string& svg :
       {ida_figure(narrow, std::string(2000, 'x'), {all}), cloud_figure(narrow, "", {all}),
        stripes_figure(narrow, "", {all}), distribution_figure(narrow, "", {all})}) {
    expect_drawn(svg);
    EXPECT_THAT(svg, HasSubstr("width=\"240\""));
    EXPECT_THAT(svg, Not(HasSubstr(std::string(60, 'W'))));
  }
}

TEST(PlotFigures, HostileNamesAreText) {
  study::DemandRuns all = demands();
  all.item = "<script>alert('x')</script>&\"";
  all.configurations[0].name = std::string("a\x1b[31m\x01 \xc3\xa9\xe6\xbc\xa2 \xff");
  for (const std::string& svg :
       {ida_figure({}, all.item, {all}), stripes_figure({}, all.item, {all}),
        cloud_figure({}, all.item, {all}), distribution_figure({}, all.item, {all})}) {
    expect_drawn(svg);
    EXPECT_THAT(svg, Not(HasSubstr("<script")));
    EXPECT_THAT(svg, HasSubstr("&lt;script&gt;"));
    EXPECT_THAT(svg, Not(HasSubstr("\x1b")));
    EXPECT_THAT(svg, HasSubstr("\xc3\xa9\xe6\xbc\xa2"));
  }
}

}  // namespace
}  // namespace gurney::figures
