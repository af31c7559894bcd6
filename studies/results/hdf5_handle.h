#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

/// For the files hdf5_*.cpp alone.
namespace gurney::hdf5 {

static_assert(std::is_same_v<hid_t, std::int64_t>);

/// @throws Error "HDF5 cannot WHAT: REASON", the reason being the system's or HDF5's own
[[noreturn]] void fail(const std::string& what);

/// Passes on what an HDF5 call returned unless it reports a failure (a negative number).
template <class Result>
Result checked(Result result, const std::string& what) {
  if (result < 0) fail(what);
  return result;
}

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle(hid_t id, const std::string& what) : id_(checked(id, what)) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
};

/// Before the first file: HDF5 prints nothing, leaves nothing to the end of the process and loads
/// no code of others (a results file needs no filter that is not in the library).
void prepare_library();

/// To be called before HDF5 is: where an allocation fails, HDF5 1.10 follows null pointers, damages
/// the heap, ends the process (H5I_register) or stores a chunk without its filters.
/// @param bytes  of the values that it is given or asked for
/// @throws std::bad_alloc
void require_memory(std::size_t bytes = 0);

/// Leaves the file open where HDF5 has no memory to close it.
void close_file(hid_t file) noexcept;

/// UTF-8 text.
/// @param width  bytes; H5T_VARIABLE: of any length
Handle text_type(std::size_t width = H5T_VARIABLE);

}  // namespace gurney::hdf5
