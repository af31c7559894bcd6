#include <bit>
#include <nlohmann/json.hpp>

#include "studies/playback/channel.h"
#include "studies/playback/ghosts.h"
#include "studies/playback/page.h"

namespace gurney::playback {
namespace {

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
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string escaped;
  for (const char c : text)
    if (c == '<')
      escaped += "\\u003c";
    else
      escaped += c;
  return escaped;
}

}  // namespace gurney::playback
