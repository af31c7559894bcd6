#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "studies/results/hdf5_checks.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/results_file.h"
#include "tests/support/error_text.h"
#include "tests/support/expect_error.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temp_folder.h"

/// Results files that are damaged, or made to crash who reads them.
namespace gurney::study {
namespace {

std::string saved(const TempFolder& folder, const std::string& bytes) {
  std::ofstream(folder.file("a.h5"), std::ios::binary) << bytes;
  return folder.file("a.h5");
}

/// A file that another program made.
template <class Fill>
std::string foreign(const TempFolder& folder, Fill fill) {
  const std::string path = folder.file("a.h5");
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  fill(file);
  H5Fclose(file);
  return path;
}

void add_dataset(hid_t file, const char* name, hsize_t length, hid_t creation) {
  const hid_t space = H5Screate_simple(1, &length, nullptr);
  H5Dclose(H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Sclose(space);
}

std::string results() { return results_image(synthetic_facts(), synthetic_response()); }

/// All that is in a file, or its error.
std::string read_all(const std::string& path) {
  return error_text([&] {
    const Hdf5Reader file(path);
    for (const std::string& name : file.attributes()) {
      if (name == "format_version")
        file.whole_attribute(name);
      else
        file.text_attributes(name);
    }
    for (const Hdf5Dataset& each : file.datasets()) {
      if (each.type == "string")
        file.strings(each.path);
      else
        file.numbers(each.path);
    }
  });
}

TEST(HostileFile, AnAttributeOfManyElementsIsNoNumber) {
  const TempFolder folder;
  Hdf5Writer file;
  file.set_attribute("/", "format_version", std::vector<std::uint8_t>(200, 0x41));
  file.set_attribute("/", "title", 1.5);
  const Hdf5Reader reader(saved(folder, file.image()));
  EXPECT_ERROR(reader.whole_attribute("format_version"),
               "a.h5: attribute 'format_version' must be one whole number");
  EXPECT_ERROR(reader.whole_attribute("title"), "attribute 'title' must be one whole number");
  EXPECT_ERROR(reader.text_attribute("title"), "a.h5: attribute 'title' must be text");
}

TEST(HostileFile, DatasetsOfOtherTypesAndNamesAreErrors) {
  const TempFolder folder;
  Hdf5Writer file;
  file.add_scale({"/t", "s", "time", {}}, std::vector<double>{0, 1});
  file.add_scale({"/n", "1", "name", {}}, std::vector<std::string>{"a"});
  const Hdf5Reader reader(saved(folder, file.image()));
  EXPECT_ERROR(reader.strings("/t"), "a.h5: dataset /t must hold texts");
  EXPECT_ERROR(reader.numbers("/n"), "a.h5: dataset /n must hold numbers");
  EXPECT_ERROR(reader.numbers("/none"), "a.h5: has no dataset /none");
  EXPECT_ERROR(reader.require_length({"/t"}, 3), "dataset /t has 2 rows; must have 3");
}

TEST(HostileFile, ValuesOfOtherFilesAreRefused) {
  const TempFolder folder;
  const std::string secret = folder.write("secret", std::string(80, 's'));
  const std::string path = foreign(folder, [&](hid_t file) {
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(creation, secret.c_str(), 0, 80);
    add_dataset(file, "x", 10, creation);
    H5Pclose(creation);
  });
  EXPECT_ERROR(Hdf5Reader{path}, "a.h5: dataset /x: its values stand in other files");
}

TEST(HostileFile, LinksAreRefused) {
  const TempFolder folder;
  EXPECT_ERROR(Hdf5Reader{foreign(folder,
                                  [](hid_t file) {
                                    H5Lcreate_external("other.h5", "/", file, "out", H5P_DEFAULT,
                                                       H5P_DEFAULT);
                                  })},
               "a.h5: /out is a link to elsewhere");
  EXPECT_ERROR(Hdf5Reader{foreign(folder,
                                  [](hid_t file) {
                                    H5Lcreate_soft("/x", file, "soft", H5P_DEFAULT, H5P_DEFAULT);
                                  })},
               "a.h5: /soft is a link to elsewhere");
}

TEST(HostileFile, MoreValuesThanBytesAreRefused) {
  const TempFolder folder;
  const std::string path = foreign(folder, [](hid_t file) {
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 4096;
    H5Pset_chunk(creation, 1, &chunk);
    add_dataset(file, "x", hsize_t{1} << 50, creation);
    H5Pclose(creation);
  });
  EXPECT_ERROR(Hdf5Reader{path}, "dataset /x: states 1125899906842624 values, but only 0 bytes");
}

TEST(HostileFile, APipeIsNoResultsFile) {
  const TempFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  EXPECT_ERROR(Hdf5Reader{folder.file("pipe")}, "pipe: is a pipe or a device");
}

TEST(HostileFile, TextsComeWithoutControlCharacters) {
  const TempFolder folder;
  Hdf5Writer file;
  file.set_attribute("/", "title", std::string("a\x1b[2J\xff"));
  file.add_scale({"/n", "1", "name", {}}, std::vector<std::string>{"b\x07"});
  const Hdf5Reader reader(saved(folder, file.image()));
  EXPECT_EQ(reader.text_attribute("title"), "a\\x1b[2J\\xff");
  EXPECT_EQ(reader.strings("/n").front(), "b\\x07");
}

TEST(HostileFile, AChildThatCrashesOrRunsOnIsAnError) {
  const TempFolder folder;
  const std::string path = folder.write("a.h5", "x");
  EXPECT_ERROR(hdf5::probe(path, [] { std::abort(); }),
               "a.h5: is damaged: the HDF5 library crashes over it");
  EXPECT_ERROR(hdf5::probe(path, [] { throw std::bad_alloc(); }), "takes more memory than");
  EXPECT_ERROR(hdf5::probe(path, [] { std::raise(SIGXCPU); }), "a.h5: took too long to read");
  EXPECT_ERROR(hdf5::probe(path, [] { std::raise(SIGALRM); }), "a.h5: took too long to read");
  EXPECT_ERROR(hdf5::probe(path, [] { throw Error("of the file itself"); }), "of the file itself");
  hdf5::probe(path, [] {});
}

/// Under an emulator or a debugging allocator a file of some bytes takes seconds.
TEST(HostileFile, AChildThatIsSlowIsNoError) {
  const TempFolder folder;
  hdf5::probe(folder.write("a.h5", "x"), [] {
    rlimit cpu;
    require(::getrlimit(RLIMIT_CPU, &cpu) == 0 && cpu.rlim_cur >= 30, "has too little time");
    require(::alarm(0) >= 500, "is woken too early");
  });
}

/// A dataset of zeros: one chunk of them, compressed once, stands for every chunk.
void add_zeros(hid_t group, const char* name, hsize_t chunks) {
  constexpr hsize_t kChunk = 1 << 22;  // values
  const hsize_t length = chunks * kChunk;
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 1, &kChunk);
  H5Pset_deflate(creation, 9);
  const hid_t space = H5Screate_simple(1, &length, nullptr);
  const hid_t set =
      H5Dcreate2(group, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  const std::vector<double> zeros(kChunk);
  const hid_t memory = H5Screate_simple(1, &kChunk, nullptr);
  const hsize_t first = 0;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &kChunk, nullptr);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, zeros.data());
  H5Dflush(set);
  hsize_t size = 0;
  H5Dget_chunk_storage_size(set, &first, &size);
  std::vector<char> packed(size);
  std::uint32_t filters = 0;
  H5Dread_chunk(set, H5P_DEFAULT, &first, &filters, packed.data());
  for (hsize_t from = kChunk; from < length; from += kChunk)
    H5Dwrite_chunk(set, H5P_DEFAULT, filters, &from, size, packed.data());
  H5Sclose(memory);
  H5Sclose(space);
  H5Dclose(set);
  H5Pclose(creation);
}

TEST(HostileFile, ValuesOfMoreMemoryThanAFileOfItsSizeHasAreNotRead) {
  const TempFolder folder;
  EXPECT_ERROR(
      Hdf5Reader{foreign(folder, [](hid_t file) { add_zeros(file, "x", 32); })},
      "a.h5: its values would take 1.1 GB of memory, which is more than a results file of");
  const Hdf5Reader all(foreign(folder, [](hid_t file) { add_zeros(file, "x", 1); }));
  EXPECT_EQ(all.numbers("/x").size(), 1u << 22);
}

// A file with the place, size and time of one that was read, and more values: these are not read into the room
// of the fewer ones.
TEST(HostileFile, AFileThatWasWrittenAgainIsNotReadAsTheOldOne) {
  const TempFolder folder;
  const auto image = [](std::size_t values) {
    Hdf5Writer file;
    file.add_scale({"/t", "s", "time", {}}, std::vector<double>(values));
    return file.image();
  };
  std::string few = image(10), many = image(3000);
  few.resize(std::max(few.size(), many.size()));
  many.resize(few.size());
  const std::string path = saved(folder, few);
  const auto time = std::filesystem::last_write_time(path);
  EXPECT_EQ(Hdf5Reader(path).numbers("/t").size(), 10u);
  saved(folder, many);
  std::filesystem::last_write_time(path, time);
  EXPECT_ERROR(Hdf5Reader(path).numbers("/t"), "a.h5: it was written again while it was read");
}

TEST(HostileFile, AColumnIsAsLongAsItsTable) {
  const TempFolder folder;
  const std::string path = foreign(folder, [](hid_t file) {
    const hid_t group = H5Gcreate2(file, "energy", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);
    add_dataset(group, "row", 1, creation);
    add_dataset(group, "loss", 2, creation);
    H5Pclose(creation);
    H5Gclose(group);
  });
  EXPECT_ERROR(Hdf5Reader{path}, "dataset /energy/loss must be a column as long as its table");
}

TEST(HostileFile, EveryFlippedBitOfASealedFileIsNoticed) {
  const TempFolder folder;
  const std::string whole = results();
  ASSERT_EQ(read_all(saved(folder, whole)), "(no error)");
  EXPECT_FALSE(files_without_checksum().contains(folder.file("a.h5")));
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::string bytes = whole;
    bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
    EXPECT_NE(read_all(saved(folder, bytes)), "(no error)") << i;
  }
  EXPECT_NE(read_all(saved(folder, whole.substr(0, whole.size() / 2))), "(no error)");
}

/// The seal is no secret, and a file of an older version has none.
TEST(HostileFile, FlippedBytesOfAnUnsealedFileNeverCrash) {
  const TempFolder folder;
  const std::string whole = results();
  const std::string bare = whole.substr(0, whole.rfind("\ngurney sha256"));
  ASSERT_EQ(read_all(saved(folder, bare)), "(no error)");
  EXPECT_TRUE(files_without_checksum().contains(folder.file("a.h5")));
  std::mt19937 random(2);
  for (int i = 0; i < 80; ++i) {
    std::string bytes = bare;
    for (unsigned k = random() % 8 + 1; k > 0; --k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    EXPECT_THAT(read_all(saved(folder, bytes)), testing::Not(testing::HasSubstr("_M_"))) << i;
  }
}

}  // namespace
}  // namespace gurney::study
