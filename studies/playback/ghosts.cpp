#include "studies/playback/ghosts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney::playback {
namespace {

/// Half a step of each channel: the length of the vector of these.
template <class Values, class Component>
double rounding(const Values& values, int components, Component component) {
  double squares = 0;
  for (int k = 0; k < components; ++k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& value : values) {
      low = std::min(low, component(value, k));
      high = std::max(high, component(value, k));
    }
    squares += std::pow((high - low) / 65535 / 2, 2);
  }
  return std::sqrt(squares);
}

/// Between two samples, as studies/playback/recording.js has it.
Quaternion between(const Quaternion& a, const Quaternion& b, double fraction) {
  const double same = a.dot(b) >= 0 ? 1 : -1;
  Quaternion q;
  q.coeffs() = (1 - fraction) * a.coeffs() + fraction * same * b.coeffs();
  return q.normalized();
}

void add_dropped(const RecordedRun& run, const RecordedItem& item, std::size_t stride,
                 ThinningError& error) {
  for (std::size_t from = 0; from + 1 < run.time.size(); from += stride) {
    const std::size_t to = std::min(from + stride, run.time.size() - 1);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double fraction = (run.time[i] - run.time[from]) / (run.time[to] - run.time[from]);
      const Vector3 p = item.position[from] + fraction * (item.position[to] - item.position[from]);
      error.position = std::max(error.position, (p - item.position[i]).norm());
      error.angle =
          std::max(error.angle, between(item.orientation[from], item.orientation[to], fraction)
                                    .angularDistance(item.orientation[i]));
    }
  }
}

}  // namespace

RecordedRun ghost_of(const RecordedRun& run) {
  RecordedRun ghost;
  ghost.title = run.title;
  ghost.record = run.record;
  ghost.outcome = run.outcome;
  ghost.cause = run.cause;
  ghost.time = run.time;
  ghost.items = run.items;
  for (RecordedItem& item : ghost.items) item.wheels.clear();
  std::ranges::copy_if(run.moments, std::back_inserter(ghost.moments),
                       [](const Moment& each) { return each.kind == "overturned"; });
  return ghost;
}

ThinningError thinning_error(const std::vector<PageRun>& runs, std::size_t stride) {
  ThinningError dropped, rounded;
  for (const PageRun& each : runs)
    for (const RecordedItem& item : each.run.items) {
      add_dropped(each.run, item, stride, dropped);
      rounded.position =
          std::max(rounded.position,
                   rounding(item.position, 3, [](const Vector3& p, int k) { return p[k]; }));
      // A turn by a small angle changes a unit quaternion by half of it.
      rounded.angle = std::max(
          rounded.angle, 2 * rounding(item.orientation, 4,
                                      [](const Quaternion& q, int k) { return q.coeffs()[k]; }));
    }
  return {dropped.position + rounded.position, dropped.angle + rounded.angle};
}

}  // namespace gurney::playback
