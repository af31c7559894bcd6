#include <gmock/gmock.h>

#include "groundmotions/formats/format.h"
#include "tests/groundmotions/formats/format_samples.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;

TEST(ForeignFile, SaysWhatAFileIs) {
  using namespace std::string_literals;
  const std::pair<std::string, std::string> cases[] = {
      {"PK\x03\x04...", "a zip archive; unpack it first"},
      {"PK\x03\x04.........[Content_Types].xml", "an Excel or Word file, not a record"},
      {"\x1f\x8b\b...", "a gzip archive; unpack it first"},
      {"\x89HDF\r\n\x1a\n\0"s, "an HDF5 file, not a record"},
      {"\xd0\xcf\x11\xe0\xa1"s, "an old Excel or Word file, not a record"},
      {"%PDF-1.7\n", "a PDF document, not a record"},
      {"\x89PNG\r\n\x1a\n", "a picture, not a record"},
      {"\xff\xfe"
       "1\0"s,
       "text in UTF-16"},
      {"<?xml version=\"1.0\"?>\n<FDSNStationXML>", "a StationXML file"},
      {"\xef\xbb\xbf<?xml version=\"1.0\"?><q:quakeml>", "a QuakeML file"},
      {"<?xml version=\"1.0\"?><svg>", "an XML file, not a record"},
      {"<!DOCTYPE html><p>404", "a web page, not a record: the download may have failed"},
      {"000001D XXXX   HNEXX" + std::string(40, '\0'), "a miniSEED file"},
      {"MS\x03\x01", "a miniSEED file"}};
  for (const auto& [bytes, what] : cases) {
    EXPECT_THAT(foreign_file(bytes).value_or("(none)"), HasSubstr(what));
    EXPECT_THAT(error_text([&] { read_components(SourceFile("f", bytes)); }),
                HasSubstr("f: " + what));
  }
}

TEST(ForeignFile, SaysWhatToDo) {
  EXPECT_EQ(foreign_file("\x89HDF\r\n\x1a\n"),
            "an HDF5 file, not a record; save the acceleration as text, one column for each "
            "component");
  EXPECT_EQ(foreign_file("BZh9"), "a bzip2 archive; unpack it first");
}

TEST(ForeignFile, LeavesEveryFormatAlone) {
  for (const FormatSample& sample : format_samples())
    EXPECT_FALSE(foreign_file(sample.bytes)) << sample.format;
  EXPECT_FALSE(foreign_file("000001 0.02 1.0 2.0"));
  EXPECT_FALSE(foreign_file(""));
}

TEST(ForeignFile, UnknownBinaryFilesAreReportedToBeBinary) {
  EXPECT_THAT(
      error_text([] { read_components(SourceFile("f", std::string(2000, '\0'))); }),
      HasSubstr(
          "f: a binary file of 2000 bytes, not a record in a known format (see docs/records.md)"));
}

}  // namespace
}  // namespace gurney::groundmotions
