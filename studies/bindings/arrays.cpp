#include "studies/bindings/arrays.h"

#include <limits>
#include <span>

#include "studies/results/columns.h"
#include "studies/results/names.h"

namespace gurney::bindings {
namespace {

namespace py = pybind11;
using Shape = std::vector<py::ssize_t>;

template <class Row>
py::dict numbers(const Row& row, std::span<const study::TableColumn<Row>> columns) {
  py::dict result;
  for (const study::TableColumn<Row>& column : columns) {
    const double value = column.value(row);
    if (column.is_missing(value))
      result[column.name] = std::numeric_limits<double>::quiet_NaN();
    else if (column.whole())
      result[column.name] = static_cast<long>(value);
    else
      result[column.name] = value;
  }
  return result;
}

/// {item: what `take` makes of its index}
template <class Take>
py::dict of_items(const FinishedRun& run, Take take) {
  const std::vector<std::string> names = study::item_names(run.facts.scene);
  py::dict result;
  if (!is_failure(run.response.outcome))
    for (std::size_t i = 0; i < names.size(); ++i) result[py::str(names[i])] = take(i);
  return result;
}

template <class Row>
py::dict of_parts(const std::vector<std::string>& names, const std::vector<Row>& rows,
                  std::span<const study::TableColumn<Row>> columns) {
  py::dict result;
  for (std::size_t i = 0; i < names.size(); ++i)
    result[py::str(names[i])] = numbers(rows[i], columns);
  return result;
}

/// The samples of all items, and the arrays that are made of them.
class Histories {
 public:
  explicit Histories(const std::vector<ItemResponse>& items) : items_(items) {
    times_ = items.front().history.size();
    std::vector<double> time;
    for (const Sample& sample : items.front().history) time.push_back(sample.time);
    put("time", time, {count()});
  }

  /// @param width  numbers of one item; 1: no dimension of its own
  template <class Of>
  void add(const char* name, py::ssize_t width, Of of) {
    std::vector<double> values;
    each_sample([&](const Sample& sample) {
      const auto one = of(sample);
      values.insert(values.end(), one.data(), one.data() + width);
    });
    Shape shape{count(), static_cast<py::ssize_t>(items_.size())};
    if (width > 1) shape.push_back(width);
    put(name, values, std::move(shape));
  }

  /// @param member  of what each item has several of
  void add_points(const char* name, Vector3 PointSample::*member) {
    std::vector<double> values;
    std::size_t points = 0;
    each_sample([&](const Sample& sample) {
      for (const PointSample& point : sample.points)
        values.insert(values.end(), (point.*member).data(), (point.*member).data() + 3);
    });
    for (const ItemResponse& item : items_) points += item.history.front().points.size();
    put(name, values, {count(), static_cast<py::ssize_t>(points), 3});
  }

  void add_wheels(const study::TableColumn<WheelSample>& column, const Scene& scene) {
    std::vector<double> values;
    for (std::size_t s = 0; s < times_; ++s)
      for (std::size_t i = 0; i < items_.size(); ++i)
        for (std::size_t w = 0; w < scene.items[i].model.casters.size(); ++w)
          values.push_back(column.value(items_[i].history[s].wheels[w]));
    const auto wheels = static_cast<py::ssize_t>(values.size() / times_);
    put(column.name, values, {count(), wheels});
  }

  py::dict take() { return std::move(arrays_); }

 private:
  py::ssize_t count() const { return static_cast<py::ssize_t>(times_); }

  template <class Take>
  void each_sample(Take take) const {
    for (std::size_t s = 0; s < times_; ++s)
      for (const ItemResponse& item : items_) take(item.history.at(s));
  }

  void put(const char* name, const std::vector<double>& values, Shape shape) {
    arrays_[name] = py::array_t<double>(std::move(shape), values.data());
  }

  const std::vector<ItemResponse>& items_;
  std::size_t times_ = 0;
  py::dict arrays_;
};

}  // namespace

py::dict histories(const FinishedRun& run) {
  const std::vector<ItemResponse>& items = run.response.items;
  if (items.empty() || items.front().history.empty()) return {};
  Histories all(items);
  all.add("displacement", 3, [](const Sample& s) { return s.displacement; });
  all.add("velocity", 3, [](const Sample& s) { return s.velocity; });
  all.add("acceleration", 3, [](const Sample& s) { return s.acceleration; });
  all.add("orientation", 4, [](const Sample& s) {
    const Quaternion& q = s.orientation;
    return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
  });
  for (const auto& column : study::sample_columns())
    all.add(column.name, 1, [&](const Sample& s) { return std::array{column.value(s)}; });
  for (const auto& column : study::energy_columns())
    all.add(column.name, 1, [&](const Sample& s) { return std::array{column.value(s.energy)}; });
  all.add_points("point_displacement", &PointSample::displacement);
  all.add_points("point_velocity", &PointSample::velocity);
  all.add_points("point_absolute_acceleration", &PointSample::absolute_acceleration);
  for (const auto& column : study::wheel_sample_columns()) all.add_wheels(column, run.facts.scene);
  return all.take();
}

py::dict demands(const FinishedRun& run) {
  return of_items(run, [&](std::size_t i) {
    return numbers(run.response.items[i].demands, study::demand_columns());
  });
}

py::dict wheel_demands(const FinishedRun& run) {
  return of_items(run, [&](std::size_t i) {
    return of_parts(study::caster_names(run.facts.scene.items[i].model),
                    run.response.items[i].demands.wheels, study::wheel_demand_columns());
  });
}

py::dict point_demands(const FinishedRun& run) {
  return of_items(run, [&](std::size_t i) {
    return of_parts(study::point_names(run.facts.scene.items[i].model),
                    run.response.items[i].demands.points, study::point_demand_columns());
  });
}

}  // namespace gurney::bindings
