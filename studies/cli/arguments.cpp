#include "studies/cli/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/shell_word.h"
#include "engine/config/document.h"
#include "equipment/catalogue/catalogue.h"
#include "groundmotions/formats/format.h"

namespace gurney::cli {
namespace {

/// The signature of HDF5 (File Format Specification, section II.A).
bool is_hdf5(const std::string& path) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  std::array<char, kSignature.size()> start{};
  std::ifstream file(path, std::ios::binary);
  return file.read(start.data(), start.size()) &&
         std::string_view(start.data(), start.size()) == kSignature;
}

bool is_toml_or_json(const std::string& path) {
  try {
    config::Document unused(path);
  } catch (const Error&) {
    return false;
  }
  return true;
}

bool is_record(const std::string& path) {
  try {
    const groundmotions::SourceFile file(path);
    return std::ranges::any_of(groundmotions::formats(), [&](const groundmotions::Format& each) {
      return each.is_binary != file.is_text() && each.recognises(file);
    });
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::string data_file(equipment::DataKind kind, const std::string& name,
                      const std::string& option) {
  try {
    return equipment::find_data(kind, name, "");
  } catch (const Error& error) {
    throw Error(option + name + ": " + error.what());
  }
}

std::filesystem::path results_file(const std::filesystem::path& path) {
  require(path.extension() == ".h5",
          path.string() + ": the results file must end in .h5 (-o FILE.h5)");
  return path;
}

void require_job(const std::string& path, const std::string& command) {
  if (!is_file(path)) return;  // the reader of jobs states why
  const std::string name = shell_word(path);
  require(!is_hdf5(path),
          fmt::format("{}: is a results file; gurney {} takes a job. To see what it "
                      "holds: gurney show {}",
                      path, command, name));
  require(is_toml_or_json(path) || !is_record(path),
          fmt::format("{}: is the file of a record; gurney {} takes a job. To inspect it: gurney "
                      "records info {}; for a job that uses it: gurney new job NAME --record {}",
                      path, command, name, name));
}

}  // namespace gurney::cli
