#include "groundmotions/formats/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/base/utf8.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/record/acceleration_unit.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

namespace {

/// Above all that ground and floors were ever seen to do (4.1 g: Aoi et al. 2008, Science 322).
constexpr double kLargestAcceleration = 100 * kStandardGravity;

/// Checks options whatever the file.
void check(const ReadOptions& options) {
  require(options.unit.empty() || acceleration_unit(options.unit),
          fmt::format("'{}' is not a unit of acceleration: {} are allowed", options.unit,
                      kAccelerationUnits));
  require(!options.time_step || is_time_step(*options.time_step),
          fmt::format("the time step of a record must be in [{:g}, {:g}] s, got {}",
                      kShortestTimeStep, kLongestTimeStep, options.time_step.value_or(0)));
  require(
      !options.si_per_count || (*options.si_per_count > 0 && std::isfinite(*options.si_per_count)),
      fmt::format("count_m_per_s2 must be positive and finite, got {}",
                  options.si_per_count.value_or(0)));
}

/// Options that are of no use to a format, one line each.
std::string useless_options(const Format& format, const std::string& file,
                            const ReadOptions& options) {
  std::string errors;
  if (options.si_per_count && !format.takes_counts)
    errors +=
        fmt::format("{}: count_m_per_s2 = {} was given, but the file does not hold raw counts\n",
                    file, *options.si_per_count);
  else if (options.si_per_count && !options.unit.empty())
    errors +=
        fmt::format("{}: unit and count_m_per_s2 were both given; one of them is allowed\n", file);
  if (!options.columns.empty() && !format.takes_columns)
    errors += fmt::format("{}: columns = \"{}\" was given, but the layout of this file is known\n",
                          file, options.columns);
  return errors;
}

/// The errors of the file follow those of the options.
std::vector<Component> read_as(const Format& format, const SourceFile& file,
                               const ReadOptions& options) {
  std::string errors = useless_options(format, file.name(), options);
  std::vector<Component> components;
  try {
    components = format.read(file, options);
  } catch (const Error& error) {
    throw Error(errors + error.what());
  }
  if (!errors.empty()) errors.pop_back();  // the last line end
  require(errors.empty(), errors);
  return components;
}

std::string lines_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "line" : "lines");
}

/// No motion of a floor comes near the limit: a wrong unit, or a damaged number.
void check_amplitudes(const Component& component) {
  const double peak = component.acceleration.cwiseAbs().maxCoeff();
  require(peak <= kLargestAcceleration,
          fmt::format("{}: component '{}' has a peak of {:.4g} m/s2 ({:.3g} g); at most {:g} m/s2 "
                      "(100 g) are allowed: check the unit ({}) and the samples",
                      component.file, component.name, peak, peak / kStandardGravity,
                      kLargestAcceleration, component.unit));
}

}  // namespace

void require_readable(const Record& record) {
  for (const auto& component : record.components) {
    if (!component) continue;
    require(is_time_step(component->time_step),
            fmt::format("record '{}': cannot be written with a time step of {:g} s; {:g} to {:g} s "
                        "can be read",
                        record.name, component->time_step, kShortestTimeStep, kLongestTimeStep));
    const double peak = component->acceleration.cwiseAbs().maxCoeff();
    require(peak <= kLargestAcceleration,
            fmt::format("record '{}': cannot be written with a peak of {:.4g} m/s2 ({:.3g} g); at "
                        "most {:g} m/s2 (100 g) can be read",
                        record.name, peak, peak / kStandardGravity, kLargestAcceleration));
  }
}

namespace {

void make_readable(Component& component) {
  component.name = readable(component.name);
  for (auto& [name, value] : component.header) {
    name = readable(name);
    value = readable(value);
  }
  for (std::string& warning : component.warnings) warning = readable(warning);
}

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

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// C0, DEL and C1 of Unicode.
bool is_control(unsigned code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> table = {
      {.name = "SAC",
       .recognises = recognises_sac,
       .read = read_sac,
       .is_binary = true,
       .takes_counts = true},
      {"USGS SMC", recognises_smc, read_smc},
      {"GeoNet", recognises_geonet, read_geonet},
      {"UNAM", recognises_unam, read_unam},
      {"CWB", recognises_cwb, read_cwb},
      {"NSMN", recognises_nsmn, read_nsmn},
      {.name = "COSMOS",
       .recognises = recognises_cosmos,
       .read = read_cosmos,
       .takes_counts = true},
      {"USC volume", recognises_usc, read_usc},
      {"CSMIP volume", recognises_csmip, read_csmip},
      {"BHRC volume", recognises_bhrc, read_bhrc},
      {"USC blocks", recognises_usc_blocks, read_usc_blocks},
      {"K-NET", recognises_knet, read_knet},
      {"CSMNC", recognises_csmnc, read_csmnc},
      {"ESM", recognises_esm, read_esm},
      {"SIMBAD", recognises_simbad, read_simbad},
      {"PEER AT2", recognises_peer_at2, read_peer_at2},
      {"BBP", recognises_bbp, read_bbp},
      {"EMOD3D", recognises_emod3d, read_emod3d},
      {"columns CSV", recognises_columns_csv, read_columns_csv},
      {.name = "plain text",
       .recognises = recognises_plain_text,
       .read = read_plain_text,
       .takes_counts = true,
       .takes_columns = true},
  };
  return table;
}

std::vector<Component> read_components(const std::filesystem::path& path,
                                       const ReadOptions& options) {
  return read_components(SourceFile(path), options);
}

std::vector<Component> read_components(const SourceFile& file, const ReadOptions& options) {
  check(options);
  const auto foreign = foreign_file(file.bytes());
  require(!foreign, fmt::format("{}: {}", file.name(), foreign.value_or("")));
  const auto format = std::ranges::find_if(formats(), [&](const Format& candidate) {
    return candidate.is_binary != file.is_text() && candidate.recognises(file);
  });
  constexpr const char* kUnknown = "not a record in a known format (see docs/records.md)";
  require(
      format != formats().end() || file.is_text(),
      fmt::format("{}: a binary file of {} bytes, {}", file.name(), file.bytes().size(), kUnknown));
  if (format == formats().end()) {
    const auto fault = plain_fault(file);
    const PlainFault place = fault.value_or(PlainFault{});
    throw Error(fmt::format("{}:{}:{}: {}: {} of text, {} bytes{}", file.name(),
                            place.line + file.blank_lines(), place.column, kUnknown,
                            lines_text(file.lines().size()), file.bytes().size(),
                            fault ? "; this is neither a number nor a word" : ""));
  }
  auto components = read_as(*format, file, options);
  for (Component& component : components) {
    component.file = file.name();
    component.format = format->name;
    component.sha256 = file.sha256();
    make_readable(component);
    check_amplitudes(component);
  }
  return components;
}

std::optional<std::string> foreign_file(std::string_view bytes) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  if (bytes.starts_with("PK\x03\x04") && bytes.find("[Content_Types].xml") != bytes.npos)
    return "an Excel or Word file, not a record" + std::string(kConvert);
  for (const Mark& mark : kMarks)
    if (bytes.starts_with(mark.start)) {
      const bool says_how =
          mark.what.find(';') != mark.what.npos || mark.what.find(':') != bytes.npos;
      return std::string(mark.what) + std::string(says_how ? "" : kConvert);
    }
  if (bytes.starts_with("<?xml")) return xml_kind(bytes);
  if (is_miniseed(bytes))
    return "a miniSEED file, not a record Gurney reads: its samples are counts; remove the "
           "response "
           "and save it as SAC or text (for example with ObsPy)";
  return {};
}

std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const unsigned byte = byte_at(text, 0);
    const unsigned code = length == 2 ? (byte & 0x1f) << 6 | (byte_at(text, 1) & 0x3f) : byte;
    if (length <= 2 && is_control(code)) {
      result += ' ';
    } else if (length > 0) {
      result += text.substr(0, length);
    } else {  // Latin-1 has the first 256 codes of Unicode
      result += static_cast<char>(0xc0 | byte >> 6);
      result += static_cast<char>(0x80 | (byte & 0x3f));
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace gurney::groundmotions
