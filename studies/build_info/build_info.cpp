#include "studies/build_info/build_info.h"

#include "git_commit.h"  // written by write_git_commit.cmake at every build

namespace gurney::build_info {

BuildInfo build_info() {
#ifdef __clang__
  const std::string compiler = "Clang " __clang_version__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return {GURNEY_VERSION, GURNEY_GIT_COMMIT, compiler, GURNEY_BULLET_PRECISION, GURNEY_CPU_CLASS};
}

std::string libraries() { return GURNEY_LIBRARIES; }

}  // namespace gurney::build_info
