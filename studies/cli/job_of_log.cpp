#include "studies/cli/job_of_log.h"

#include <filesystem>

#include "engine/base/input_file.h"

namespace gurney::cli {

std::string job_of_log(const std::string& results) {
  const std::filesystem::path log = std::filesystem::path(results).replace_extension(".log");
  if (!std::filesystem::exists(log)) return {};
  static const std::string kWord = "\njob ";
  const std::string text = '\n' + read_input_file(log.string());
  const auto place = text.rfind(kWord);
  if (place == std::string::npos) return {};
  const auto start = text.find_first_not_of(' ', place + kWord.size());
  return text.substr(start, text.find('\n', start) - start);
}

}  // namespace gurney::cli
