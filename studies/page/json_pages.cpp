#include "studies/page/json_pages.h"

#include <fstream>

#include "engine/base/error.h"
#include "engine/base/input_file.h"
#include "engine/base/printable.h"

namespace gurney::page {

bool is_json(const std::string& path) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  char first = 0;
  return file >> first && first == '{';
}

Document json_document(const std::string& path) {
  const config::JsonTree tree = config::read_json(read_input_file(path), path);
  const config::Node* const found = tree.root.find("schema");
  const std::string schema = found == nullptr ? "" : found->text;
  const JsonValue all(tree, path);
  if (schema == "gurney-calibration/1") return calibration_document(all);
  if (schema == "gurney-verification/1") return verification_document(all);
  throw Error(
      path + ": " +
      (schema.empty() ? "is JSON without a schema"
                      : "is JSON with schema = \"" + printable(schema) + "\"") +
      "; a report is made of a results file (HDF5), of calibration.json of gurney calibrate "
      "-o (\"gurney-calibration/1\"), or of what gurney verify --json prints "
      "(\"gurney-verification/1\")");
}

}  // namespace gurney::page
