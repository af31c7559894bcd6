#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <new>

#include "studies/results/growing_table.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/hdf5_writer.h"
#include "studies/results/results_file.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temp_folder.h"

#if defined(GURNEY_SANITIZED)
#define GURNEY_HAS_SHADOW_MEMORY 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define GURNEY_HAS_SHADOW_MEMORY 1
#endif
#endif

/// HDF5 1.10 crashes, or writes something else, where an allocation of its own fails.
namespace gurney::study {
namespace {

constexpr int kDone = 0, kNoMemory = 1, kWrong = 2;

rlim_t address_space() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

/// The status of a child that may take so many bytes more than it has.
int status_with(rlim_t extra, const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::malloc_trim(0);  // what the tests before this one gave back
    const rlimit core{0, 0}, memory{address_space() + extra, RLIM_INFINITY};
    ::setrlimit(RLIMIT_CORE, &core);
    ::setrlimit(RLIMIT_AS, &memory);
    int code = kWrong;
    try {
      code = work();
    } catch (const std::bad_alloc&) {
      code = kNoMemory;
    } catch (const std::exception&) {
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// Whatever the memory, the work is done, or it ends with std::bad_alloc; both happen.
void expect_done_or_no_memory(const std::function<int()>& work) {
#ifdef GURNEY_HAS_SHADOW_MEMORY
  GTEST_SKIP() << "limits of memory: AddressSanitizer takes terabytes of address space";
#endif
  constexpr rlim_t kMost = 32 << 20, kStep = 320 << 10;
  bool done = false, refused = false;
  for (rlim_t extra = 0; extra < kMost; extra += kStep) {
    const int status = status_with(extra, work);
    ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status) << " with " << extra;
    ASSERT_NE(WEXITSTATUS(status), kWrong) << "with " << extra;
    (WEXITSTATUS(status) == kDone ? done : refused) = true;
  }
  EXPECT_TRUE(done && refused);
}

void write_growing(const std::string& path) {
  Hdf5Writer file(path);
  GrowingTable table(file, "runs");
  for (int column = 0; column < 10; ++column)
    table.add_number("n" + std::to_string(column), "m", "a number");
  for (int row = 0; row < 5000; ++row) {
    for (int column = 0; column < 10; ++column) table.put(1.0 / (1 + row + column));
    table.end_row();
  }
  table.finish();
  file.finish();
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(LittleMemory, AFileInMemoryIsWholeOrIsNone) {
  const std::string whole = results_image(synthetic_facts(), synthetic_response());
  expect_done_or_no_memory([&] {
    return results_image(synthetic_facts(), synthetic_response()) == whole ? kDone : kWrong;
  });
}

TEST(LittleMemory, AGrowingFileIsWholeOrIsNone) {
  const TempFolder folder;
  write_growing(folder.file("whole.h5"));
  const std::string whole = bytes_of(folder.file("whole.h5"));
  expect_done_or_no_memory([&] {
    write_growing(folder.file("a.h5"));
    return bytes_of(folder.file("a.h5")) == whole ? kDone : kWrong;
  });
}

TEST(LittleMemory, AFileIsReadOrTheMemoryEnds) {
  const TempFolder folder;
  write_growing(folder.file("a.h5"));
  expect_done_or_no_memory([&] {
    const Hdf5Reader file(folder.file("a.h5"));
    return file.numbers("/runs/n9").back() == 1.0 / 5009 ? kDone : kWrong;
  });
}

}  // namespace
}  // namespace gurney::study
