#include "studies/results/output_files.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <vector>

#include "engine/base/input_file.h"
#include "studies/results/hdf5_writer.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

std::size_t count_files(const TempFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

TEST(OutputFiles, CommitsEveryFileOrNone) {
  const TempFolder folder;
  {
    OutputFiles output(false);
    output.stage(folder.file("a"), "one");
    output.stage(folder.file("b"), "two");
    EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
    EXPECT_TRUE(std::filesystem::exists(folder.file("a.part")));
  }
  EXPECT_EQ(count_files(folder), 0u);
  OutputFiles output(false);
  output.stage(folder.file("a"), "one");
  output.stage(folder.file("b"), "two");
  output.commit();
  EXPECT_EQ(contents_of(folder.file("a")), "one");
  EXPECT_EQ(contents_of(folder.file("b")), "two");
  EXPECT_EQ(count_files(folder), 2u);
}

TEST(OutputFiles, NeverReplaceAFileThatWasRead) {
  const TempFolder folder;
  const std::string job = folder.write("job.toml", "title");
  OutputFiles output(true);
  output.check(job);
  output.stage(job, "an output");
  read_input_file(job);
  EXPECT_ERROR(output.check(job), "job.toml: is read by this command and cannot be its output");
  EXPECT_ERROR(output.commit(), "job.toml: is read by this command");
  std::filesystem::create_symlink(job, folder.file("link"));
  EXPECT_ERROR(output.check(folder.file("link")), "link: is read by this command");
  EXPECT_ERROR(put_in_place(folder.write("made", "x"), job, true), "job.toml: is read by this");
  EXPECT_EQ(contents_of(job), "title");
}

TEST(OutputFiles, RefusesAnExistingFileAndLeavesIt) {
  const TempFolder folder;
  std::ofstream(folder.file("a")) << "old";
  EXPECT_ERROR(OutputFiles(false).check(folder.file("a")), "a: exists already");
  OutputFiles late(false);
  late.stage(folder.file("a"), "new");
  EXPECT_ERROR(late.commit(), "was created by another process in the meantime");
  EXPECT_EQ(contents_of(folder.file("a")), "old");
}

TEST(OutputFiles, KeepsTheOldFileUntilTheNewOneIsComplete) {
  const TempFolder folder;
  std::ofstream(folder.file("a")) << "old";
  OutputFiles output(true);
  output.check(folder.file("a"));
  output.stage(folder.file("a"), "new");
  EXPECT_EQ(contents_of(folder.file("a")), "old");
  output.commit();
  EXPECT_EQ(contents_of(folder.file("a")), "new");
  EXPECT_EQ(count_files(folder), 1u);
}

TEST(OutputFiles, ChecksBeforeTheWork) {
  const TempFolder folder;
  const OutputFiles output(true);
  EXPECT_ERROR(output.check(folder.file("none/a.h5")), "none does not exist");
  EXPECT_ERROR(output.check(folder.path()), "is a folder");
  output.check(folder.file("a.h5"));
  EXPECT_EQ(count_files(folder), 0u) << "a check leaves nothing behind";
}

TEST(OutputFiles, RefusesAnUnwritableFolder) {
  if (geteuid() == 0) {
    // Root may write everywhere but in the kernel's folders.
    EXPECT_ERROR(OutputFiles(true).check("/proc/gurney.h5"),
                 "/proc/gurney.h5: cannot be written: ");
    return;
  }
  const TempFolder folder;
  std::filesystem::permissions(
      folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_ERROR(OutputFiles(true).check(folder.file("a.h5")), "Permission denied");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

/// Lets no file grow beyond a size, which fails like a full disk: in the middle of a write.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }

 private:
  sighandler_t handler_;
  rlimit before_{};
};

TEST(OutputFiles, LeavesNothingWhenTheDiskIsFull) {
  const TempFolder folder;
  std::ofstream(folder.file("b")) << "old";
  {
    const FileSizeLimit limit(10000);
    OutputFiles output(true);
    output.stage(folder.file("a"), "small");
    EXPECT_ERROR(output.stage(folder.file("b"), std::string(20000, 'x')),
                 "b: cannot be written, nothing was kept: File too large");
  }
  EXPECT_EQ(count_files(folder), 1u);
  EXPECT_EQ(contents_of(folder.file("b")), "old");
}

TEST(Hdf5Writer, NamesItsFileWhereTheDiskIsFull) {
  const TempFolder folder;
  const FileSizeLimit limit(10000);
  const std::string path = folder.file("results.h5");
  Hdf5Writer file(path);
  std::vector<double> values(100000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<double>(i));
  EXPECT_ERROR(
      {
        file.add_growing({"/x", "1", "values", {}}, Hdf5Type::kFloat64);
        file.append("/x", values);
        file.finish();
      },
      path);
}

TEST(OutputFiles, NeitherFollowsALinkNorTouchesThePartsOfOthers) {
  const TempFolder folder;
  folder.write("victim", "precious");
  std::filesystem::create_symlink(folder.file("victim"), folder.file("a.part"));
  folder.write("b.part", "somebody's");
  OutputFiles output(false);
  output.check(folder.file("a"));
  output.check(folder.file("b"));
  output.stage(folder.file("a"), "one");
  output.stage(folder.file("b"), "two");
  output.commit();
  EXPECT_EQ(contents_of(folder.file("victim")), "precious");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("a.part")));
  EXPECT_EQ(contents_of(folder.file("b.part")), "somebody's");
  EXPECT_EQ(contents_of(folder.file("a")), "one");
  EXPECT_EQ(contents_of(folder.file("b")), "two");
  EXPECT_EQ(count_files(folder), 5u);
}

TEST(OutputFiles, PutInPlaceWithoutOverwriteLeavesWhatIsThere) {
  const TempFolder folder;
  folder.write("made", "new");
  folder.write("there", "old");
  EXPECT_ERROR(put_in_place(folder.file("made"), folder.file("there"), false),
               "there: was created by another process in the meantime and is kept");
  EXPECT_EQ(contents_of(folder.file("there")), "old");
  EXPECT_EQ(contents_of(folder.file("made")), "new");
  put_in_place(folder.file("made"), folder.file("there"), true);
  EXPECT_EQ(contents_of(folder.file("there")), "new");
  EXPECT_FALSE(std::filesystem::exists(folder.file("made")));
}

}  // namespace
}  // namespace gurney::study
