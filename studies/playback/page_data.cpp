#include "studies/playback/page_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "studies/render/script_json.h"

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

using Json = nlohmann::json;

/// Bytes of all samples of a run before base64, which makes 4 of 3: time 4, poses 7 x 2, wheels
/// 2 x 2 + 3 + 1, floor 6 x 2.
std::size_t raw_bytes(const RecordedRun& run) {
  std::size_t sample = 4 + (run.floor_acceleration.empty() ? 0 : 12);
  for (const RecordedItem& item : run.items) sample += 14 + 8 * item.wheels.size();
  return sample * run.time.size();
}

/// Every n-th value, and the last.
template <class Value>
std::vector<Value> thinned(const std::vector<Value>& values, std::size_t stride) {
  std::vector<Value> kept;
  for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
  if (!values.empty() && (values.size() - 1) % stride != 0) kept.push_back(values.back());
  return kept;
}

class RunWriter {
 public:
  explicit RunWriter(std::size_t stride) : stride_(stride) {}

  Json channel(const std::vector<double>& values, int bits = 16) const {
    const Channel made = quantised(thinned(values, stride_), bits);
    if (made.data.empty()) return {{"offset", made.offset}};
    return {{"offset", made.offset}, {"step", made.step}, {"bits", made.bits}, {"data", made.data}};
  }

  template <class Value, class Component>
  Json channels(const std::vector<Value>& values, int count, Component component) const {
    Json all = Json::array();
    for (int i = 0; i < count; ++i) {
      std::vector<double> column;
      for (const Value& value : values) column.push_back(component(value, i));
      all.push_back(channel(column));
    }
    return all;
  }

  Json vectors(const std::vector<Vector3>& values) const {
    return channels(values, 3, [](const Vector3& v, int i) { return v[i]; });
  }

  /// w, x, y, z
  Json quaternions(const std::vector<Quaternion>& values) const {
    return channels(values, 4, [](const Quaternion& q, int i) { return q.coeffs()[(i + 3) % 4]; });
  }

  std::string bytes(const std::vector<std::uint8_t>& values) const {
    return base64(thinned(values, stride_));
  }

  /// Single precision, the low byte first.
  std::string floats(const std::vector<double>& values) const {
    std::vector<std::uint8_t> bytes;
    for (const double value : thinned(values, stride_)) {
      const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
      for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(bits >> shift & 255u));
    }
    return base64(bytes);
  }

 private:
  std::size_t stride_;
};

std::size_t base64_bytes(const std::vector<PageRun>& runs) {
  std::size_t bytes = 0;
  for (const PageRun& each : runs) bytes += raw_bytes(each.run) * 4 / 3;
  return bytes;
}

Json json_of(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const std::vector<Vector3>& points) {
  Json all = Json::array();
  for (const Vector3& point : points) all.push_back(json_of(point));
  return all;
}

Json json_of(const RecordedWheel& wheel, const RunWriter& writer) {
  return {{"name", wheel.name},
          {"pivot", json_of(wheel.pivot)},
          {"center", json_of(wheel.center)},
          {"radius", wheel.radius},
          {"width", wheel.width},
          {"swivel", writer.channel(wheel.swivel)},
          {"roll", writer.channel(wheel.roll)},
          {"normal", writer.channel(wheel.normal, 8)},
          {"longitudinal", writer.channel(wheel.longitudinal, 8)},
          {"lateral", writer.channel(wheel.lateral, 8)},
          {"mode", writer.bytes(wheel.mode)}};
}

Json json_of(const RecordedItem& item, const RunWriter& writer) {
  Json json{{"name", item.name},
            {"model", item.model},
            {"boxes", Json::array()},
            {"kinds", Json::array()},
            {"wheels", Json::array()},
            {"position", writer.vectors(item.position)},
            {"orientation", writer.quaternions(item.orientation)}};
  for (const RecordedShape& shape : item.boxes) {
    json["boxes"].push_back(json_of(shape.points));
    json["kinds"].push_back(shape.kind);
  }
  for (const RecordedWheel& wheel : item.wheels) json["wheels"].push_back(json_of(wheel, writer));
  return json;
}

Json room_of(const RecordedRun& run) {
  Json all = Json::array();
  for (const RecordedShape& shape : run.room)
    all.push_back({{"name", shape.name}, {"kind", shape.kind}, {"points", json_of(shape.points)}});
  return all;
}

Json zones_of(const RecordedRun& run) {
  Json all = Json::array();
  for (const RecordedZone& zone : run.zones)
    all.push_back({{"name", zone.name},
                   {"center", {zone.center_x, zone.center_y}},
                   {"length", zone.length},
                   {"width", zone.width},
                   {"angle", zone.angle}});
  return all;
}

Json tethers_of(const RecordedRun& run) {
  Json all = Json::array();
  for (const RecordedTether& tether : run.tethers)
    all.push_back({{"name", tether.name},
                   {"item", tether.item},
                   {"point", json_of(tether.point)},
                   {"anchor", json_of(tether.anchor)},
                   {"anchor_item", tether.anchor_item},
                   {"slack_length", tether.slack_length},
                   {"time_broken", tether.time_broken}});
  return all;
}

Json events_of(const RecordedRun& run) {
  Json all = Json::array();
  for (const Moment& moment : run.moments)
    all.push_back({{"time", moment.time},
                   {"kind", moment.kind},
                   {"item", moment.item},
                   {"text", moment.text}});
  return all;
}

Json json_of(const PageRun& page_run, std::size_t stride) {
  const RunWriter writer(stride);
  const RecordedRun& run = page_run.run;
  Json json{{"name", page_run.name},
            {"record", run.record},
            {"outcome", run.outcome},
            {"cause", run.cause},
            {"time", writer.floats(run.time)},
            {"items", Json::array()},
            {"room", room_of(run)},
            {"zones", zones_of(run)},
            {"tethers", tethers_of(run)},
            {"events", events_of(run)},
            {"floor", nullptr}};
  for (const RecordedItem& item : run.items) json["items"].push_back(json_of(item, writer));
  if (!run.floor_acceleration.empty())
    json["floor"] = {{"acceleration", writer.vectors(run.floor_acceleration)},
                     {"displacement", writer.vectors(run.floor_displacement)}};
  return json;
}

/// Runs without wheels, all but their poses and falls.
Json ghosts_json(const std::vector<PageRun>& ghosts, std::size_t most_bytes) {
  if (ghosts.empty()) return nullptr;
  std::vector<PageRun> bare;
  for (const PageRun& each : ghosts) bare.push_back({each.name, ghost_of(each.run)});
  const std::size_t every = stride(bare, most_bytes);
  const ThinningError error = thinning_error(bare, every);
  Json json{{"stride", every},
            {"position_error", error.position},
            {"angle_error", error.angle},
            {"runs", Json::array()}};
  for (const PageRun& each : bare) json["runs"].push_back(json_of(each, every));
  return json;
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

Channel quantised(const std::vector<double>& values, int bits) {
  const double largest = std::exp2(bits) - 1;
  double low = INFINITY, high = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  Channel channel{std::isfinite(low) ? low : 0, 0, bits, {}};
  const double step = (high - low) / largest;
  if (!(step > 0)) return channel;
  channel.step = step;
  std::vector<std::uint8_t> bytes;
  for (const double value : values) {
    const double number = std::isfinite(value) ? std::round((value - low) / step) : 0;
    const auto whole = static_cast<std::uint32_t>(std::clamp(number, 0.0, largest));
    bytes.push_back(static_cast<std::uint8_t>(whole & 255u));
    if (bits == 16) bytes.push_back(static_cast<std::uint8_t>(whole >> 8));
  }
  channel.data = base64(bytes);
  return channel;
}

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

std::size_t stride(const std::vector<PageRun>& runs, std::size_t most_bytes) {
  return base64_bytes(runs) / most_bytes + 1;
}

std::string page_data(const std::vector<PageRun>& runs, const std::vector<PageRun>& ghosts) {
  const std::size_t every = stride(runs, ghosts.empty() ? kMaxBytes : kMaxBytes / 2);
  Json json{{"title", runs.empty() ? "" : runs.front().run.title},
            {"stride", every},
            {"runs", Json::array()}};
  for (const PageRun& each : runs) json["runs"].push_back(json_of(each, every));
  json["ghosts"] = ghosts_json(ghosts, kMaxBytes - base64_bytes(runs) / every);
  return render::script_json(json);
}

}  // namespace gurney::playback
