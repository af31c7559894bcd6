#include "studies/results/hdf5_handle.h"

#include <algorithm>

#include "engine/base/error.h"
#include "engine/base/printable.h"

namespace gurney::hdf5 {
namespace {

constexpr std::size_t kLongestReason = 160;

/// The innermost of HDF5's messages; of one that quotes the operating system, what that says.
herr_t take_reason(unsigned, const H5E_error2_t* error, void* text) {
  std::string& reason = *static_cast<std::string*>(text);
  reason = error->desc;
  static const std::string kQuote = "error message = '";
  if (const auto quote = reason.find(kQuote); quote != std::string::npos) {
    reason.erase(0, quote + kQuote.size());
    reason.erase(std::min(reason.find('\''), reason.size()));
  }
  if (reason.size() > kLongestReason) reason.resize(kLongestReason);
  return 1;
}

}  // namespace

void fail(const std::string& what) {
  std::string stack;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_reason, &stack);
  H5Eclear2(H5E_DEFAULT);
  throw Error("HDF5 cannot " + what + (stack.empty() ? "" : ": " + printable(stack)));
}

void silence_printing() {
  H5dont_atexit();  // at exit HDF5 1.10 crashes over a file that the disk had no room for
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle text_type(std::size_t width) {
  Handle type(H5Tcopy(H5T_C_S1), "make a text type");
  checked(H5Tset_size(type, width), "make a text type");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  if (width != H5T_VARIABLE) checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "make a text type");
  return type;
}

}  // namespace gurney::hdf5
