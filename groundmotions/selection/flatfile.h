#pragma once

#include <Eigen/Core>

#include "groundmotions/formats/source_file.h"
#include "groundmotions/suites/suite.h"

namespace gurney::groundmotions {

/// Records of a flatfile with their spectra.
struct Flatfile {
  Suite suite;                 ///< the files may be absent; what is excluded is a note
  Eigen::MatrixXd ln_spectra;  ///< ln Sa, a row for each record, Sa in m/s2
};

/// Whether a file is a flatfile in the layout of NGA-West2: its header row has the columns `Record
/// Sequence Number` and spectra, such as `T0.010S`.
bool recognises_flatfile(const SourceFile& file);

/// A flatfile in the layout of NGA-West2 (Ancheta et al. 2014, Earthquake Spectra 30(3), 989-1005):
/// `Record Sequence Number`, `Earthquake Name`, `Station Name`, `File Name (Horizontal 1)` and so
/// on, `Lowest Usable Freq - Ave. Component (Hz)`, and Sa [g] at 5 % damping in `T0.010S` to
/// `T20.000S`. Which horizontal the spectra are of is that of the file (RotD50 is a file of its
/// own); between its periods they are straight in logarithms.
///
/// The files of a record are those that PEER's database delivers, in the folder of the flatfile:
/// `NORTHR\RRS228.AT2` of record 1063 is `RSN1063_NORTHR_RRS228.AT2`.
///
/// Records without a spectrum (-999) at the periods are excluded with one note.
/// @param periods  growing [s]
/// @throws Error for a missing column, a row of another length, a cell that is not a number, periods
///         beyond the columns, and a file without records.
Flatfile read_flatfile(const SourceFile& file, const Eigen::VectorXd& periods);

}  // namespace gurney::groundmotions
