#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "studies/workbench/answers.h"
#include "studies/workbench/wasm/files.h"

// What a page calls: it writes a question into the buffer, and reads the answer, JSON.
namespace {

using Json = nlohmann::json;

// NOLINTNEXTLINE: an archive of the shipped data, made by the build
constexpr char kData[] = {
#embed "data.tar"
};

std::string& buffer() {
  static std::string bytes;
  return bytes;
}

/// The text up to a mark, which is taken off with it.
std::string taken(std::string& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  std::string result = text.substr(0, end);
  text.erase(0, end + 1);
  return result;
}

Json answered(std::string question) {
  using namespace gurney::workbench;
  const std::string verb = taken(question, '\n');
  if (verb == "file") {
    const std::filesystem::path path = std::filesystem::path(kFolder) / taken(question, '\n');
    files()[path.lexically_normal().string()] = std::move(question);
    forget_files();
    return Json::object();
  }
  if (verb == "item" || verb == "outcome") {
    const std::string word = taken(question, '\n');
    return verb == "item" ? item_answer(word, question)
                          : outcome_answer(question, std::stoul(word));
  }
  if (verb == "case" || verb == "straps") {
    const std::size_t index = std::stoul(taken(question, '\n'));
    return verb == "case" ? case_answer(question, index) : straps_answer(question, index);
  }
  if (verb == "catalogue") return catalogue_answer();
  if (verb == "plan") return plan_answer(question);
  if (verb == "source") return source_answer(question);
  if (verb == "alternatives") return alternatives_answer(question);
  if (verb == "run") return run_answer(question);
  if (verb == "fragility") return fragility_answer(Json::parse(question));
  return {{"error", "unknown question: " + verb}};
}

}  // namespace

extern "C" {

char* gurney_buffer(std::size_t size) {
  buffer().resize(size);
  return buffer().data();
}

/// Answers what is in the buffer.
/// @returns the bytes of the answer, which is in the buffer then
std::size_t gurney_answer() {
  if (gurney::workbench::files().empty()) gurney::workbench::add_archive(kData, sizeof kData);
  Json answer;
  try {
    answer = answered(std::move(buffer()));
  } catch (const std::exception& error) {
    answer = {{"error", error.what()}};
  }
  buffer() = answer.dump(-1, ' ', false, Json::error_handler_t::replace);
  return buffer().size();
}

}  // extern "C"
