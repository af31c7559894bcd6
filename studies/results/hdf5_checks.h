#pragma once

#include <functional>
#include <string>

#include "studies/results/hdf5_handle.h"

/// Checks of a file of unknown origin before it is trusted. For the files hdf5_*.cpp alone.
namespace gurney::hdf5 {

/// @throws Error where the file has links that lead out of it or past its own tree
void refuse_links(hid_t file, const std::string& path);

/// @throws Error where a dataset's values stand in other files, or are more than its stored bytes
/// can hold
void check_storage(hid_t dataset, const std::string& name);

/// Reads in a child process first, as libhdf5 1.10 can crash over damaged files.
/// @throws Error of `read`, and where the child is killed by a crash or its limits of time and
/// memory
/// @throws std::bad_alloc where it needs more memory than this process may have
void probe(const std::string& path, const std::function<void()>& read);

/// Appended to a file's bytes: the SHA-256 of them all. HDF5 ignores what follows the end that it
/// knows, and cuts it off when it writes.
std::string seal_of(const std::string& path);
std::string seal_of_bytes(const std::string& bytes);

/// @returns whether the file has a seal
/// @throws Error where it has one and its bytes are others than those that were sealed
bool check_seal(const std::string& path);

}  // namespace gurney::hdf5
