#pragma once

#include <variant>

#include "groundmotions/processing/butterworth.h"
#include "groundmotions/processing/trim.h"

namespace gurney::groundmotions {

/// Processing steps of a record, with their parameters; docs/formats/processing.md. Butterworth is a
/// step as it is.

struct Baseline {
  enum class Kind { kMean, kLine, kPolynomial, kPreEventMean, kEndAtRest };
  Kind kind = Kind::kMean;
  int degree = 1;        ///< of kPolynomial 1..8, of kEndAtRest 1..4
  double pre_event = 0;  ///< of kPreEventMean > 0 [s]
};

struct Taper {
  double start = 0;       ///< >= 0
  double end = 0;         ///< >= 0
  bool fraction = false;  ///< start and end are shares of the record, not seconds
};

struct Resample {
  double time_step = 0;  ///< > 0 [s]
};

/// To the significant duration of the horizontals (of the vertical, if there are none), from the
/// earliest start to the latest end, with margins.
struct TrimToDuration {
  double from = 0.05, to = 0.95;  ///< shares of the Husid curve, 0 <= from < to <= 1
  double before = 0, after = 0;   ///< margins >= 0 [s]
  double taper = 0;               ///< of both new ends >= 0 [s]
};

struct TrimToWindow {
  TimeInterval window;
  double taper = 0;  ///< of both new ends >= 0 [s]
};

struct Rotate {
  enum class By { kAzimuthOfH1, kAngle, kStrike };
  By by = By::kAzimuthOfH1;
  double angle = 0;  ///< as rotate_to(), rotated_by() and rotate_to_fault() take it [rad]
};

using ProcessingStep =
    std::variant<Baseline, Taper, Butterworth, Resample, TrimToDuration, TrimToWindow, Rotate>;

}  // namespace gurney::groundmotions
