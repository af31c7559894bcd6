#include "studies/figures/trajectory_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "studies/explanation/footprint.h"
#include "studies/figures/scene_figure.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::figures {
namespace {

const std::string kWall = "#888888", kStart = "#777777", kImpact = "#c00000";

Curve closed(const explanation::Polygon& polygon, const std::string& label, const Pen& pen) {
  Curve curve{label, {}, {}, pen};
  for (std::size_t i = 0; i <= polygon.size() && !polygon.empty(); ++i) {
    curve.x.push_back(polygon[i % polygon.size()].x());
    curve.y.push_back(polygon[i % polygon.size()].y());
  }
  return curve;
}

/// The tables of a file of one run that say where things are.
struct RunPlan {
  explicit RunPlan(const study::Hdf5Reader& file)
      : items(file.strings("/histories/item")),
        start(file.numbers("/histories/start")),
        displacement(file.numbers("/histories/displacement")),
        orientation(file.numbers("/histories/orientation")),
        owner(file.strings("/shapes/item")),
        body(file.strings("/shapes/body")),
        first(file.numbers("/shapes/first")),
        count(file.numbers("/shapes/count")),
        points(file.numbers("/shapes/point")) {
    require(!items.empty() && start.size() == 3 * items.size() &&
                displacement.size() % (3 * items.size()) == 0 &&
                displacement.size() / 3 == orientation.size() / 4 && !displacement.empty(),
            file.path() + ": its histories differ in length");
    file.require_length({"/shapes/body", "/shapes/first", "/shapes/count"}, owner.size());
    for (std::size_t i = 0; i < owner.size(); ++i)
      require(first[i] >= 0 && count[i] >= 1 && 3 * (first[i] + count[i]) <= double(points.size()),
              fmt::format("{}: /shapes: shape {} has points that are not there", file.path(), i));
  }

  std::size_t samples() const { return displacement.size() / (3 * items.size()); }

  Vector3 origin(std::size_t item, std::size_t sample) const {
    const std::size_t at = 3 * (sample * items.size() + item);
    return Vector3(start[3 * item], start[3 * item + 1], start[3 * item + 2]) +
           Vector3(displacement[at], displacement[at + 1], displacement[at + 2]);
  }

  Vector3 placed(std::size_t item, std::size_t sample, const Vector3& point) const {
    const std::size_t at = 4 * (sample * items.size() + item);
    return origin(item, sample) + Quaternion(orientation[at], orientation[at + 1],
                                             orientation[at + 2], orientation[at + 3]) *
                                      point;
  }

  std::vector<Vector3> points_of(std::size_t shape) const {
    std::vector<Vector3> result;
    const auto from = static_cast<std::size_t>(first[shape]);
    for (std::size_t i = from; i < from + static_cast<std::size_t>(count[shape]); ++i)
      result.emplace_back(points.at(3 * i), points.at(3 * i + 1), points.at(3 * i + 2));
    return result;
  }

  /// The last sample whose numbers are numbers: a run that diverged may end in others.
  std::size_t last(std::size_t item) const {
    std::size_t sample = samples() - 1;
    while (sample > 0 && !origin(item, sample).allFinite()) --sample;
    return sample;
  }

  std::vector<std::string> items;
  std::vector<double> start, displacement, orientation;
  std::vector<std::string> owner, body;
  std::vector<double> first, count, points;
};

void add_room(Panel& panel, const RunPlan& plan) {
  for (std::size_t shape = 0; shape < plan.owner.size(); ++shape) {
    if (!plan.owner[shape].empty()) continue;
    std::vector<Vector2> points;
    for (const Vector3& point : plan.points_of(shape)) points.push_back(point.head<2>());
    panel.curves.push_back(
        closed(explanation::convex_hull(points), "", {.stroke = kWall, .width = 0.8}));
  }
}

/// The outline of an item, with a line from its middle to its front.
void add_item(Panel& panel, const RunPlan& plan, std::size_t item, std::size_t sample,
              const Pen& pen, const std::string& label) {
  double front = 0;
  std::string once = label;
  for (std::size_t shape = 0; shape < plan.owner.size(); ++shape) {
    if (plan.owner[shape] != plan.items[item] || plan.body[shape] != "chassis") continue;
    std::vector<Vector2> points;
    for (const Vector3& point : plan.points_of(shape)) {
      front = std::max(front, point.x());
      points.push_back(plan.placed(item, sample, point).head<2>());
    }
    panel.curves.push_back(closed(explanation::convex_hull(points), once, pen));
    once.clear();
  }
  const Vector3 middle = plan.placed(item, sample, Vector3::Zero());
  const Vector3 tip = plan.placed(item, sample, {front, 0, 0});
  panel.curves.push_back({"", {middle.x(), tip.x()}, {middle.y(), tip.y()}, pen});
  panel.marks.push_back(
      {"", {tip.x()}, {tip.y()}, {.stroke = pen.stroke, .fill = pen.stroke}, Marker::kCircle, 2});
}

Panel empty_plan(const std::string& title, const std::string& x, const std::string& y) {
  return {.title = title,
          .x_label = x,
          .y_label = y,
          .zero_line = false,
          .equal_scales = true,
          .legend_columns = 4};
}

Panel plan_of_run(const study::Hdf5Reader& file) {
  const RunPlan plan(file);
  Panel panel = empty_plan("Seen from above", "x", "y");
  add_room(panel, plan);
  for (std::size_t item = 0; item < plan.items.size(); ++item) {
    const std::size_t last = plan.last(item);
    add_item(panel, plan, item, 0, {.stroke = kStart, .width = 1}, item == 0 ? "at the start" : "");
    Curve path{"", {}, {}, {.stroke = palette(item), .width = 1.8}};
    for (std::size_t sample = 0; sample <= last; ++sample) {
      path.x.push_back(plan.origin(item, sample).x());
      path.y.push_back(plan.origin(item, sample).y());
    }
    panel.curves.push_back(std::move(path));
    add_item(panel, plan, item, last, {.stroke = palette(item), .width = 1}, plan.items[item]);
  }
  Marks impacts{"impact",
                file.numbers("/events/point_x"),
                file.numbers("/events/point_y"),
                {.stroke = kImpact, .width = 1.4},
                Marker::kCross,
                3.5};
  if (!impacts.x.empty()) panel.marks.push_back(std::move(impacts));
  return panel;
}

Panel paths_of_study(const study::StoredHistories& histories) {
  Panel panel = empty_plan("", "x from the start", "y from the start");
  std::vector<std::string> items;
  for (const std::size_t run : histories.runs()) {
    const study::StoredHistory history = histories.history("displacement", run);
    for (std::size_t i = 0; i + 1 < history.series.size(); ++i) {
      const auto &x = history.series[i], &y = history.series[i + 1];
      if (x.axis != "x" || y.axis != "y") continue;
      const auto known = std::ranges::find(items, x.part);
      const auto index = static_cast<std::size_t>(known - items.begin());
      if (known == items.end()) items.push_back(x.part);
      panel.curves.push_back({known == items.end() ? x.part : "",
                              x.values,
                              y.values,
                              {.stroke = palette(index), .width = 0.7, .opacity = 0.6}});
      panel.marks.push_back({"",
                             {x.values.back()},
                             {y.values.back()},
                             {.stroke = palette(index), .width = 0.8},
                             marker(index),
                             2});
    }
  }
  return panel;
}

/// Height over width of what is drawn.
double aspect_of(const Panel& panel) {
  double low[] = {1e300, 1e300}, high[] = {-1e300, -1e300};
  for (const Curve& curve : panel.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double at[] = {curve.x[i], curve.y[i]};
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
  const double width = high[0] - low[0];
  return width > 0 ? std::clamp((high[1] - low[1]) / width, 0.35, 1.0) : 1.0;
}

}  // namespace

std::string trajectory_figure(const PlotPage& page, const std::string& path) {
  const study::StoredHistories histories(path);
  const std::vector<std::size_t> runs = histories.runs();
  require(!runs.empty(), path + ": holds no histories, so it knows no paths");
  const study::Hdf5Reader file(path);
  const bool study = file.text_attribute("filetype") == "gurney-study";
  Panel panel = study ? paths_of_study(histories) : plan_of_run(file);
  set_unit(panel, page.units);
  const std::string note =
      study ? fmt::format(
                  "paths of the items' origins in {} runs, each from its start; marked: the "
                  "end",
                  runs.size())
            : "line: path of the item's origin; outlines at the start and at the end, the dot at "
              "the front";
  return Chart{histories.title(), note, {{.panel = panel, .aspect = aspect_of(panel)}}}.svg(page);
}

}  // namespace gurney::figures
