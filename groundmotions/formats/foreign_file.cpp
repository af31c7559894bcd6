#include "groundmotions/formats/foreign_file.h"

#include <algorithm>
#include <cctype>

namespace gurney::groundmotions {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kConvert =
    "; save the acceleration as text, one column for each component";

struct Mark {
  std::string_view start;
  std::string_view what;
};

constexpr Mark kMarks[] = {
    {"PK\x03\x04"sv, "a zip archive; unpack it first"},
    {"\x1f\x8b"sv, "a gzip archive; unpack it first"},
    {"BZh"sv, "a bzip2 archive; unpack it first"},
    {"\xfd\x37zXZ\0"sv, "an xz archive; unpack it first"},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive; unpack it first"},
    {"Rar!"sv, "a rar archive; unpack it first"},
    {"\x89HDF\r\n\x1a\n"sv, "an HDF5 file, not a record"},
    {"MATLAB 5.0 MAT-file"sv, "a MATLAB file, not a record"},
    {"\x93NUMPY"sv, "a NumPy array, not a record"},
    {"\x89PNG"sv, "a picture, not a record"},
    {"\xff\xd8\xff"sv, "a picture, not a record"},
    {"GIF8"sv, "a picture, not a record"},
    {"%PDF"sv, "a PDF document, not a record"},
    {"\xd0\xcf\x11\xe0"sv, "an old Excel or Word file, not a record"},
    {"\xff\xfe"sv, "text in UTF-16, not in UTF-8; save it as plain text"},
    {"\xfe\xff"sv, "text in UTF-16, not in UTF-8; save it as plain text"},
    {"<!DOCTYPE html"sv, "a web page, not a record: the download may have failed"},
    {"<html"sv, "a web page, not a record: the download may have failed"},
};

std::string xml_kind(std::string_view bytes) {
  const auto head = bytes.substr(0, 4000);
  if (head.find("FDSNStationXML") != head.npos)
    return "a StationXML file: it describes a station and holds no motion";
  if (head.find("quakeml") != head.npos)
    return "a QuakeML file: it describes an earthquake and holds no motion";
  return "an XML file, not a record";
}

/// The fixed header of miniSEED 2 (FDSN SEED manual 2.4, chapter 8): six digits of a sequence
/// number, a quality letter, a blank; of miniSEED 3: "MS" and the number 3.
bool is_miniseed(std::string_view bytes) {
  if (bytes.starts_with("MS\x03")) return true;
  return bytes.size() >= 48 &&
         std::ranges::all_of(bytes.substr(0, 6),
                             [](unsigned char c) { return std::isdigit(c) != 0; }) &&
         "DRQM"sv.find(bytes[6]) != bytes.npos && (bytes[7] == ' ' || bytes[7] == '\0') &&
         std::ranges::any_of(bytes.substr(8, 40), [](char c) { return c == '\0'; });
}

}  // namespace

std::optional<std::string> foreign_file(std::string_view bytes) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  if (bytes.starts_with("PK\x03\x04") && bytes.find("[Content_Types].xml") != bytes.npos)
    return "an Excel or Word file, not a record" + std::string(kConvert);
  for (const Mark& mark : kMarks)
    if (bytes.starts_with(mark.start)) {
      const bool is_told =
          mark.what.find(';') != mark.what.npos || mark.what.find(':') != bytes.npos;
      return std::string(mark.what) + std::string(is_told ? "" : kConvert);
    }
  if (bytes.starts_with("<?xml")) return xml_kind(bytes);
  if (is_miniseed(bytes))
    return "a miniSEED file, not a record Gurney reads: its samples are counts; remove the "
           "response "
           "and save it as SAC or text (for example with ObsPy)";
  return {};
}

}  // namespace gurney::groundmotions
