#pragma once

#include <string>

namespace gurney::build_info {

/// Source and tools of this build. Results carry it, so that a number can be traced to its code.
struct BuildInfo {
  std::string program_version;   ///< of the project, such as "0.1.0"
  std::string git_commit;        ///< 40 digits; "+changes" follows for modified sources
  std::string compiler;          ///< name and version
  std::string bullet_precision;  ///< "double"
  std::string cpu_class;         ///< what -march was, or "generic" and the machine
};

BuildInfo build_info();

/// Names and versions of the libraries this program was built with: "Boost 1.74.0, Bullet 3.24, ..."
std::string libraries();

}  // namespace gurney::build_info
