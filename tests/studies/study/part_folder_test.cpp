#include "studies/batch/part_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney {
namespace {

using testing::HasSubstr;

constexpr const char* kIdentity = "job_sha256 aaa\nunits 7\n";

class Parts : public testing::Test {
 protected:
  PartFolder open(bool resume, const std::string& identity = kIdentity) {
    return PartFolder(folder(), identity, resume);
  }
  std::string folder() const { return temp_.file("a.h5.parts"); }
  std::string part(const std::string& name) const { return folder() + "/" + name; }

  void fill() {
    PartFolder parts = open(false);
    parts.add({{3, "three"}, {0, ""}});
    parts.add({{5, std::string(100000, '\0') + "five"}});
  }

  void add_on_a_full_disk(PartFolder& parts) const {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit tight = before;
    tight.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &tight);
    const std::string text = error_text([&] { parts.add({{6, std::string(5000, 'x')}}); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(text,
              part("00000003.part") + ": cannot be written, nothing was kept: File too large");
    EXPECT_FALSE(parts.has(6));
    EXPECT_FALSE(std::filesystem::exists(part("00000003.part.part")));
  }

  TempFolder temp_;
};

TEST_F(Parts, GiveBackWhatWasPutIn) {
  fill();
  const PartFolder parts = open(true);
  EXPECT_EQ(parts.size(), 3u);
  EXPECT_TRUE(parts.has(0) && parts.has(3) && parts.has(5));
  EXPECT_FALSE(parts.has(1) || parts.has(6) || parts.has(1000000));
  EXPECT_EQ(parts.read(3), "three");
  EXPECT_EQ(parts.read(0), "");
  EXPECT_EQ(parts.read(5), std::string(100000, '\0') + "five");
  EXPECT_TRUE(parts.warnings().empty());
}

TEST_F(Parts, AreNotWrittenOverOnResume) {
  fill();
  {
    PartFolder parts = open(true);
    parts.add({{6, "six"}});
    EXPECT_EQ(parts.read(6), "six");
  }
  const PartFolder again = open(true);
  EXPECT_EQ(again.size(), 4u);
  EXPECT_EQ(again.read(3), "three");
}

TEST_F(Parts, OfAnInterruptedStudyAreKeptUnlessResumed) {
  fill();
  EXPECT_EQ(error_text([&] { open(false); }),
            folder() +
                ": holds runs of a study that was interrupted; go on with --resume, or remove this "
                "folder to start again");
  EXPECT_EQ(open(true).size(), 3u);
}

TEST_F(Parts, OfAnotherStudyAreRefusedWithBothValues) {
  fill();
  EXPECT_EQ(
      error_text([&] { open(true, "job_sha256 bbb\nunits 7\n"); }),
      folder() + ": holds runs of another study: there 'job_sha256 aaa', here 'job_sha256 bbb'");
  EXPECT_EQ(error_text([&] { open(true, "job_sha256 aaa\n"); }),
            folder() + ": holds runs of another study: there 'units 7', here ''");
}

TEST_F(Parts, WithoutTheirIdentityAreRefused) {
  fill();
  std::filesystem::remove(part("study"));
  EXPECT_EQ(error_text([&] { open(true); }),
            folder() +
                ": holds runs, but no file 'study' that says whose; remove this folder to "
                "start again");
}

TEST_F(Parts, ThatAreDamagedAreSetAsideAndTold) {
  fill();
  const std::string whole = contents_of(part("00000001.part"));
  std::string flipped = whole;
  flipped[flipped.find("three")] = 'T';
  for (const std::string& bytes :
       {whole.substr(0, whole.size() - 1), whole.substr(0, 20), std::string(), flipped, whole + "x",
        "gurney part 2\n" + whole.substr(14)}) {
    std::ofstream(part("00000001.part"), std::ios::binary) << bytes;
    const PartFolder parts = open(true);
    EXPECT_EQ(parts.size(), 1u);
    EXPECT_FALSE(parts.has(3));
    EXPECT_TRUE(parts.has(5));
    EXPECT_EQ(contents_of(part("00000001.damaged")), bytes);
    EXPECT_EQ(parts.warnings(),
              std::vector<std::string>{part("00000001.part") + ": is damaged (" +
                                       std::to_string(bytes.size()) +
                                       " bytes, its checksum does not match): its runs are made "
                                       "again"});
  }
}

TEST_F(Parts, HalfWrittenOnesDoNotCount) {
  fill();
  const std::string whole = contents_of(part("00000001.part"));
  std::ofstream(part("00000003.part.part"), std::ios::binary) << whole;
  std::ofstream(part("notes.txt")) << "mine";
  {
    PartFolder parts = open(true);
    EXPECT_EQ(parts.size(), 3u);
    EXPECT_TRUE(parts.warnings().empty());
    parts.add({{1, "one"}});
  }
  EXPECT_EQ(open(true).read(1), "one");
}

TEST_F(Parts, OnAFullDiskKeepWhatWasThere) {
  fill();
  {
    PartFolder parts = open(true);
    add_on_a_full_disk(parts);
  }
  EXPECT_EQ(open(true).size(), 3u);
  {
    PartFolder parts = open(true);
    parts.add({{6, "six"}});
  }
  EXPECT_EQ(open(true).read(6), "six");
}

TEST_F(Parts, NeedAFolderThatCanBeMade) {
  EXPECT_THAT(error_text([&] { PartFolder(temp_.file("none/a.parts"), kIdentity, false); }),
              HasSubstr("none/a.parts: cannot be made: No such file or directory"));
  temp_.write("file.parts", "");
  EXPECT_THAT(error_text([&] { PartFolder(temp_.file("file.parts"), kIdentity, true); }),
              HasSubstr("file.parts: cannot be made: "));
}

TEST_F(Parts, AreUsedByOneProcessAtATime) {
  const PartFolder first = open(false);
  EXPECT_EQ(error_text([&] { open(true); }), folder() + ": another process works on this study");
}

TEST_F(Parts, GoWithTheirFolder) {
  fill();
  open(true).remove();
  EXPECT_FALSE(std::filesystem::exists(folder()));
}

}  // namespace
}  // namespace gurney
