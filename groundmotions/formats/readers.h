#pragma once

#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// The readers of formats(), a pair for each layout (docs/formats/record_files.md); Format says
/// what they do.
using FormatMark = bool(const SourceFile& file);
using FormatReader = std::vector<Component>(const SourceFile& file, const ReadOptions& options);

/// Seismograms of the SCEC Broadband Platform: comments with `#` or `%` that name unit and
/// directions, then rows of time and three components.
FormatMark recognises_bbp;
FormatReader read_bbp;

/// Volume 1 of the Iranian network of the Building and Housing Research Centre (BHRC).
FormatMark recognises_bhrc;
FormatReader read_bhrc;

/// Gurney's own text format: `#` comments, a header row such as `time_s, x_m_per_s2, y_m_per_s2,
/// z_m_per_s2`, then rows of numbers. Some comments are read: columns_csv_facts.h.
FormatMark recognises_columns_csv;
FormatReader read_columns_csv;

/// COSMOS Strong Motion Data Format, version 1.20: stages V0 (raw counts), V1 and V2.
FormatMark recognises_cosmos;
FormatReader read_cosmos;

/// Volumes 1 and 2 of the California Strong Motion Instrumentation Program (CSMIP, also CDMG or
/// DMG) and RENADIC's volume 1 in the same layout.
FormatMark recognises_csmip;
FormatReader read_csmip;

/// Text files of the China Strong Motion Network Centre: lines with COMP., UNIT, NO. OF POINTS and
/// EQUALLY SPACED INTERVALS OF, then samples row by row.
FormatMark recognises_csmnc;
FormatReader read_csmnc;

/// Text files of the Central Weather Bureau (now Administration), Taiwan: lines of `#Key: value`,
/// then rows of time, up, north, east.
FormatMark recognises_cwb;
FormatReader read_cwb;

/// Text of EMOD3D and ucgmsim: a line `station component title`, a line `npts dt hh mm ss distance
/// azimuth back-azimuth`, then numbers. The file states no unit.
FormatMark recognises_emod3d;
FormatReader read_emod3d;

/// ASCII of ESM, ITACA (old and new header) and AFAD: one component under lines `KEY: value`, one
/// value on a line.
FormatMark recognises_esm;
FormatReader read_esm;

/// Volumes V1A (uncorrected) and V2A (corrected) of GNS Science, New Zealand: three components in
/// one file, each with 16 lines of text, 40 integers, 60 reals, then accelerations and, in V2A,
/// velocities and displacements.
FormatMark recognises_geonet;
FormatReader read_geonet;

/// K-NET and KiK-net ASCII: one component in counts with a scale factor in gal.
FormatMark recognises_knet;
FormatReader read_knet;

/// Raw text files of the national strong motion network of Turkey as it gave them out before AFAD
/// took the layout of ESM: lines `KEY : value`, the names of the columns, then rows of north, east,
/// up.
FormatMark recognises_nsmn;
FormatReader read_nsmn;

/// PEER ground motion files: a text header that ends with the number of samples and the time step
/// in one of its spellings, then the samples row by row.
FormatMark recognises_peer_at2;
FormatReader read_peer_at2;

/// Text of numbers without a layout of its own: one column, samples row by row, or a table with or
/// without times; text before and an end mark after the numbers.
FormatMark recognises_plain_text;
FormatReader read_plain_text;

/// Binary files of the Seismic Analysis Code, header version 6 or 7, either byte order: one
/// component. The file states its quantity at most, not its unit: the options must.
FormatMark recognises_sac;
FormatReader read_sac;

/// The .cor.acc files of SIMBAD and REXEL, which hold records of ITACA: one component under lines
/// `Key : value`, five numbers on a line that may stick together at their signs.
FormatMark recognises_simbad;
FormatReader read_simbad;

/// The standard acceleration file (Archivo Estandar de Aceleracion) of the Mexican strong motion
/// base: a Spanish header, then a column for each channel.
FormatMark recognises_unam;
FormatReader read_unam;

/// Processed files of USC that name their blocks "DATA TYPE=AC", VL and DP.
FormatMark recognises_usc_blocks;
FormatReader read_usc_blocks;

/// Volumes 1 and 2 of the University of Southern California in the layout of Trifunac and Lee
/// (1973), whatever the file is called.
FormatMark recognises_usc;
FormatReader read_usc;

/// The SMC format of the US Geological Survey: 11 lines of text, 48 integers, 50 reals, comments,
/// then samples or pairs of time and sample in cm/s2.
FormatMark recognises_smc;
FormatReader read_smc;

}  // namespace gurney::groundmotions
