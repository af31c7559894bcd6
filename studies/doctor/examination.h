#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gurney::doctor {

/// Checks of this machine, and whether the program can work on it.
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

/// Everything, in the order in which it is to be read.
std::vector<Finding> examination();

/// Version, commit and compiler.
Finding program();

/// Versions of the build; HDF5 is compared with the one that is loaded.
Finding libraries();

/// The catalogue: where it is, and whether every file of it can be read.
Finding data();

/// Whether figures can be written as PDF and PNG.
Finding figures();

Finding cpu();

/// @param hardware  threads that the system lets this process use
/// @param quota     of the control group, in CPUs; none: unlimited
Finding threads(unsigned hardware, std::optional<double> quota);
Finding threads();

/// @param available  of the machine and of the control group [bytes]; none: not known
Finding memory(std::optional<std::uint64_t> available);
Finding memory();

/// Space where results go by default: the current folder.
Finding disk(const std::filesystem::path& folder);

/// Rounding to nearest, and numbers below 1e-308 that are not taken for zero.
Finding arithmetic();

/// A small study, with one thread and with several: the same bits are to come out. The text has a
/// digest, which is equal on all machines with this build.
Finding determinism();

/// The verdict on the digests of two runs.
Finding same_bits(const std::string& with_one, const std::string& with_several, int threads,
                  std::size_t runs);

}  // namespace gurney::doctor
