#include "groundmotions/suites/companions.h"

#include <array>
#include <set>
#include <string>
#include <utility>

#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::array kCompanions = {std::pair(".VT2", ".AT2"), std::pair(".DT2", ".AT2"),
                                    std::pair(".VEL", ".ACC"), std::pair(".DIS", ".ACC"),
                                    std::pair(".DSP", ".ACC"), std::pair(".DISP", ".ACC")};

std::string key_of(const std::filesystem::path& path) {
  return (path.parent_path() / upper(path.filename().string())).string();
}

/// The acceleration file beside a velocity or a displacement; empty if the name is of neither.
std::string acceleration_of(const std::filesystem::path& path) {
  const std::string name = upper(path.filename().string());
  for (const auto& [mark, other] : kCompanions) {
    const std::string text = mark;
    const auto at = name.rfind(text);
    if (at == std::string::npos) continue;
    const auto end = at + text.size();
    if (end < name.size() && name[end] != '.') continue;
    return (path.parent_path() / (name.substr(0, at) + other + name.substr(end))).string();
  }
  return {};
}

}  // namespace

std::size_t drop_companions(std::vector<std::filesystem::path>& files) {
  std::set<std::string> names;
  for (const auto& file : files) names.insert(key_of(file));
  return std::erase_if(files, [&](const auto& file) {
    const std::string acceleration = acceleration_of(file);
    return !acceleration.empty() && names.contains(acceleration);
  });
}

}  // namespace gurney::groundmotions
