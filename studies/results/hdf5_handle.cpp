#include "studies/results/hdf5_handle.h"

#include <new>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/memory.h"
#include "engine/base/printable.h"

namespace gurney::hdf5 {
namespace {

herr_t collect_message(unsigned, const H5E_error2_t* error, void* messages) {
  static_cast<std::vector<std::string>*>(messages)->push_back(error->desc ? error->desc : "");
  return 0;
}

/// The system's reason if HDF5 quotes one, else the innermost message. HDF5's whole stack has
/// addresses and up to 4 kB.
std::string reason_in(const std::vector<std::string>& messages) {
  static const std::string kQuote = "error message = '";
  for (const std::string& message : messages) {
    const auto at = message.find(kQuote);
    if (at == std::string::npos) continue;
    const auto start = at + kQuote.size();
    return message.substr(start, message.find('\'', start) - start);
  }
  constexpr std::size_t kLongestReason = 160;
  return messages.empty() ? "" : messages.front().substr(0, kLongestReason);
}

constexpr std::size_t kCopies = 3;  // of values: as they are, shuffled, compressed

}  // namespace

void require_memory(std::size_t bytes) {
  // The library itself took 11 MB at most while results were written, and 9 MB while they were
  // read.
  constexpr std::size_t kLibrary = 16 << 20;
  gurney::require_memory(kLibrary + kCopies * bytes);
}

void close_file(hid_t file) noexcept {
  try {
    require_memory();
    H5Fclose(file);
  } catch (const std::bad_alloc&) {
  }
}

void fail(const std::string& what) {
  std::vector<std::string> messages;  // from the innermost function outwards
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect_message, &messages);
  H5Eclear2(H5E_DEFAULT);
  const std::string reason = reason_in(messages);
  throw Error("HDF5 cannot " + what + (reason.empty() ? "" : ": " + printable(reason)));
}

void prepare_library() {
  H5dont_atexit();  // at exit HDF5 1.10 crashes over a file that the disk had no room for
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

Handle text_type(std::size_t width) {
  Handle type(H5Tcopy(H5T_C_S1), "make a text type");
  checked(H5Tset_size(type, width), "make a text type");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  if (width != H5T_VARIABLE) checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "make a text type");
  return type;
}

}  // namespace gurney::hdf5
