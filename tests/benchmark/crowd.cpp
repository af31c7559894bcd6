#include "tests/benchmark/crowd.h"

#include <fmt/core.h>

#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kGap = 0.15;  // to walls and to each other [m]

/// Around a rectangle about the origin, above the wheels.
void add_walls(Scene& scene, const Vector2& half_size) {
  constexpr double kThickness = 0.2, kLength = 10, kBottom = 0.2, kHeight = 2;
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {1.0, -1.0}) {
      Vector3 center(0, 0, kBottom + 0.5 * kHeight), size(kLength, kLength, kHeight);
      center[axis] = side * (half_size[axis] + 0.5 * kThickness);
      size[axis] = kThickness;
      scene.room.push_back({fmt::format("wall {}", scene.room.size() + 1), "", center,
                            Quaternion::Identity(), RoomBox{size}});
    }
}

}  // namespace

Scene crowd(int columns, int rows) {
  Scene scene = trolley({10, 100, 200, 300});
  const Vector2 pitch = scene.items[0].model.shape[0].size.head<2>() + Vector2(kGap, kGap);
  for (int k = 0; k < columns * rows; ++k) {
    if (k > 0) {
      const double turn = 36.0 * k;
      scene.items.push_back(trolley({10 + turn, 100 + turn, 200 + turn, 300 + turn}).items[0]);
    }
    PlacedItem& item = scene.items.back();
    item.name = fmt::format("trolley {}", k + 1);
    item.initial.position.x() = pitch.x() * (k % columns - 0.5 * (columns - 1));
    item.initial.position.y() = pitch.y() * (k / columns - 0.5 * (rows - 1));
  }
  add_walls(scene, 0.5 * Vector2((pitch.x() * columns + kGap), (pitch.y() * rows + kGap)));
  return scene;
}

}  // namespace gurney::benchmark
