#include "engine/record/zone_log.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney {
namespace {

/// Part of a zone's width that the convex hull of points (x along it, y across) takes within its
/// length; low > high: none.
///
/// The hull's part in the strip |x| <= l is spanned by the points in it and by where the segments
/// between any two points cross x = +-l.
template <typename Span>
Span across(const std::vector<Vector2>& points, double half_length) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Span span{kFar, -kFar};
  const auto add = [&](double y) {
    span.low = std::min(span.low, y);
    span.high = std::max(span.high, y);
  };
  double first = kFar, last = -kFar;
  for (const Vector2& point : points) {
    first = std::min(first, point.x());
    last = std::max(last, point.x());
    if (std::abs(point.x()) <= half_length) add(point.y());
  }
  for (double edge : {-half_length, half_length}) {
    if (!(first < edge && edge < last)) continue;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double a = points[i].x() - edge, b = points[j].x() - edge;
        if (a * b < 0) add(points[i].y() + (points[j].y() - points[i].y()) * a / (a - b));
      }
  }
  return span;
}

}  // namespace

ZoneLog::ZoneLog(const Scene& scene, const Assembly& assembly) : zones_(scene.zones) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    auto& outlines = outlines_.emplace_back();
    for (const BodyShape& shape : scene.items[i].model.shape) {
      std::vector<Vector3>& points = outlines.emplace_back(outline_points(shape));
      for (Vector3& point : points) point -= assembly.items[i].chassis.center_of_mass;
    }
  }
  for (const Zone& zone : zones_) {
    outcomes_.emplace_back();
    outcomes_.back().least_free_width = outcomes_.back().free_width_at_end = zone.width;
  }
}

double ZoneLog::free_width(const Zone& zone, std::vector<Span> taken) const {
  std::sort(taken.begin(), taken.end(), [](Span a, Span b) { return a.low < b.low; });
  double widest = 0, free_from = -0.5 * zone.width;
  for (const Span& span : taken) {
    widest = std::max(widest, span.low - free_from);
    free_from = std::max(free_from, span.high);
  }
  return std::max(widest, 0.5 * zone.width - free_from);
}

void ZoneLog::observe(double time, double duration, const SceneState& state) {
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Zone& zone = zones_[z];
    const Matrix2 to_zone = Eigen::Rotation2Dd(-zone.angle).toRotationMatrix();
    std::vector<Span> taken;
    for (std::size_t i = 0; i < outlines_.size(); ++i)
      for (const std::vector<Vector3>& outline : outlines_[i]) {
        std::vector<Vector2> points;
        for (const Vector3& point : outline) {
          const Vector3 there = state.items[i].position + state.items[i].rotation * point;
          const Vector2 from_center = there.head<2>() - zone.center;
          points.push_back(to_zone * from_center);
        }
        const Span span = across<Span>(points, 0.5 * zone.length);
        if (span.low < 0.5 * zone.width && span.high > -0.5 * zone.width) taken.push_back(span);
      }
    ZoneOutcome& outcome = outcomes_[z];
    outcome.occupied_at_end = !taken.empty();
    if (!taken.empty()) {
      outcome.occupied_time += duration;
      if (outcome.time_of_entry < 0) outcome.time_of_entry = time;
    }
    outcome.free_width_at_end = free_width(zone, std::move(taken));
    outcome.least_free_width = std::min(outcome.least_free_width, outcome.free_width_at_end);
  }
}

}  // namespace gurney
