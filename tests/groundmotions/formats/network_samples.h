#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

/// Small files in the layouts of strong motion networks, of invented stations and numbers.
namespace gurney::groundmotions {

/// `values` row by row, each formatted by `format`.
template <typename T>
std::string rows(const std::vector<T>& values, std::size_t per_line, const char* format) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format(fmt::runtime(format), values[i]);
    if ((i + 1) % per_line == 0 || i + 1 == values.size()) text += "\r\n";
  }
  return text;
}

inline const std::vector<double> kVolumeSamples = {0.001, -0.002, 0.003, -0.1,  0.05,
                                                   0.02,  -0.03,  0.01,  0.002, -0.001};

struct VolumeHeader {
  std::string label = "CHAN  1:  90 DEG";
  int code = 90;
  double fraction = 1;  ///< of g
  double length = 0.05;
  std::string units = "UNITS OF UNCOR ACCEL IS G.                 MAX  =  -.100 G, AT    .015 SEC.";
  std::string first = "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 01/02/03, TEST";
};

inline std::string volume1_header(const VolumeHeader& h) {
  std::vector<int> integers(100, 0);
  integers[26] = h.code;
  integers[27] = 10;
  std::vector<double> reals(50, 0.0);
  reals[2] = h.length;
  reals[4] = h.fraction;
  return h.first +
         "\r\nNOWHERE EARTHQUAKE\r\nJUNE 1, 2001 08:05 PDT\r\n"
         "00001-X0001-01001.01                 START TIME:  6/01/01, 15:05:37.5 UTC\r\n"
         "STATION NO. 00001   10.000N, 20.000W     XX-1  S/N 1\r\nNOWHERE - TOWN HALL\r\n" +
         h.label +
         "\r\nNOWHERE EARTHQUAKE\r\nHYPOCENTER:\r\nINSTR PERIOD =  .020 SEC\r\n"
         "NO. OF POINTS =     10  RECORD LENGTH =  .050 SEC\r\n" +
         h.units + "\r\nRMS ACCEL OF COMPLETE RECORD =  .008 G.\r\n" + rows(integers, 16, "{:5d}") +
         rows(reals, 8, "{:10.3f}");
}

inline const std::string kVolumeEnd = "/&  ----------  END OF DATA FOR CHANNEL  1  ----------\r\n";

/// CSMIP volume 1 with evenly spaced samples.
inline std::string csmip_volume1(const VolumeHeader& header = {},
                                 const std::string& announcement =
                                     "   10 POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  "
                                     "(UNITS: G)") {
  return volume1_header(header) + announcement + "\r\n" + rows(kVolumeSamples, 8, "{:9.6f}") +
         kVolumeEnd;
}

/// Volume 1 with pairs of time and value in tenths of g.
inline std::string pairs_volume1(const std::vector<double>& times, VolumeHeader header = {}) {
  header.fraction = 0.1;
  header.units = "UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  =  -.100 G, AT    .015 SEC.";
  header.length = times.back() - times.front();
  std::vector<double> pairs;
  for (std::size_t i = 0; i < times.size(); ++i) {
    pairs.push_back(times[i]);
    pairs.push_back(10 * kVolumeSamples[i]);
  }
  return volume1_header(header) + rows(pairs, 10, "{:7.3f}") + kVolumeEnd;
}

/// CSMIP volume 2, its last header line wrapped.
inline std::string csmip_volume2(const std::string& label = "CHAN  1:  90 DEG", int code = 90,
                                 double stated_step = 0.02) {
  std::vector<int> integers(100, 0);
  integers[26] = code;
  std::vector<double> reals(100, 0.0);
  reals[59] = 0.18;
  reals[60] = stated_step;
  std::string text =
      "CORRECTED ACCELEROGRAM   00001-X0001-01001.01  " + label +
      "     FROM\r\nUNCORRECTED ACCELEROGRAM DATA              PROCESSED: 01/02/03\r\n"
      "NOWHERE EARTHQUAKE\r\n\r\n\r\nSTATION NO. 00001\r\nNOWHERE - TOWN HALL\r\n" +
      label + "\r\n";
  for (int i = 9; i < 18; ++i) text += "\r\n";
  text +=
      "PEAK ACCELERATION =   -98.067    CM/SEC/SEC  AT     .060   SEC.\r\n"
      "PEAK   VELOCITY   =     1.000      CM/SEC    AT     .080   SEC.\r\n\r\n\r\n\r\n\r\n"
      "00001-X0001-01001.01      NOWHERE - TOWN HALL   CHAN  1:  90 D\r\nEG\r\n";
  text += rows(integers, 16, "{:5d}") + rows(reals, 8, "{:10.3f}");
  std::vector<double> samples;
  for (const double a : kVolumeSamples) samples.push_back(980.665 * a);
  const std::string lines[] = {"ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)",
                               "VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)",
                               "DISPL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM)"};
  for (const std::string& line : lines)
    text += "   10 POINTS OF " + line + "\r\n" + rows(samples, 8, "{:10.3f}");
  return text + kVolumeEnd;
}

/// What a COSMOS file states; the numbers are those of the format's definition.
struct CosmosSample {
  std::string first = "Uncorrected acceleration  (Format v01.20 with 13 text lines) Src: none";
  std::string label = "Sta Chan  1: 340 deg (Rcrdr Chan  1) Location: cellar";
  std::string announcement =
      "      10 acceleration pts, approx    0 secs, units=cm/sec2(04),"
      "Format=(8f10.5)";
  std::vector<std::pair<int, int>> integers = {};  ///< number from 1, value
  std::vector<std::pair<int, double>> reals = {};
  double scale = 980.665;
};

inline std::string cosmos_file(const CosmosSample& s = {}) {
  std::vector<int> integers(100, -999);
  for (const auto& [number, value] : {std::pair{1, 1},
                                      {2, 1},
                                      {3, 4},
                                      {40, 2001},
                                      {42, 6},
                                      {43, 1},
                                      {44, 15},
                                      {45, 5},
                                      {54, 340}})
    integers[static_cast<std::size_t>(number - 1)] = value;
  for (const auto& [number, value] : s.integers)
    integers[static_cast<std::size_t>(number - 1)] = value;
  std::vector<double> reals(100, -999.0);
  for (const auto& [number, value] :
       {std::pair{30, 37.5}, {34, 0.01}, {62, 10.0}, {63, 0.1}, {64, -0.1 * s.scale}})
    reals[static_cast<std::size_t>(number - 1)] = value;
  for (const auto& [number, value] : s.reals) reals[static_cast<std::size_t>(number - 1)] = value;
  std::vector<double> samples;
  for (const double a : kVolumeSamples) samples.push_back(s.scale * a);
  return s.first +
         "\nNowhere earthquake\nHypocenter:\nOrigin:\nStatn No: 01-00001 Code:XX-1 Town hall\n"
         "Coords:\nRecorder:\nRcrd start time:\n" +
         s.label +
         "\nRaw record length =\nProcessed:\nRecord filtered below 0.30  Hz\n"
         "Values used when parameter or data value is unknown/unspecified:   -999, -999.0\n"
         " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" +
         rows(integers, 10, "{:8d}") +
         " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" +
         rows(reals, 6, "{:13.6f}") +
         "   1 Comment line(s) follow, each starting with a \"|\":\n| not a real record\n" +
         s.announcement + "\n" + rows(samples, 8, "{:10.5f}") +
         "End-of-data for Chan  1 acceleration\n";
}

inline std::string bhrc_channel(const std::string& component, double rate = 200) {
  std::vector<double> samples;
  for (const double a : kVolumeSamples) samples.push_back(10 * a);
  std::string text =
      "* VOL1DS FILE:  1/01\r\nInst Type = XX\r\nOrigin Time : 2001/01/01\r\n\r\n" +
      component.substr(0, 1) + "\r\n\r\nCOMP " + component +
      "   \r\nNowhere   Station 10.0 N 20.0 E   Altitude 1m   Azimuth L 50    T 140\r\n"
      "Epicenter\r\nINSTR PERIOD =  .020 SEC\r\n"
      "NO. OF POINTS =     10      DURATION =   .050\r\nUNITS ARE SECONDS AND G/10\r\n\r\n";
  for (int i = 0; i < 7; ++i) text += std::string(i < 6 ? 70 : 20, ' ') + "\r\n";
  for (int i = 0; i < 7; ++i)
    text +=
        fmt::format("{:13.6E}  .000000E+00  .000000E+00  .000000E+00  .0\r\n", i == 1 ? rate : 0.0);
  return text + rows(samples, 10, "{:13.6E}") + "/&\r\n";
}

inline std::string usc_block(const std::string& type, const std::string& label = "090 DEGREES") {
  std::vector<double> samples;
  for (const double a : kVolumeSamples) samples.push_back(1000 * a);
  return "  NOWHERE, ROOF\r\n  " + label +
         "\r\n  EARTHQUAKE OF JUNE 1, 2001\r\n  BUTTERWORTH AT .25 HZ, ORDER 4\r\n"
         "  YEAR=2001 JULIAN DAY=152 HOUR=15 MINUTE= 5 SECOND= 0 COMPONENT=  90\r\n"
         "  SAMPLES/SEC=200 FILTER TYPE=BUTTERWORTH  CORNER= 0.25 ORDER=4 DATA TYPE=" +
         type + "\r\n  NO OF POINTS=    10, UNITS=CM/SEC**2, CM/SEC, AND CM\r\n" +
         rows(samples, 10, "{:8.2f}");
}

}  // namespace gurney::groundmotions
