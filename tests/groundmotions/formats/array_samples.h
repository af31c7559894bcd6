#pragma once

#include <algorithm>

#include "tests/groundmotions/formats/network_samples.h"

/// Small files in the layouts of USGS SMC, GeoNet, UNAM and CWB, of invented stations and
/// numbers.
namespace gurney::groundmotions {

inline const std::vector<double> kSmcSamples = {1.5, -2.25, 0.5, -12.5, 3.125, 4, 5, -6, 7, -0.5};

/// In cm/s2, the Fortran way: "-2.2500E+0".
inline std::string smc_number(double value) {
  std::string text = fmt::format("{: .4E}", value);
  return text.erase(text.size() - 2, 1);  // E+00 becomes E+0
}

struct SmcSample {
  std::string first = "2 CORRECTED ACCELEROGRAM";
  std::string component = "   65";
  std::vector<std::pair<int, int>> integers = {};  ///< number from 1, value
  std::vector<std::pair<int, double>> reals = {};  ///< likewise
  std::vector<double> numbers = kSmcSamples;
  bool has_long_numbers = false;  ///< 5E14.7 instead of 8E10.4
};

inline std::string smc_file(const SmcSample& s = {}) {
  std::vector<int> integers(48, -32768);
  std::vector<double> reals(50, 1.7e38);
  const std::pair<int, int> stated[] = {{2, 2001}, {3, 152}, {4, 15},  {5, 5}, {6, 37},
                                        {7, 500},  {13, 90}, {14, 65}, {16, 2}};
  for (const auto& [i, value] : stated) integers[static_cast<std::size_t>(i) - 1] = value;
  integers[16] = static_cast<int>(s.numbers.size());
  reals[1] = 200;
  reals[29] = 7;
  reals[31] = -12.5;
  reals[32] = 0.1;
  for (const auto& [i, value] : s.integers) integers[static_cast<std::size_t>(i) - 1] = value;
  for (const auto& [i, value] : s.reals) reals[static_cast<std::size_t>(i) - 1] = value;
  std::string text =
      s.first +
      "\r\n*\r\nXX01\r\n     2001  06  01    1505 Nowhere\r\nMoment Mag=      6.0\r\n"
      "station = Nowhere, Town Hall             component=" +
      s.component +
      "\r\nepicentral dist =     10.0       pk     =    -12.5\r\n"
      "inst type=XX         data source = nobody\r\n*\r\n*\r\n*\r\n" +
      rows(integers, 8, "{:10d}") + rows(reals, 5, "{:15.7E}") + "|\r\n| invented\r\n";
  if (s.has_long_numbers) return text + rows(s.numbers, 5, "{: 14.7E}");
  std::vector<std::string> printed;
  for (const double value : s.numbers) printed.push_back(smc_number(value));
  return text + rows(printed, 8, "{}");
}

/// Type 1: pairs of time and sample.
inline std::string smc_pairs() {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < kSmcSamples.size(); ++i) {
    numbers.push_back(0.005 * static_cast<double>(i) + (i % 2 == 0 ? 0 : 0.001));
    numbers.push_back(kSmcSamples[i]);
  }
  return smc_file(
      {.first = "1 UNCORRECTED ACCELEROGRAM", .reals = {{2, 1.7e38}}, .numbers = numbers});
}

inline const std::vector<double> kGeonetSamples = {-0.1, 0.2,  12.3, -980.7, 45.6, 7,
                                                   8,    -9.5, 10,   11,     -12,  0.5};  ///< mm/s2

struct GeonetSample {
  bool is_corrected = false;
  std::string label = "N28W";
  int prepended = 0;  ///< samples before the start time
};

inline std::string geonet_block(const GeonetSample& s = {}) {
  std::vector<int> integers(40, 0);
  const std::pair<int, int> stated[] = {{9, 2001},   {10, 6},  {19, 1},  {20, 15}, {39, 5},
                                        {40, 37500}, {31, 12}, {34, 12}, {28, 332}};
  for (const auto& [i, value] : stated) integers[static_cast<std::size_t>(i) - 1] = value;
  if (s.is_corrected) integers[34] = integers[35] = 12;
  std::vector<double> reals(60, 0);
  reals[21] = 0.005 * s.prepended;
  reals[23] = 0.06;
  reals[24] = reals[25] = 0.005;
  const char* title = s.is_corrected ? "Corrected" : "Uncorrected";
  std::string text =
      fmt::format("{} accelerogram 20010601_1505_XXXX_20 GNS Science\r\n", title) +
      "Site XXXX      10 00 00S  170 00 00E     Cusp file:  none\r\nNowhere Town Hall\r\n"
      "Instrument XX\r\nResolution: 18-bit   Instr Period: 0.0050 s   Damping: 0.700\r\n"
      "Accelerogram 20010601_1505_XXXX_20   Processed 2001 June 02\r\nnear Nowhere\r\n"
      "2001 June 01         15:05:37 UT\r\nEpicentre  10 00 00S 170 00 00E  Mw 6.00\r\n"
      "Number of points     12    Duration   0.06 s\r\n";
  text += s.is_corrected ? "Instrument corrected data at 0.005 sec intervals\r\n"
                           "Band-pass filter transition bands are .10-.25 Hz and 24.50-25.50 Hz\r\n"
                         : "Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s\r\n"
                           "Data is unfiltered\r\n";
  text += "Component " + s.label + "\r\nAcceleration:  Peak   -980.7 mm/s/s at   0.02 s\r\n";
  text += "Velocity record unevaluated\r\nDisplacement record unevaluated\r\n";
  text += rows(integers, 10, "{:8d}") + rows(reals, 10, "{:8.4f}");
  for (int i = 0; i < (s.is_corrected ? 3 : 1); ++i) text += rows(kGeonetSamples, 10, "{:8.1f}");
  return text;
}

inline std::string geonet_file(GeonetSample s = {}) {
  std::string text;
  for (const char* label : {"N28W", "S62W", "Up"}) {
    s.label = label;
    text += geonet_block(s);
  }
  return text;
}

inline std::string unam_file(const std::string& order = "V/N90E/N00E", int stated_rows = 4) {
  const std::string counts = fmt::format("/{0}/{0}/{0}", stated_rows);
  std::string names = order;
  std::string row;
  for (std::size_t begin = 0; begin < names.size();) {
    const auto end = std::min(names.find('/', begin), names.size());
    row += fmt::format("{:>10}", names.substr(begin, end - begin));
    begin = end + 1;
  }
  return "*******\r\n          INSTITUTO DE NINGUNA PARTE\r\n"
         "ARCHIVO ESTANDAR DE ACELERACION:\r\nVERSION DEL FORMATO                    : 2.0\r\n"
         "=====\r\nDATOS DE LA ESTACION:\r\n"
         "NOMBRE DE LA ESTACION                  : NINGUNA\r\n"
         "CLAVE DE LA ESTACION                   : XXXX\r\n"
         "NUMERO DE CANALES                      : 3\r\n"
         "ORIENTACION C1-C6 (rumbo;orientacion)  : /" +
         order +
         "\r\n"
         "ORIENTACION C7-C12 (rumbo;orientacion) :\r\n"
         "VEL. DE MUESTREO, C1-C6 (muestras/s)   : /100/100/100\r\n"
         "INTERVALO DE MUESTREO, C1-C6 (s)       : /0.01/0.01/0.01\r\n"
         "FECHA DEL SISMO [GMT]                  : 2001/06/01\r\n"
         "HORA EPICENTRO (GMT)                   : 23:59:50.0\r\n"
         "HORA DE LA PRIMERA MUESTRA (GMT)       : 00:00:01.5\r\n"
         "DURACION DEL REGISTRO (s), C1-C6       : /0.04/0.04/0.04\r\n"
         "NUM. TOTAL DE MUESTRAS, C1-C6          : " +
         counts +
         "   \r\n"
         "ACEL. MAX.(Gal), C1-C6                 : /-5.28/11.90/7.98      \r\n"
         "ACEL. MAX., C1-C6, EN LA MUESTRA       : /2/3/4\r\n"
         "UNIDADES DE LOS DATOS                  : Gal (cm/s/s)\r\n"
         "FORMATO DATOS (FORTRAN,10 campos/dato) : 3F10.2\r\n"
         "CALIDAD DEL ACELEROGRAMA:\r\nDUDOSO\r\nCOMENTARIOS:\r\n\r\n"
         "DATOS DE ACELERACION:\r\n---------+---------+\r\n"
         "   CANAL-1   CANAL-2   CANAL-3\r\n" +
         row +
         "\r\n---------+---------+\r\n"
         "      0.46      2.33     -0.64\r\n     -5.28      0.42      0.32\r\n"
         "     -1.45     11.90      0.32\r\n      1.00      2.00      7.98\r\n";
}

inline std::string cwb_file(const std::string& sequence = "U(+); N(+); E(+)") {
  return "#Earthquake Information\r\n#Origin Time(GMT+08): 2001/06/01-23:05:00\r\n\r\n"
         "#StationCode: XXX\r\n#StationName: Nowhere\r\n#InstrumentKind: XX\r\n"
         "#StartTime(GMT+08): 2001/06/01-23:05:37.500\r\n#RecordLength(sec): 2\r\n"
         "#SampleRate(Hz): 2\r\n#AmplitudeUnit:  gal. DCoffset(corr)\r\n"
         "#AmplitudeMAX. U:    1.000~   -2.500\r\n#AmplitudeMAX. N:    4.000~   -5.000\r\n"
         "#AmplitudeMAX. E:    6.000~   -3.000\r\n#DataSequence: Time " +
         sequence +
         "\r\n"
         "#Data: 4F10.3 \r\n"
         "     0.000     1.000     4.000     0.125\r\n     0.500    -2.500    -5.000     6.000\r\n"
         "     1.000     0.500     1.000    -3.000\r\n     1.500     0.250     0.000     1.000\r\n";
}

}  // namespace gurney::groundmotions
