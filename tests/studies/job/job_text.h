#pragma once

#include <string>

#include "studies/job/job.h"
#include "tests/support/error_text.h"

namespace gurney::study {

/// The job that this text is, as the file `a.toml`.
inline Job job_of_text(const std::string& text) {
  config::Document document(text, "a.toml");
  return read_job(document);
}

/// What `read_job` says of this text.
inline std::string errors_of_text(const std::string& text) {
  return error_text([&] { job_of_text(text); });
}

}  // namespace gurney::study
