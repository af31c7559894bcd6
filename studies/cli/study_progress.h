#pragma once

#include "studies/run/run_batch.h"

namespace gurney::cli {

/// Reports a study on its way on standard error: one line that is written over on a terminal;
/// elsewhere a line every ten seconds.
class StudyProgress {
 public:
  explicit StudyProgress(bool quiet);

  void operator()(const study::BatchProgress& now);

 private:
  bool quiet_, terminal_, complete_ = false;
  double shown_ = -10;
};

}  // namespace gurney::cli
