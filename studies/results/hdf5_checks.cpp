#include "studies/results/hdf5_checks.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/hash/sha256_of_file.h"

namespace gurney::hdf5 {
namespace {

constexpr std::string_view kWord = "\ngurney sha256 ";
constexpr std::size_t kLength = kWord.size() + 64 + 1;  // with its line end

std::string with_word(const std::string& sum) { return std::string(kWord) + sum + "\n"; }

/// The last bytes of a file, as many as a seal has; empty: it has fewer.
std::string end_of(const std::string& path, std::uintmax_t size) {
  if (size < kLength) return {};
  std::string bytes(kLength, '\0');
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(size - kLength));
  require(bool(file.read(bytes.data(), kLength)), path + ": cannot be read");
  return bytes;
}

}  // namespace

std::string seal_of(const std::string& path) {
  return with_word(sha256_of_file(path, std::filesystem::file_size(path)));
}

std::string seal_of_bytes(const std::string& bytes) { return with_word(sha256(bytes)); }

bool check_seal(const std::string& path) {
  const std::uintmax_t size = std::filesystem::file_size(path);
  const std::string end = end_of(path, size);
  if (!end.starts_with(kWord)) return false;
  require(end == with_word(sha256_of_file(path, size - kLength)),
          path + ": is damaged: its bytes are not those that were written (its SHA-256 differs)");
  return true;
}

namespace {

enum Exit { kRead = 0, kRefused = 1, kTooLarge = 2 };

double largest_data(double file_size) { return 2e9 + 20 * file_size; }

/// Whether this process may take less than its child did.
bool is_limited(double file_size) {
  for (const int what : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limits;
    if (::getrlimit(static_cast<__rlimit_resource>(what), &limits) == 0 &&
        static_cast<double>(limits.rlim_cur) < largest_data(file_size))
      return true;
  }
  return false;
}

void limit(int what, double most) {
  rlimit limits;
  if (::getrlimit(static_cast<__rlimit_resource>(what), &limits) != 0) return;
  limits.rlim_cur = std::min(limits.rlim_max, static_cast<rlim_t>(most));
  ::setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

/// A crash of the child is no news for the terminal, and leaves no core.
void prepare_child(double file_size) {
  for (const int signal : {SIGINT, SIGTERM, SIGALRM}) std::signal(signal, SIG_DFL);
  if (const int null = ::open("/dev/null", O_RDWR); null >= 0)
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
  limit(RLIMIT_CORE, 0);
  // Some hundred times what a file of this program takes, for emulators and debugging allocators.
  const double seconds = 30 + file_size / 2e5;
  limit(RLIMIT_CPU, seconds);
  ::alarm(static_cast<unsigned>(std::min(20 * seconds, 1e6)));
  limit(RLIMIT_DATA, largest_data(file_size));
}

/// @param out  takes the error
[[noreturn]] void run_child(double file_size, const std::function<void()>& read, int out) {
  int code = kRead;
  try {
    prepare_child(file_size);
    read();
  } catch (const std::bad_alloc&) {
    code = kTooLarge;
  } catch (const std::exception& error) {
    code = kRefused;
    const std::string text = error.what();
    if (::write(out, text.data(), text.size()) < 0) code = kTooLarge;
  }
  ::_exit(code);
}

std::string all_of(int in) {
  std::string text;
  char some[512];
  for (ssize_t got = 0; (got = ::read(in, some, sizeof some)) != 0;) {
    if (got > 0) text.append(some, static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) break;
  }
  return text;
}

}  // namespace

void probe(const std::string& path, const std::function<void()>& read) {
  std::error_code ignored;
  const auto size = static_cast<double>(std::filesystem::file_size(path, ignored));
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return;  // no process to spare: as without a probe
  const pid_t child = ::fork();
  if (child == 0) run_child(size, read, ends[1]);
  ::close(ends[1]);
  const std::string error = child < 0 ? "" : all_of(ends[0]);
  ::close(ends[0]);
  if (child < 0) return;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  require(code != kRefused, error);
  if (code == kTooLarge && is_limited(size)) throw std::bad_alloc();
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  require(signal != SIGXCPU && signal != SIGALRM,
          path + ": took too long to read for a file of its size");
  require(code != kTooLarge,
          path + ": is damaged: to read it takes more memory than its size can ask for");
  require(code == kRead, path + ": is damaged: the HDF5 library crashes over it");
}

namespace {

/// Deflate makes 1032 bytes of one at most (RFC 1951: 258 bytes of 2 bits).
constexpr double kMaxInflation = 1032;
constexpr double kSmall = 4096;  // [bytes] are always allowed

herr_t take_soft_link(hid_t, const char* name, const H5L_info_t* info, void* found) {
  if (info->type == H5L_TYPE_HARD) return 0;
  *static_cast<std::string*>(found) = name;
  return 1;
}

}  // namespace

void refuse_links(hid_t file, const std::string& path) {
  std::string found;
  checked(H5Lvisit(file, H5_INDEX_NAME, H5_ITER_INC, take_soft_link, &found), "list " + path);
  require(found.empty(),
          fmt::format("{}: /{} is a link to elsewhere; a results file has none", path, found));
}

void check_storage(hid_t dataset, const std::string& name) {
  const Handle creation(H5Dget_create_plist(dataset), "read how " + name + " is stored");
  const H5D_layout_t layout = H5Pget_layout(creation);
  require(
      layout != H5D_VIRTUAL && (layout != H5D_CONTIGUOUS || H5Pget_external_count(creation) == 0),
      name + ": its values stand in other files; those of a results file stand in itself");
  const Handle space(H5Dget_space(dataset), "read the shape of " + name);
  const Handle type(H5Dget_type(dataset), "read the type of " + name);
  hsize_t extent[H5S_MAX_RANK];
  const int rank = checked(H5Sget_simple_extent_dims(space, extent, nullptr), "size " + name);
  double values = H5Sget_simple_extent_type(space) == H5S_NULL ? 0 : 1;
  for (int i = 0; i < rank; ++i) values *= static_cast<double>(extent[i]);
  const double bytes = values * static_cast<double>(H5Tget_size(type));
  const auto stored = static_cast<double>(H5Dget_storage_size(dataset));
  require(bytes <= kMaxInflation * stored + (stored > 0 ? kSmall : 0),
          fmt::format("{}: states {:.0f} values, but only {:.0f} bytes of them are in the file",
                      name, values, stored));
}

}  // namespace gurney::hdf5
