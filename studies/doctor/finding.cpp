#include "studies/doctor/finding.h"

#include <utility>

namespace gurney::doctor {

const char* name_of(Finding::State state) {
  switch (state) {
    case Finding::State::kOk:
      return "ok";
    case Finding::State::kWarning:
      return "warning";
    case Finding::State::kProblem:
      break;
  }
  return "problem";
}

Finding ok(std::string name, std::string text) {
  return {Finding::State::kOk, std::move(name), std::move(text), {}};
}

Finding warning(std::string name, std::string text, std::string advice) {
  return {Finding::State::kWarning, std::move(name), std::move(text), std::move(advice)};
}

Finding problem(std::string name, std::string text, std::string advice) {
  return {Finding::State::kProblem, std::move(name), std::move(text), std::move(advice)};
}

}  // namespace gurney::doctor
