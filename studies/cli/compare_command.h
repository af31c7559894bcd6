#pragma once

#include <string>
#include <vector>

namespace gurney {

struct CompareOptions {
  std::string a, b;            ///< results files of studies; b empty: two configurations of a
  std::string configurations;  ///< names, apart by a comma
  std::vector<std::string> demands;
  std::string measure;  ///< of the curves; empty: the studies' own
  std::string figure;   ///< an .svg file to draw; empty: none
  bool overwrite = false;
  bool json = false;
};

/// `gurney compare`: what differs between two studies, or two configurations of one.
/// @throws Error
int compare_command(const CompareOptions& options);

}  // namespace gurney
