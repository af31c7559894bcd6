#include "studies/run/part_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include "engine/base/hash/sha256.h"
#include "studies/run/study_identity.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

constexpr const char* kIdentity = "a.toml = aaa\nanalysis_cases = 7\n";
constexpr std::size_t kUnits = 7;

using Start = PartFolder::Start;

class Parts : public testing::Test {
 protected:
  PartFolder open(Start start, const std::string& identity = kIdentity) {
    return PartFolder(folder(), identity, kUnits, start);
  }
  std::string folder() const { return temp_.file("a.h5.parts"); }
  std::string part(const std::string& name) const { return folder() + "/" + name; }

  void fill() {
    PartFolder parts = open(Start::kNew);
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

  static std::string host() {
    char name[256] = "";
    gethostname(name, sizeof name - 1);
    return name;
  }

  /// A part as the format says, with its checksums right.
  static std::string part_of(std::uint64_t task, std::uint64_t size, const std::string& content,
                             const std::string& identity = kIdentity) {
    const auto bytes = [](std::uint64_t number) {
      std::string text(8, '\0');
      std::memcpy(text.data(), &number, 8);
      return text;
    };
    const std::string whole = "gurney part 3\n" + bytes(task) + bytes(size) +
                              sha256(sha256(identity) + bytes(task) + content) + content;
    return whole + sha256(whole);
  }

  TempFolder temp_;
};

TEST_F(Parts, GiveBackWhatWasPutIn) {
  fill();
  const PartFolder parts = open(Start::kResume);
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
    PartFolder parts = open(Start::kResume);
    parts.add({{6, "six"}});
    EXPECT_EQ(parts.read(6), "six");
  }
  const PartFolder again = open(Start::kResume);
  EXPECT_EQ(again.size(), 4u);
  EXPECT_EQ(again.read(3), "three");
}

TEST_F(Parts, OfAnInterruptedStudyAreKeptUnlessResumed) {
  fill();
  EXPECT_EQ(error_text([&] { open(Start::kNew); }),
            folder() +
                ": contains runs of an interrupted study; continue with --resume, or start again "
                "with --overwrite");
  EXPECT_EQ(open(Start::kResume).size(), 3u);
}

TEST_F(Parts, OfAnotherStudyAreRefusedWithBothValues) {
  fill();
  EXPECT_EQ(error_text([&] { open(Start::kResume, "a.toml = bbb\nanalysis_cases = 7\n"); }),
            folder() + ": contains runs of another study: a.toml: there 'aaa', here 'bbb'");
  EXPECT_EQ(error_text([&] { open(Start::kResume, "a.toml = aaa\n"); }),
            folder() + ": contains runs of another study: analysis_cases: there '7', here nothing");
}

TEST_F(Parts, StateTheirStudyWhereTheFileStudyIsDamagedOrMissing) {
  fill();
  const std::string whole = contents_of(part("study"));
  EXPECT_EQ(whole, "sha256 = " + sha256(kIdentity) + "\n" + kIdentity);
  std::string flipped = whole;
  flipped[whole.find("aaa")] = 'b';
  for (const std::string& bytes : {flipped, whole.substr(0, whole.size() - 1), whole + "x",
                                   whole.substr(1), std::string("\n"), std::string()}) {
    std::ofstream(part("study"), std::ios::binary) << bytes;
    EXPECT_EQ(IdentityFile(folder()).damaged(), !bytes.empty());
    EXPECT_THAT(error_text([&] { open(Start::kNew); }), HasSubstr("continue with --resume"));
    const PartFolder parts = open(Start::kResume);
    EXPECT_EQ(parts.size(), 3u);
    EXPECT_EQ(
        parts.warnings(),
        std::vector<std::string>{part("study") + (bytes.empty() ? ": is missing" : ": is damaged") +
                                 "; it is written again: no part beside it belongs "
                                 "to another study"});
    EXPECT_EQ(contents_of(part("study")), whole);
  }
}

TEST_F(Parts, OfAnotherStudyAreNotTakenForOursWhereTheFileStudyIsDamaged) {
  fill();
  std::ofstream(part("study"), std::ios::binary) << "torn";
  EXPECT_EQ(
      error_text([&] { open(Start::kResume, "a.toml = bbb\nanalysis_cases = 7\n"); }),
      part("study") +
          ": is damaged, and 00000001.part beside it belongs to another study, or to this one "
          "as another program ran it; start again with --overwrite");
  EXPECT_TRUE(std::filesystem::exists(part("00000001.part")));
  EXPECT_EQ(
      error_text([&] { IdentityFile(folder()).identity(); }),
      part("study") +
          ": is damaged (its checksum does not match); `gurney run` with --resume and `gurney "
          "merge` write it again");
}

TEST_F(Parts, ThatAreDamagedAreSetAsideAndReported) {
  fill();
  const std::string whole = contents_of(part("00000001.part"));
  std::string flipped = whole;
  flipped[flipped.find("three")] = 'T';
  for (const std::string& bytes :
       {whole.substr(0, whole.size() - 1), whole.substr(0, 20), std::string(), flipped, whole + "x",
        "gurney part 2\n" + whole.substr(14)}) {
    std::ofstream(part("00000001.part"), std::ios::binary) << bytes;
    const PartFolder parts = open(Start::kResume);
    EXPECT_EQ(parts.size(), 1u);
    EXPECT_FALSE(parts.has(3));
    EXPECT_TRUE(parts.has(5));
    EXPECT_EQ(contents_of(part("00000001.damaged")), bytes);
    EXPECT_EQ(parts.warnings(),
              std::vector<std::string>{
                  part("00000001.part") + ": is damaged (" + std::to_string(bytes.size()) +
                  " bytes, its checksum does not match): its runs are missing"});
  }
}

TEST_F(Parts, HalfWrittenOnesDoNotCount) {
  fill();
  const std::string whole = contents_of(part("00000001.part"));
  std::ofstream(part("00000003.part.part"), std::ios::binary) << whole;
  std::ofstream(part("notes.txt")) << "mine";
  {
    PartFolder parts = open(Start::kResume);
    EXPECT_EQ(parts.size(), 3u);
    EXPECT_TRUE(parts.warnings().empty());
    parts.add({{1, "one"}});
  }
  EXPECT_EQ(open(Start::kResume).read(1), "one");
}

TEST_F(Parts, OnAFullDiskKeepWhatWasThere) {
  fill();
  {
    PartFolder parts = open(Start::kResume);
    add_on_a_full_disk(parts);
  }
  EXPECT_EQ(open(Start::kResume).size(), 3u);
  {
    PartFolder parts = open(Start::kResume);
    parts.add({{6, "six"}});
  }
  EXPECT_EQ(open(Start::kResume).read(6), "six");
}

TEST_F(Parts, NeedAFolderThatCanBeMade) {
  EXPECT_THAT(
      error_text([&] { PartFolder(temp_.file("none/a.parts"), kIdentity, kUnits, Start::kNew); }),
      HasSubstr("none/a.parts: cannot be created: No such file or directory"));
  temp_.write("file.parts", "");
  EXPECT_THAT(
      error_text([&] { PartFolder(temp_.file("file.parts"), kIdentity, kUnits, Start::kResume); }),
      HasSubstr("file.parts: cannot be created: "));
}

TEST_F(Parts, AreUsedByOneProcessAtATime) {
  const PartFolder first = open(Start::kNew);
  EXPECT_EQ(error_text([&] { open(Start::kResume); }),
            folder() + ": another process works on this study: process " +
                std::to_string(getpid()) + " on " + host());
}

TEST_F(Parts, GoWithTheirFolder) {
  fill();
  open(Start::kResume).remove();
  EXPECT_FALSE(std::filesystem::exists(folder()));
}

TEST_F(Parts, ThatAreForgedAreSetAside) {
  struct Forged {
    std::string name, bytes, why;
  };
  const std::vector<Forged> all = {
      {"00000001.part", part_of(~0ULL, 1, "x"), "it has analysis case 18446744073709551615 of 7"},
      {"00000001.part", part_of(7, 1, "x"), "it has analysis case 7 of 7"},
      {"00000001.part", part_of(1, ~0ULL - 15, "x"), "an analysis case is larger than the part"},
      {"00000001.part", part_of(1, ~0ULL - 79, "x"), "an analysis case is larger than the part"},
      {"00000001.part", part_of(1, 0, "x"), "its analysis case 1 belongs to another study"},
      {"00000001.part", part_of(1, 1, "x", "another"),
       "its analysis case 1 belongs to another study"},
      {"00000000.part", part_of(1, 1, "x"), "parts are numbered from 1"}};
  for (const Forged& each : all) {
    { open(Start::kReplace); }
    std::ofstream(part(each.name), std::ios::binary) << each.bytes;
    const PartFolder parts = open(Start::kResume);
    EXPECT_EQ(parts.size(), 0u) << each.why;
    ASSERT_EQ(parts.warnings().size(), 1u) << each.why;
    EXPECT_THAT(parts.warnings()[0], HasSubstr(each.why));
  }
  { open(Start::kReplace); }
  std::ofstream(part("00000001.part"), std::ios::binary) << part_of(1, 1, "x");
  EXPECT_EQ(open(Start::kResume).read(1), "x") << "the forger knows the format";
}

TEST_F(Parts, ChangedWhileTheStudyRunsAreNotedWhenTheyAreRead) {
  PartFolder parts = open(Start::kNew);
  parts.add({{3, "three"}, {4, "four"}});
  std::string bytes = contents_of(part("00000001.part"));
  bytes[bytes.find("three")] ^= 1;
  std::ofstream(part("00000001.part"), std::ios::binary) << bytes;
  EXPECT_EQ(parts.read(4), "four");
  EXPECT_EQ(
      error_text([&] { parts.read(3); }),
      part("00000001.part") +
          ": was changed while the study ran: the checksum of analysis case 3 does not match");
}

TEST_F(Parts, OfAnotherProcessAreNotReplaced) {
  const PartFolder first = open(Start::kNew);
  EXPECT_THAT(error_text([&] { open(Start::kReplace); }),
              HasSubstr("another process works on this study"));
  EXPECT_TRUE(std::filesystem::exists(part("study")));
}

TEST_F(Parts, NeedTheirFolderToTheEnd) {
  PartFolder parts = open(Start::kNew);
  std::filesystem::remove_all(folder());
  EXPECT_FALSE(parts.holds());
  EXPECT_EQ(error_text([&] {
              parts.add({{1, "one"}});
            }),
            folder() + ": was removed while the study ran");
  const PartFolder second = open(Start::kNew);
  EXPECT_EQ(error_text([&] {
              parts.add({{1, "one"}});
            }),
            folder() + ": was removed while the study ran");
}

TEST_F(Parts, LeaveWhatOthersPutThere) {
  temp_.write("a.h5.parts/notes.txt", "mine");
  EXPECT_EQ(error_text([&] { open(Start::kReplace); }),
            folder() +
                ": is not a folder of parts, it contains 'notes.txt'; it is kept. Give another "
                "name with -o");
  std::filesystem::remove(part("notes.txt"));
  fill();
  temp_.write("a.h5.parts/notes.txt", "mine");
  open(Start::kResume).remove();
  EXPECT_EQ(contents_of(part("notes.txt")), "mine");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder()), {}), 1);
}

TEST_F(Parts, FollowNoLink) {
  temp_.write("elsewhere/x", "");
  std::filesystem::create_directory_symlink(temp_.file("elsewhere"), folder());
  EXPECT_THAT(error_text([&] { open(Start::kReplace); }), HasSubstr("a.h5.parts: is a link"));
  std::filesystem::remove(folder());
  fill();
  std::filesystem::create_symlink(temp_.write("victim", "precious"), part("00000003.part.part"));
  {
    PartFolder parts = open(Start::kResume);
    parts.add({{6, "six"}});
    EXPECT_EQ(parts.read(6), "six");
  }
  EXPECT_EQ(contents_of(temp_.file("victim")), "precious");
}

/// Runs `work` in a process of its own. @return whether it ended well
bool in_process(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    bool good = true;
    try {
      work();
    } catch (const Error&) {
      good = false;
    }
    _exit(good ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(Parts, OfADeadProcessAreFree) {
  EXPECT_TRUE(in_process([&] { fill(); }));
  const pid_t child = fork();
  if (child == 0) {
    const PartFolder parts = open(Start::kResume);
    raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(open(Start::kResume).size(), 3u);
}

TEST_F(Parts, OfTwoFirstStartsOneGoesOn) {
  for (int i = 0; i < 50; ++i) {
    int gate[2];
    ASSERT_EQ(pipe(gate), 0);
    std::vector<pid_t> children;
    for (int k = 0; k < 2; ++k) {
      children.push_back(fork());
      if (children.back() != 0) continue;
      ::close(gate[1]);
      char ignored = 0;
      [[maybe_unused]] const auto end = ::read(gate[0], &ignored, 1);  // until the parent closes it
      bool good = true;
      try {
        PartFolder parts = open(k == 0 ? Start::kNew : Start::kReplace);
        parts.add({{1, "one"}});
        usleep(2000);
        good = parts.read(1) == "one" && parts.size() == 1;
        parts.remove();
      } catch (const Error& error) {
        good = std::string(error.what()).find("another process works") != std::string::npos;
      }
      _exit(good ? 0 : 1);
    }
    ::close(gate[0]);
    ::close(gate[1]);
    for (const pid_t child : children) {
      int status = 0;
      waitpid(child, &status, 0);
      EXPECT_EQ(status, 0);
    }
    EXPECT_FALSE(std::filesystem::exists(folder()));
  }
}

}  // namespace
}  // namespace gurney::study
