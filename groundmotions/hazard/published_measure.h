#pragma once

#include <string>

namespace gurney::groundmotions {

/// The measure of a hazard that another program published, and the unit that it has there.
struct PublishedMeasure {
  std::string name;    ///< as name_of(Measure); empty: another measure
  std::string unit;    ///< "g" or "cm/s"
  double period = -1;  ///< of Sa [s]
};

/// @param imt  "PGA", "PGV" or "SA(0.2)" of OpenQuake, "SA0P2" of the USGS
PublishedMeasure published_measure(const std::string& imt);

}  // namespace gurney::groundmotions
