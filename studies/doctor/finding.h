#pragma once

#include <string>
#include <vector>

namespace gurney::doctor {

/// What was looked at on this machine, and whether the program can work with it.
struct Finding {
  enum class State { kOk, kWarning, kProblem };
  State state = State::kOk;
  std::string name;    ///< "memory"
  std::string text;    ///< what was found
  std::string advice;  ///< what to do; empty: nothing
};
const char* name_of(Finding::State state);  ///< "ok", "warning", "problem"

Finding ok(std::string name, std::string text);
Finding warning(std::string name, std::string text, std::string advice);
Finding problem(std::string name, std::string text, std::string advice);

}  // namespace gurney::doctor
