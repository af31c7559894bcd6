#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/number_text.h"

namespace gurney::cli {

/// Declares the options and arguments of one command, each once: the parser, the help, the manual page
/// and the completion of shells know them from here.
class Options {
 public:
  explicit Options(CLI::App& command) : command_(command) {}

  /// @param names  "JOB" of an argument, "-j,--threads" of an option; a name of its value follows
  ///               unless NUMBER or NAME fits, as in "-o,--output FILE". An option of bool is a flag.
  template <class T>
  CLI::Option* operator()(const std::string& names, T& value, const std::string& help) {
    if constexpr (std::is_same_v<T, bool>)
      return command_.add_flag(names, value, help);
    else
      return named(not_empty(finite<T>(
                       without_sign<T>(command_.add_option(only_names(names), value, help)))),
                   names, is_number(value));
  }

  /// An option whose value is handed to `take`.
  template <class T>
  CLI::Option* calling(const std::string& names, std::function<void(const T&)> take,
                       const std::string& help) {
    CLI::Option* const option =
        command_.add_option_function<T>(only_names(names), std::move(take), help);
    return named(not_empty(option), names, std::is_arithmetic_v<T>);
  }

  template <class T>
  CLI::Option* required(const std::string& names, T& value, const std::string& help) {
    return (*this)(names, value, help)->required();
  }

  /// An option for several values that is repeated for each, so that arguments may follow.
  template <class T>
  CLI::Option* single(const std::string& names, T& value, const std::string& help) {
    return (*this)(names, value, help)->allow_extra_args(false);
  }

  CLI::Option* threads(int& threads, const std::string& help) {
    return (*this)("-j,--threads", threads, help)->check(whole_number(1, 4096));
  }

  /// A check of an option: a whole number from one to another.
  static std::function<std::string(const std::string&)> whole_number(int low, int high);

  /// The same: one of some names, with the nearest to one that is not.
  static CLI::Validator one_of(const std::vector<std::string>& names);

  /// A check of an option: a number above 0.
  static std::function<std::string(const std::string&)> positive() {
    return [](const std::string& text) {
      return number(text).value_or(0) > 0 ? std::string() : text + ": must be a number > 0";
    };
  }

  /// The same: 0 or above.
  static std::function<std::string(const std::string&)> not_negative() {
    return [](const std::string& text) {
      return number(text).value_or(-1) >= 0 ? std::string() : text + ": must be a number >= 0";
    };
  }

  const CLI::App& program() const { return *command_.get_parent(); }

 private:
  static std::string only_names(const std::string& names) {
    return names.substr(0, names.find(' '));
  }
  static CLI::Option* named(CLI::Option* option, const std::string& names, bool number);
  /// Refuses an empty value of an option, which CLI11 takes for 0 or for an option that is not given.
  static CLI::Option* not_empty(CLI::Option* option);
  /// Refuses `-1` for an unsigned number, which CLI11 takes for 2^64 - 1.
  template <class T>
  static CLI::Option* without_sign(CLI::Option* option) {
    if constexpr (std::is_unsigned_v<T> || std::is_same_v<T, std::optional<std::size_t>> ||
                  std::is_same_v<T, std::vector<std::size_t>>)
      option->check(std::function<std::string(const std::string&)>([](const std::string& text) {
        return text.starts_with('-') ? text + ": must be a whole number, 0 or more" : std::string();
      }));
    return option;
  }
  /// Refuses `nan` and `inf`, which CLI11 takes for numbers within any range.
  template <class T>
  static CLI::Option* finite(CLI::Option* option) {
    if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, std::optional<double>> ||
                  std::is_same_v<T, std::vector<double>>)
      option->check(std::function<std::string(const std::string&)>([](const std::string& text) {
        return std::isfinite(std::strtod(text.c_str(), nullptr))
                   ? std::string()
                   : text + ": must be a finite number";
      }));
    return option;
  }
  template <class T>
  static constexpr bool is_number(const T&) {
    return std::is_arithmetic_v<T>;
  }
  template <class T>
  static constexpr bool is_number(const std::vector<T>&) {
    return std::is_arithmetic_v<T>;
  }
  template <class T>
  static constexpr bool is_number(const std::optional<T>&) {
    return std::is_arithmetic_v<T>;
  }

  CLI::App& command_;
};

/// Error of a command line, whatever its files hold: exit code 2.
class BadUsage : public Error {
  using Error::Error;
};

/// @throws BadUsage unless a condition holds
inline void require_usage(bool condition, const std::string& message) {
  if (!condition) throw BadUsage(message);
}

/// The result of a function of a value on the command line. @throws BadUsage for its Error
template <class Of>
auto from_usage(Of of, const std::string& before = "") {
  try {
    return of();
  } catch (const Error& error) {
    throw BadUsage(before + error.what());
  }
}

struct CommandText {
  const char *name, *description, *examples;  ///< examples: one a line
};

/// The commands below the program, or below a command such as `gurney records`.
class Commands {
 public:
  /// @param action  set to what the chosen command does, which returns the exit code and throws Error
  ///                for bad input
  Commands(CLI::App& app, std::function<int()>& action) : app_(app), action_(action) {}

  /// Adds a command that runs with the values of its options.
  template <class Values>
  void add(const CommandText& text, int (*run)(const Values&), void (*declare)(Options&, Values&)) {
    CLI::App& command = begin(text);
    auto values = std::make_shared<Values>();
    Options options(command);
    declare(options, *values);
    command.callback(
        [values, run, &action = action_] { action = [values, run] { return run(*values); }; });
  }

  /// Adds a command that has commands below it.
  Commands below(const CommandText& text);

  /// Title in the help under which the commands stand that are added next.
  void set_title(const std::string& title) { title_ = title; }

 private:
  CLI::App& begin(const CommandText& text);

  CLI::App& app_;
  std::function<int()>& action_;
  std::string title_ = "Commands";
};

/// Each adds one command.
using AddCommand = void(Commands& commands);

AddCommand add_calibrate;    ///< caster constants from pull and impact tests
AddCommand add_check;        ///< reads a job with all it names and prints what would run
AddCommand add_compare;      ///< configurations, pairwise
AddCommand add_completion;   ///< scripts for bash and zsh
AddCommand add_converge;     ///< of a job with the time step and the solver
AddCommand add_doctor;       ///< whether the program works on this machine
AddCommand add_equipment;    ///< ls, show, check
AddCommand add_explain;      ///< why a run ended as it did
AddCommand add_export;       ///< results for other programs
AddCommand add_fragility;    ///< curves and bands of a study
AddCommand add_hospital;     ///< services of a hospital, and what to secure first
AddCommand add_loss;         ///< cost, time and injuries that follow from the runs of a study
AddCommand add_measures;     ///< efficiency and sufficiency of intensity measures
AddCommand add_merge;        ///< the shards of a study into its results
AddCommand add_play;         ///< a page that plays a run back
AddCommand add_new;          ///< files to begin with
AddCommand add_plot;         ///< figures of a results file
AddCommand add_pulling;      ///< simulated pulling tests and their figures
AddCommand add_records;      ///< and its commands
AddCommand add_replay;       ///< one run of a study with full output
AddCommand add_report;       ///< a results file as one HTML page
AddCommand add_run;          ///< a single run or a study
AddCommand add_sensitivity;  ///< of a demand to the uncertain parameters
AddCommand add_show;         ///< what a results file holds
AddCommand add_status;       ///< of shards while they run
AddCommand add_submit;       ///< writes a script for a scheduler
AddCommand add_verify;       ///< the engine against closed-form solutions
AddCommand add_workbench;    ///< the page that runs jobs in a browser

AddCommand add_records_convert;  ///< to Gurney's CSV or to AT2, processed on the way
AddCommand add_records_floor;    ///< floor motions of a building
AddCommand add_records_info;     ///< peaks, durations and measures
AddCommand add_records_make;     ///< synthetic motions
AddCommand add_records_model;    ///< a published ground-motion model
AddCommand add_records_plot;     ///< histories and spectra
AddCommand add_records_scale;    ///< factors to a measure or a target spectrum
AddCommand add_records_select;   ///< records whose spectra match a target's mean and variance

}  // namespace gurney::cli
