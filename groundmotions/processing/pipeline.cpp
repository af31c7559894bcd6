#include "groundmotions/processing/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/processing/baseline.h"
#include "groundmotions/processing/resample.h"
#include "groundmotions/processing/rotate.h"
#include "groundmotions/processing/trim.h"

namespace gurney::groundmotions {
namespace {

template <typename Action>
void for_each_component(Record& record, Action action) {
  for (auto& component : record.components)
    if (component) action(*component);
}

template <typename Function>
void change_samples(Record& record, Function function) {
  for_each_component(record,
                     [&](Component& each) { each.acceleration = function(each.acceleration); });
}

void move_start(Record& record, double seconds) {
  for_each_component(record, [&](Component& each) {
    if (each.start_time) *each.start_time += seconds;
  });
}

double duration(const Record& record) {
  return record.time_step() * static_cast<double>(record.samples() - 1);
}

/// Largest magnitudes at the end of a component.
EndMotion largest_residual(const Record& record) {
  EndMotion largest;
  for (const auto& component : record.components) {
    if (!component) continue;
    const EndMotion end = end_motion(component->time_step, component->acceleration);
    largest.velocity = std::max(largest.velocity, std::abs(end.velocity));
    largest.displacement = std::max(largest.displacement, std::abs(end.displacement));
  }
  return largest;
}

/// Carries a step out and describes it.
class Step {
 public:
  explicit Step(Record& record) : record_(record) {}

  std::string operator()(const Baseline& step) const {
    const double h = record_.time_step();
    switch (step.kind) {
      case Baseline::Kind::kMean:
        change_samples(record_, [](const auto& a) { return without_polynomial(a, 0); });
        return "mean removed";
      case Baseline::Kind::kLine:
        change_samples(record_, [](const auto& a) { return without_polynomial(a, 1); });
        return "least-squares line removed";
      case Baseline::Kind::kPolynomial:
        change_samples(record_, [&](const auto& a) { return without_polynomial(a, step.degree); });
        return fmt::format("least-squares polynomial of degree {} removed", step.degree);
      case Baseline::Kind::kPreEventMean:
        change_samples(record_,
                       [&](const auto& a) { return without_pre_event_mean(h, a, step.pre_event); });
        return fmt::format("mean of the first {:g} s removed", step.pre_event);
      case Baseline::Kind::kEndAtRest:
        change_samples(record_, [&](const auto& a) { return ending_at_rest(a, step.degree); });
        return fmt::format(
            "polynomial of degree {} removed so that velocity and displacement end at zero",
            step.degree);
    }
    return "";
  }

  std::string operator()(const Taper& step) const {
    const double unit = step.fraction ? duration(record_) : 1;
    const double start = step.start * unit, end = step.end * unit;
    taper(start, end);
    return fmt::format("cosine tapers of {:g} s at the start and {:g} s at the end", start, end);
  }

  std::string operator()(const Butterworth& step) const {
    const double h = record_.time_step();
    const double tapers = step.taper.value_or(kFilterTaper * duration(record_));
    const Eigen::Index pad = pad_samples(step, h);
    const double pad_time = h * static_cast<double>(pad);
    change_samples(record_, [&](const auto& a) { return filtered(step, h, a); });
    if (step.keep_pads) move_start(record_, -pad_time);
    std::string band;
    if (step.high_pass && step.low_pass)
      band = fmt::format("band-pass, {:g} to {:g} Hz", *step.high_pass, *step.low_pass);
    else
      band = fmt::format("{}-pass, {:g} Hz", step.high_pass ? "high" : "low",
                         step.high_pass ? *step.high_pass : step.low_pass.value_or(0));
    return fmt::format(
        "Butterworth {} (-6 dB), order {}, two passes, tapers of {:g} s, zero pads of {:g} s at "
        "both ends {}",
        band, step.order, tapers, pad_time,
        step.keep_pads ? fmt::format("kept: {} samples", record_.samples()) : "cut off again");
  }

  std::string operator()(const Resample& step) const {
    const double old = record_.time_step();
    const Eigen::Index samples = record_.samples();
    for_each_component(record_, [&](Component& each) {
      each.acceleration = resampled(old, each.acceleration, step.time_step);
      each.time_step = step.time_step;
    });
    return fmt::format(
        "resampled from {:g} s ({} samples) to {:g} s ({} samples), Kaiser-windowed sinc, 100 dB",
        old, samples, step.time_step, record_.samples());
  }

  std::string operator()(const TrimToDuration& step) const {
    require(step.before >= 0 && step.after >= 0,
            fmt::format("margins must be >= 0 s, got {:g} and {:g} s", step.before, step.after));
    const bool horizontals = record_[Direction::kH1] || record_[Direction::kH2];
    std::optional<TimeInterval> all;
    for (const Direction direction : kDirections) {
      const auto& component = record_[direction];
      if (!component || (horizontals && direction == Direction::kVertical)) continue;
      if (component->acceleration.isZero(0)) continue;
      const TimeInterval own =
          significant_interval(component->time_step, component->acceleration, step.from, step.to);
      all = all ? TimeInterval{std::min(all->from, own.from), std::max(all->to, own.to)} : own;
    }
    require(all.has_value(), "a motion that is all zero has no significant duration");
    const std::string kept = trim({all->from - step.before, all->to + step.after}, step.taper);
    return fmt::format(
        "trimmed to {:g} to {:g} % of the Husid curve of the {} ({:.4g} to {:.4g} s), margins of "
        "{:g} s before and {:g} s after: {}",
        100 * step.from, 100 * step.to, horizontals ? "horizontals" : "vertical", all->from,
        all->to, step.before, step.after, kept);
  }

  std::string operator()(const TrimToWindow& step) const {
    return fmt::format("trimmed to {:g} to {:g} s: {}", step.window.from, step.window.to,
                       trim(step.window, step.taper));
  }

  /// The rotations write their lines themselves.
  std::string operator()(const Rotate& step) const {
    const std::size_t own = record_.processing.size();
    switch (step.by) {
      case Rotate::By::kAzimuthOfH1:
        record_ = rotate_to(std::move(record_), step.angle);
        break;
      case Rotate::By::kAngle:
        record_ = rotated_by(std::move(record_), step.angle);
        break;
      case Rotate::By::kStrike:
        record_ = rotate_to_fault(std::move(record_), step.angle);
        break;
    }
    std::string line;
    for (std::size_t i = own; i < record_.processing.size(); ++i)
      line += (line.empty() ? "" : "; ") + record_.processing[i];
    record_.processing.resize(own);
    return line;
  }

 private:
  void taper(double start, double end) const {
    const double h = record_.time_step();
    change_samples(record_, [&](const auto& a) { return tapered(h, a, start, end); });
  }

  std::string trim(const TimeInterval& interval, double tapers) const {
    const double h = record_.time_step(), whole = duration(record_);
    const SampleRange range = samples_within(interval, h, record_.samples());
    const double speed = speed_at_ends(range);
    if (!(speed <= kVisibleVelocity))
      record_.warnings.push_back(fmt::format(
          "processing: cut at {:g} and {:g} s, where the floor moves at up to {:.2g} m/s "
          "along a component; keep more before or after",
          h * static_cast<double>(range.first),
          h * static_cast<double>(range.first + range.count - 1), speed));
    change_samples(record_,
                   [&](const auto& a) { return a.segment(range.first, range.count).eval(); });
    taper(tapers, tapers);
    const double first = h * static_cast<double>(range.first);
    move_start(record_, first);
    return fmt::format("{:g} to {:g} s of {:g} s kept, up to {:.2g} m/s at the cuts{}", first,
                       first + duration(record_), whole, speed,
                       tapers > 0 ? fmt::format(", cosine tapers of {:g} s", tapers) : "");
  }

  /// Largest speed of a component at the first and the last sample of a range.
  double speed_at_ends(const SampleRange& range) const {
    double speed = 0;
    for_each_component(record_, [&](const Component& each) {
      const Eigen::VectorXd v = integrated(each.time_step, each.acceleration).velocity;
      speed =
          std::max({speed, std::abs(v[range.first]), std::abs(v[range.first + range.count - 1])});
    });
    return speed;
  }

  Record& record_;
};

/// As docs/formats/processing.md calls it.
const char* name_of(const ProcessingStep& step) {
  static constexpr std::array kNames = {"baseline", "taper",  "band_pass", "resample",
                                        "trim",     "window", "rotate"};
  static_assert(kNames.size() == std::variant_size_v<ProcessingStep>);
  const auto* filter = std::get_if<Butterworth>(&step);
  if (filter != nullptr && !filter->low_pass) return "high_pass";
  if (filter != nullptr && !filter->high_pass) return "low_pass";
  return kNames[step.index()];
}

bool ends_at_rest(const ProcessingStep& step) {
  const auto* baseline = std::get_if<Baseline>(&step);
  return baseline != nullptr && baseline->kind == Baseline::Kind::kEndAtRest;
}

void warn_of_order(const std::vector<ProcessingStep>& steps, Record& record) {
  const auto rest = std::find_if(steps.rbegin(), steps.rend(), ends_at_rest);
  for (auto later = rest.base(); rest != steps.rend() && later != steps.end(); ++later)
    if (!std::holds_alternative<Rotate>(*later))
      record.warnings.push_back(
          fmt::format("processing: step {} ({}) comes after end_at_rest and can bring velocity and "
                      "displacement at the end back; make end_at_rest the last step",
                      later - steps.begin() + 1, name_of(*later)));
}

using config::Range;
using config::Table;

ProcessingStep read_baseline(Table& in) {
  static const std::vector<std::string> kKinds = {"mean", "line", "polynomial", "pre_event_mean",
                                                  "end_at_rest"};
  Baseline step;
  step.kind = static_cast<Baseline::Kind>(in.choice("kind", kKinds));
  if (step.kind == Baseline::Kind::kPolynomial)
    step.degree = in.integer("degree", 1, kHighestBaselineDegree);
  if (step.kind == Baseline::Kind::kEndAtRest)
    step.degree = in.integer("degree", 1, kHighestRestDegree, step.degree);
  if (step.kind == Baseline::Kind::kPreEventMean)
    step.pre_event = in.number("pre_event_s", Range::positive());
  return step;
}

ProcessingStep read_taper(Table& in) {
  const bool seconds = in.has("start_s") || in.has("end_s");
  const bool fractions = in.has("start_fraction") || in.has("end_fraction");
  for (const char* key : {"end_s", "end_fraction"}) in.has(key);
  if (seconds == fractions)
    in.note("step",
            " = \"taper\": must have start_s and end_s or one of them, or start_fraction and "
            "end_fraction or one of them");
  const Range range = fractions ? Range::within(0, 1) : Range::not_negative();
  return Taper{in.number(fractions ? "start_fraction" : "start_s", range, 0.0),
               in.number(fractions ? "end_fraction" : "end_s", range, 0.0), fractions};
}

void read_filter(Table& in, Butterworth& filter) {
  filter.order = in.integer("order", 1, kHighestOrder, filter.order);
  filter.keep_pads = in.boolean("keep_pads", filter.keep_pads);
  if (in.has("taper_s")) filter.taper = in.number("taper_s", Range::not_negative());
}

template <auto kCorner>
ProcessingStep read_pass(Table& in) {
  Butterworth filter;
  filter.*kCorner = in.number("corner_hz", Range::positive());
  read_filter(in, filter);
  return filter;
}

ProcessingStep read_band_pass(Table& in) {
  Butterworth filter;
  const std::vector<double> corners = in.numbers("corners_hz", Range::positive(), 2);
  filter.high_pass = corners[0];
  filter.low_pass = corners[1];
  if (corners[0] > 0 && corners[1] > 0 && !(corners[0] < corners[1]))
    in.note("corners_hz", fmt::format(" = [{:g}, {:g}]: the first must be less than the second",
                                      corners[0], corners[1]));
  read_filter(in, filter);
  return filter;
}

ProcessingStep read_resample(Table& in) {
  return Resample{in.number("time_step_s", Range::within(0, 1).open_below())};
}

ProcessingStep read_trim(Table& in) {
  TrimToDuration step;
  step.from = in.number("from_fraction", Range::within(0, 1), step.from);
  step.to = in.number("to_fraction", Range::within(0, 1), step.to);
  if (!(step.from < step.to))
    in.note("to_fraction",
            fmt::format(" = {:g}: must be more than from_fraction, {:g}", step.to, step.from));
  step.before = in.number("before_s", Range::not_negative(), step.before);
  step.after = in.number("after_s", Range::not_negative(), step.after);
  step.taper = in.number("taper_s", Range::not_negative(), step.taper);
  return step;
}

ProcessingStep read_window(Table& in) {
  TrimToWindow step;
  step.window.from = in.number("from_s", Range::not_negative());
  step.window.to = in.number("to_s", Range::more_than(step.window.from));
  step.taper = in.number("taper_s", Range::not_negative(), step.taper);
  return step;
}

ProcessingStep read_rotate(Table& in) {
  static constexpr std::array kKeys = {"azimuth_deg", "angle_deg", "strike_deg"};  // as Rotate::By
  Rotate step;
  int given = 0;
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    if (!in.has(kKeys[i])) continue;
    step.by = static_cast<Rotate::By>(i);
    step.angle = in.number(kKeys[i], Range::any()) * kRadiansPerDegree;
    ++given;
  }
  if (given != 1)
    in.note("step", " = \"rotate\": must have one of azimuth_deg, angle_deg and strike_deg");
  return step;
}

using Reader = ProcessingStep (*)(Table&);
constexpr std::array<std::pair<const char*, Reader>, 9> kReaders = {{
    {"baseline", read_baseline},
    {"taper", read_taper},
    {"high_pass", read_pass<&Butterworth::high_pass>},
    {"low_pass", read_pass<&Butterworth::low_pass>},
    {"band_pass", read_band_pass},
    {"resample", read_resample},
    {"trim", read_trim},
    {"window", read_window},
    {"rotate", read_rotate},
}};

Reader reader_of(Table& in) {
  const std::string name = in.text("step");
  std::vector<std::string> known;
  for (const auto& [each, reader] : kReaders) {
    if (name == each) return reader;
    known.push_back(each);
  }
  if (in.is_text("step"))
    in.note("step",
            fmt::format(" = \"{}\": unknown step{}", name, config::suggestion(name, known)));
  for (const std::string& key : in.keys()) in.has(key);  // whose they are is not known
  return nullptr;
}

}  // namespace

Record processed(Record record, const std::vector<ProcessingStep>& steps) {
  if (steps.empty()) return record;
  require(record.samples() >= 2, fmt::format("record '{}' has no samples to process", record.name));
  const std::string name = record.name;
  warn_of_order(steps, record);
  EndMotion before = largest_residual(record);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::string line;
    try {
      line = std::visit(Step(record), steps[i]);
    } catch (const Error& error) {
      throw Error(fmt::format("record '{}', step {} ({}): {}", name, i + 1, name_of(steps[i]),
                              error.what()));
    }
    const EndMotion after = largest_residual(record);
    record.processing.push_back(fmt::format(
        "{}; residual velocity {:.2g} -> {:.2g} m/s, displacement {:.2g} -> {:.2g} m", line,
        before.velocity, after.velocity, before.displacement, after.displacement));
    before = after;
  }
  return record;
}

std::vector<ProcessingStep> read_processing_steps(Table& table, const std::string& key) {
  std::vector<ProcessingStep> steps;
  for (Table& in : table.tables(key))
    if (const Reader read = reader_of(in)) steps.push_back(read(in));
  return steps;
}

}  // namespace gurney::groundmotions
