#include "studies/calibration/pulling/trial_job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/toml_string.h"
#include "engine/base/units.h"
#include "equipment/catalogue/catalogue.h"
#include "studies/calibration/pulling/simulated_trial.h"
#include "studies/calibration/trials/trial.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {
namespace {

constexpr double kStart = 0.5;  // of phase II in the job [s]

bool known(equipment::DataKind kind, const std::string& name) {
  const std::vector<std::string> names = equipment::catalogue_names(kind);
  return std::ranges::find(names, name) != names.end();
}

/// Why a trial cannot be repeated; empty: it can.
std::string obstacle(const MeasuredTrial& each) {
  const TrialSetup& setup = each.trial.setup;
  if (!each.fault.empty()) return each.fault;
  if (!each.phases) return "only its averages are known, a force history is needed";
  if (setup.item.empty()) return "no `item` is stated";
  if (setup.pull_point.empty()) return "no `pull_point_mm` is stated";
  return "";
}

struct ForceSamples {
  std::vector<std::string> time, force;

  void add(double at, double newton) {
    time.push_back(fmt::format("{:.6f}", at));
    force.push_back(fmt::format("{:.3f}", newton));
  }
};

/// An array of TOML; an inline table may break its line only inside of one.
std::string in_lines(const std::vector<std::string>& values) {
  constexpr std::size_t kInLine = 12;
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i % kInLine == 0 ? "\n  " : " ") + values[i] + (i + 1 < values.size() ? "," : "");
  return text + "]";
}

/// Phase II, which ends half way between the last sample under the force and the next.
ForceSamples samples_of(const MeasuredTrial& each) {
  const TrialSignals& s = each.trial.signals;
  const Phases& phases = *each.phases;
  const auto after = std::ranges::upper_bound(s.time, phases.start) - s.time.begin();
  const auto first = std::max<std::size_t>(static_cast<std::size_t>(after), 1);
  const double share = (phases.start - s.time[first - 1]) / (s.time[first] - s.time[first - 1]);
  ForceSamples samples;
  samples.add(kStart, s.force[first - 1] + share * (s.force[first] - s.force[first - 1]));
  std::size_t i = first;
  for (; i < s.time.size() && s.time[i] < phases.release; ++i)
    if (s.time[i] - phases.start > 1e-6) samples.add(kStart + s.time[i] - phases.start, s.force[i]);
  samples.add(kStart + phases.release - phases.start, s.force[i - 1]);
  return samples;
}

std::string level_text(const MeasuredTrial& each) {
  const TrialSetup& setup = each.trial.setup;
  std::string text = fmt::format("\n[study.factor.level.{}]\n", toml_string(each.trial.name));
  text += "item.equipment = " + toml_string(setup.item) + "\n";
  if (known(equipment::DataKind::kCaster, setup.caster))
    text += "item.casters = " + toml_string(setup.caster) + "\n";
  if (known(equipment::DataKind::kFloor, setup.floor))
    text += "floor.covering = " + toml_string(setup.floor) + "\n";
  if (setup.payload_count > 0)
    text += fmt::format("item.payloads.{} = {}\n", toml_string(setup.payload_name),
                        setup.payload_count);
  std::vector<double> degrees;
  for (const double heading : setup.headings) degrees.push_back(heading / kRadiansPerDegree);
  if (degrees.size() == 1)
    text += fmt::format("item.headings_deg = {:.10g}\n", degrees[0]);
  else if (!degrees.empty())
    text += fmt::format("item.headings_deg = [{:.10g}]\n", fmt::join(degrees, ", "));
  const ForceSamples samples = samples_of(each);
  const std::string point = fmt::format("[{:.10g}]", fmt::join(setup.pull_point, ", "));
  text += fmt::format(
      "excitation.force = [{{ name = {}, point_m = {}, direction = [1, 0, 0], time_s = {}, force_n "
      "= {} }}]\n",
      toml_string(each.trial.name), point, in_lines(samples.time), in_lines(samples.force));
  if (setup.string_tension > 0)
    text += fmt::format(
        "excitation.string_potentiometer = [{{ point_m = {}, direction = [-1, 0, 0], tension_n = "
        "{:.10g} }}]\n",
        point, setup.string_tension);
  return text;
}

std::string head(const std::string& name, const MeasuredTrial& first, double longest) {
  return fmt::format(
      R"(# Phases II and III of trials under their own measured force, for its measured duration (docs/pulling_tests.md). Phase II starts at
# {0:g} s; `gurney pulling RESULTS --measured TRIALS` compares the simulated motion with that of the trials.
schema = "gurney-job/1"
title = {1}

[item]
equipment = {2}

[settings]
time_step_s = 0.004166666666666667  # 1/240 s
duration_s = {3:.3f}

[output]
history_step_s = 0.008333333333333333  # 120 Hz

[study]

[study.keep]
histories = "all"
energy = true

[[study.factor]]
name = "trial"
)",
      kStart, toml_string("Driven by the measured force: " + name),
      toml_string(first.trial.setup.item), longest);
}

}  // namespace

TrialJob job_of_trials(const std::vector<MeasuredTrial>& trials, const std::string& name) {
  constexpr double kAfterStop = 1;  // the simulated trial may roll on for longer [s]
  TrialJob job;
  std::string levels;
  const MeasuredTrial* first = nullptr;
  double longest = 0;
  for (const MeasuredTrial& each : trials) {
    if (const std::string reason = obstacle(each); !reason.empty()) {
      job.left_out.push_back(each.trial.name + ": " + reason);
      continue;
    }
    if (first == nullptr) first = &each;
    longest =
        std::max(longest, kStart + 1.1 * (each.phases->stop - each.phases->start) + kAfterStop);
    levels += level_text(each);
  }
  if (first != nullptr) job.text = head(name, *first, longest) + levels;
  return job;
}

void export_trials(const std::string& path, const std::optional<std::uint64_t>& noise,
                   const study::TakeFile& take) {
  const study::StudyReader file(path);
  const std::string noisy =
      noise ? fmt::format("; synthetic noise of {:g} mm and {:g} N, seed {}",
                          kMillimetersPerMeter * kDisplacementNoise, kForceNoise, *noise)
            : "";
  for (const SimulatedTrial& each : simulated_trials(file, noise))
    take(each.trial.name + ".csv",
         trial_file_text(each.trial,
                         fmt::format("SYNTHETIC: run {} of job {} by gurney {}, not a measurement; "
                                     "{}; f_r of the input: {:.4f} N{}",
                                     each.run, file.text_attribute("job_name"),
                                     file.text_attribute("program_version"), each.configuration,
                                     each.theory.resistance, noisy)));
}

std::vector<std::string> export_trial_job(const std::string& path, const study::TakeFile& take) {
  const std::string name = (std::filesystem::path(path) / "").parent_path().stem().string();
  const TrialJob job = job_of_trials(measured_trials(path), name);
  std::string reasons;
  for (const std::string& each : job.left_out) reasons += "\n" + each;
  require(!job.text.empty(), path + ": no pull that can be repeated under its force" + reasons);
  take(study::plain_identifier(name, "trials") + ".toml", job.text);
  return job.left_out;
}

}  // namespace gurney::calibration
