#include "studies/figures/vector_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/figures/panel.h"
#include "studies/report/fragility_report.h"

namespace gurney::figures {
namespace {

constexpr double kSide = 330, kLeft = 80, kGap = 90, kTop = 110, kRow = 430;
constexpr std::size_t kAcross = 3;
constexpr double kRing = 4, kDot = 2;       // one is seen within the other
constexpr std::size_t kHit = 1, kMiss = 0;  // of the palette

/// log10 of both intensities of each run.
struct Cloud {
  Range x{1e300, -1e300}, y{1e300, -1e300};
  Svg::Points points;

  Cloud(const study::VectorResult& result, const std::array<study::ReportUnit, 2>& units) {
    for (const statistics::VectorObservation& each : result.runs) {
      points.emplace_back(std::log10(each.first / units[0].in_si),
                          std::log10(each.second / units[1].in_si));
      const auto widen = [](Range& range, double value) {
        range = {std::min(range.low, value), std::max(range.high, value)};
      };
      widen(x, points.back().first);
      widen(y, points.back().second);
    }
    for (Range* range : {&x, &y}) {
      const double air = 0.05 * range->span() + 0.02;
      *range = {range->low - air, range->high + air};
    }
  }
};

void draw_axes(Svg& svg, const Frame& frame, const Cloud& cloud, const std::string& title,
               const std::string& x_label, const std::string& y_label) {
  const Scaling scaling(frame, cloud.x, cloud.y);
  const double bottom = frame.y + frame.height;
  double end = -1e300;  // of the label before
  for (const double tick : decade_ticks(cloud.x)) {
    const std::string label = fmt::format("{:.3g}", std::pow(10, tick));
    const double at = scaling.x(tick), half = text_width(label, 10) / 2;
    svg.line(at, frame.y, at, bottom, {.stroke = "#e6e6e6"});
    if (at - half < end + 6) continue;
    svg.text(at, bottom + 15, label, {.size = 10, .anchor = Anchor::kMiddle});
    end = at + half;
  }
  for (const double tick : decade_ticks(cloud.y)) {
    svg.line(frame.x, scaling.y(tick), frame.x + frame.width, scaling.y(tick),
             {.stroke = "#e6e6e6"});
    svg.text(frame.x - 6, scaling.y(tick) + 4, fmt::format("{:.3g}", std::pow(10, tick)),
             {.size = 10, .anchor = Anchor::kEnd});
  }
  svg.rectangle(frame.x, frame.y, frame.width, frame.height, {.stroke = "#444444", .width = 0.8});
  svg.text(frame.x, frame.y - 9, title, {.size = 12, .bold = true});
  svg.text(frame.x + frame.width / 2, bottom + 32, x_label, {.anchor = Anchor::kMiddle});
  svg.text(frame.x - 46, frame.y + frame.height / 2, y_label,
           {.anchor = Anchor::kMiddle, .upwards = true});
}

/// The part of a line slope_x x + slope_y y = level inside the axes.
std::vector<std::pair<double, double>> inside(const Cloud& cloud, double slope_x, double slope_y,
                                              double level) {
  std::vector<std::pair<double, double>> ends;
  const auto add = [&](double x, double y) {
    const double air = 1e-9;
    if (x >= cloud.x.low - air && x <= cloud.x.high + air && y >= cloud.y.low - air &&
        y <= cloud.y.high + air)
      ends.emplace_back(x, y);
  };
  for (const double x : {cloud.x.low, cloud.x.high}) add(x, (level - slope_x * x) / slope_y);
  for (const double y : {cloud.y.low, cloud.y.high}) add((level - slope_y * y) / slope_x, y);
  return ends;
}

void draw_result(Svg& svg, const Frame& frame, const study::VectorResult& result,
                 const std::array<study::ReportUnit, 2>& units) {
  if (result.runs.empty()) return;
  const Cloud cloud(result, units);
  const std::string title =
      result.configuration.empty() ? result.state : result.state + ", " + result.configuration;
  draw_axes(svg, frame, cloud, title,
            fmt::format("{} ({})", result.measures[0].name, units[0].name),
            fmt::format("{} ({})", result.measures[1].name, units[1].name));
  const Scaling scaling(frame, cloud.x, cloud.y);
  for (const bool hit : {false, true})
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      if (result.runs[i].exceeded != hit) continue;
      const std::string color = palette(hit ? kHit : kMiss);
      svg.circle(scaling.x(cloud.points[i].first), scaling.y(cloud.points[i].second),
                 hit ? kDot : kRing, {.stroke = color, .width = 1.2, .fill = hit ? color : ""});
    }
  if (result.fit.status != statistics::VectorStatus::kFitted) {
    svg.text(frame.x + 8, frame.y + 18, "no fit", {.color = "#555555"});
    return;
  }
  const Eigen::Vector3d& plane = result.fit.plane;
  const double ten = std::log(10.0);
  const double c =
      plane[2] + plane[0] * std::log(units[0].in_si) + plane[1] * std::log(units[1].in_si);
  for (const double p : {0.16, 0.5, 0.84}) {
    const auto ends = inside(cloud, plane[0] * ten, plane[1] * ten, normal_quantile(p) - c);
    if (ends.size() < 2) continue;
    const auto [from, to] = std::ranges::minmax_element(ends);
    svg.line(scaling.x(from->first), scaling.y(from->second), scaling.x(to->first),
             scaling.y(to->second),
             {.stroke = "#222222", .width = p == 0.5 ? 2.0 : 1.0, .dash = p == 0.5 ? "" : "5 3"});
  }
}

void draw_key(Svg& svg) {
  const std::string hit = palette(kHit), miss = palette(kMiss);
  svg.circle(30, 46, kDot, {.stroke = hit, .width = 1.2, .fill = hit});
  svg.text(40, 50, "run that exceeds");
  svg.circle(150, 46, kRing, {.stroke = miss, .width = 1.2});
  svg.text(160, 50, "run that does not");
  svg.line(24, 63, 46, 63, {.stroke = "#222222", .width = 2});
  svg.text(52, 67, "50 % of the fit");
  svg.line(144, 63, 166, 63, {.stroke = "#222222", .dash = "5 3"});
  svg.text(172, 67, "16 % and 84 %");
}

}  // namespace

std::string vector_figure(const study::StudyData& data,
                          const std::vector<study::VectorResult>& results) {
  const std::size_t across = std::min(kAcross, results.size());
  const std::size_t rows = (results.size() + across - 1) / across;
  Svg svg(kLeft + static_cast<double>(across) * (kSide + kGap),
          kTop + kRow * static_cast<double>(rows));
  svg.text(24, 26, data.file().text_attribute("title"), {.size = 15, .bold = true});
  draw_key(svg);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::size_t row = i / across;
    const Frame frame{kLeft + static_cast<double>(i % across) * (kSide + kGap),
                      kTop + kRow * static_cast<double>(row), kSide, kSide};
    draw_result(svg, frame, results[i],
                {study::report_unit(data, results[i].measures[0]),
                 study::report_unit(data, results[i].measures[1])});
  }
  return svg.str();
}

}  // namespace gurney::figures
