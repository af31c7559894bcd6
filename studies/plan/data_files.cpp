#include "studies/plan/data_files.h"

#include <filesystem>

#include "engine/base/hash/sha256.h"
#include "equipment/catalogue/catalogue.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& path, const fs::path& beside) {
  const fs::path data = fs::absolute(equipment::data_folder()).lexically_normal();
  const fs::path in_catalogue = path.lexically_relative(data);
  const std::string from = in_catalogue.string();
  if (from.starts_with("equipment/") || from.starts_with("groundmotions/buildings/")) return from;
  return path.lexically_proximate(beside).string();
}

}  // namespace

std::map<std::string, std::string> data_files(const StudyJob& job) {
  const fs::path file = fs::absolute(job.file()).lexically_normal();
  std::map<std::string, std::string> hashes;
  for (const auto& [path, bytes] : job.files().files())
    if (path != file) hashes[name_of(path, file.parent_path())] = sha256(bytes);
  return hashes;
}

}  // namespace gurney::study
