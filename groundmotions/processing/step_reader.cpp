#include "groundmotions/processing/step_reader.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/processing/baseline.h"

namespace gurney::groundmotions {

namespace {

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

ProcessingStep read_high_pass(Table& in) {
  Butterworth filter;
  filter.high_pass = in.number("corner_hz", Range::positive());
  read_filter(in, filter);
  return filter;
}

ProcessingStep read_low_pass(Table& in) {
  Butterworth filter;
  filter.low_pass = in.number("corner_hz", Range::positive());
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
    {"high_pass", read_high_pass},
    {"low_pass", read_low_pass},
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

std::vector<ProcessingStep> read_processing_steps(Table& table, const std::string& key) {
  std::vector<ProcessingStep> steps;
  for (Table& in : table.tables(key))
    if (const Reader read = reader_of(in)) steps.push_back(read(in));
  return steps;
}

}  // namespace gurney::groundmotions
