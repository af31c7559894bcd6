#include "equipment/catalogue/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/config/file_snapshot.h"

namespace gurney::equipment {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;  // bytes of a binary STL

static_assert(std::endian::native == std::endian::little, "a binary STL is little-endian");

template <typename T>
T value_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

bool is_binary_stl(const std::string& bytes) {
  return bytes.size() >= kHeader &&
         bytes.size() == kHeader + kTriangle * std::size_t{value_at<std::uint32_t>(bytes, 80)};
}

MeshObject binary_stl(const std::string& path, const std::string& bytes) {
  MeshObject object;
  for (std::size_t triangle = kHeader; triangle < bytes.size(); triangle += kTriangle)
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // the normal comes first
      Vector3& point = object.points.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        point[static_cast<int>(k)] = value_at<float>(bytes, triangle + 12 * corner + 4 * k);
      require(point.allFinite(), fmt::format("{}: triangle {} has corners that are no numbers",
                                             path, (triangle - kHeader) / kTriangle + 1));
    }
  return object;
}

/// Takes the next word.
std::string_view word(std::string_view& line) {
  line = trimmed(line);
  const std::string_view taken = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(taken.size());
  return taken;
}

/// The lines of a text with their numbers.
template <typename Take>
void each_line(const std::string& text, Take take) {
  int number = 0;
  for (std::size_t from = 0; from < text.size();) {
    std::size_t to = text.find('\n', from);
    if (to == std::string::npos) to = text.size();
    std::string_view line(text.data() + from, to - from);
    if (line.ends_with('\r')) line.remove_suffix(1);
    take(line, ++number);
    from = to + 1;
  }
}

Vector3 three_numbers(std::string_view line, const std::string& where) {
  Vector3 point;
  std::string_view rest = line;
  for (int k = 0; k < 3; ++k) {
    rest = trimmed(rest);
    const auto value = take_number(rest);
    require(value.has_value(),
            fmt::format("{}: \"{}\": must be three numbers", where, trimmed(line)));
    point[k] = *value;
  }
  return point;
}

std::vector<MeshObject> ascii_stl(const std::string& path, const std::string& text) {
  std::vector<MeshObject> objects;
  each_line(text, [&](std::string_view line, int number) {
    const std::string_view first = word(line);
    if (first == "solid") {
      objects.push_back({std::string(trimmed(line)), {}});
    } else if (first == "vertex") {
      const std::string where = fmt::format("{}:{}", path, number);
      require(!objects.empty(), where + ": a vertex before the line \"solid\"");
      objects.back().points.push_back(three_numbers(line, where));
    }
  });
  return objects;
}

/// The corner that `1`, `-1`, `1/2` or `1//3` names.
std::size_t corner_of(std::string_view text, std::size_t count, const std::string& where) {
  const auto index = number(text.substr(0, text.find('/')));
  const double last = static_cast<double>(count);
  const double from_start = index ? (*index < 0 ? last + *index : *index - 1) : -1;
  require(from_start >= 0 && from_start < last && from_start == std::floor(from_start),
          fmt::format("{}: \"{}\": must be a vertex, 1 to {}", where, text, count));
  return static_cast<std::size_t>(from_start);
}

std::vector<MeshObject> obj(const std::string& path, const std::string& text) {
  std::vector<MeshObject> objects(1);
  std::vector<Vector3> vertices;
  each_line(text, [&](std::string_view line, int number) {
    const std::string where = fmt::format("{}:{}", path, number);
    const std::string_view first = word(line);
    if (first == "v") {
      vertices.push_back(three_numbers(line, where));
    } else if (first == "o" || first == "g") {
      objects.push_back({std::string(trimmed(line)), {}});
    } else if (first == "f") {
      for (std::string_view corner = word(line); !corner.empty(); corner = word(line))
        objects.back().points.push_back(vertices[corner_of(corner, vertices.size(), where)]);
    }
  });
  return objects;
}

}  // namespace

std::vector<MeshObject> read_mesh(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  require(ending == ".stl" || ending == ".obj", path + ": must be a mesh *.stl or *.obj");
  require(config::FileSnapshot::exists(path), "no such file: " + path);
  const std::string bytes = config::FileSnapshot::bytes_of(path);
  std::vector<MeshObject> objects;
  if (ending == ".obj") {
    objects = obj(path, bytes);
  } else if (is_binary_stl(bytes)) {
    objects = {binary_stl(path, bytes)};
  } else {
    require(
        trimmed(bytes).starts_with("solid"),
        path +
            ": is neither an ASCII STL, which begins with \"solid\", nor a binary one, whose size "
            "is 84 bytes and 50 for each triangle");
    objects = ascii_stl(path, bytes);
  }
  std::erase_if(objects, [](const MeshObject& object) { return object.points.empty(); });
  require(!objects.empty(), path + ": has no triangles");
  return objects;
}

}  // namespace gurney::equipment
