#include "studies/results/hdf5_handle.h"

#include "engine/base/error.h"

namespace gurney::hdf5 {
namespace {

herr_t append_message(unsigned, const H5E_error2_t* error, void* text) {
  std::string& message = *static_cast<std::string*>(text);
  message += message.empty() ? "" : "; ";
  message += std::string(error->func_name) + ": " + error->desc;
  return 0;
}

}  // namespace

void fail(const std::string& what) {
  std::string stack;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, append_message, &stack);
  H5Eclear2(H5E_DEFAULT);
  throw Error("HDF5 cannot " + what + (stack.empty() ? "" : ": " + stack));
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
