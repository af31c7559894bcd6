#include "studies/cli/job_of_log.h"

#include <filesystem>

#include "engine/base/files.h"
#include "engine/base/input_file.h"

namespace gurney::cli {

namespace {

/// What follows the last `word` at the start of a line; empty where there is none.
std::string value_of(const std::string& text, const std::string& word) {
  const auto place = text.rfind('\n' + word + ' ');
  if (place == std::string::npos) return {};
  const auto start = text.find_first_not_of(' ', place + 1 + word.size());
  return text.substr(start, text.find('\n', start) - start);
}

}  // namespace

std::string job_of_log(const std::string& results) {
  namespace fs = std::filesystem;
  const fs::path log = fs::path(results).replace_extension(".log");
  if (!is_there(log)) return {};
  const std::string text = '\n' + read_input_file(log.string());
  const std::string job = value_of(text, "job");
  const fs::path from_its_folder = fs::path(value_of(text, "folder")) / job;
  return is_there(job) || !is_there(from_its_folder) ? job : from_its_folder.string();
}

std::string why_not_there(const std::string& path) {
  std::error_code problem;
  const bool there = std::filesystem::exists(path, problem);
  const bool gone = there || !problem || problem == std::errc::no_such_file_or_directory ||
                    problem == std::errc::not_a_directory;
  return gone ? "does not exist any more" : "cannot be read: " + problem.message();
}

}  // namespace gurney::cli
