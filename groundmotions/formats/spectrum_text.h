#pragma once

#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/table_titles.h"

namespace gurney::groundmotions {

/// Spectra lie beside the records in many folders and look like them.
/// @throws Error if the text above the numbers speaks of spectra; other errors do not matter then.
void refuse_spectra(const PlainRows& rows, const SourceFile& file);

/// @throws Error if the titles are those of a spectrum, `T(s),Sa(g)`, `f (Hz),FAS (g)`, or such a
///         line of text if the table has no titles.
/// @param all  whether all columns are looked at, not only the first
void refuse_spectra(const TableTitles& titles, bool all, const PlainRows& rows,
                    const SourceFile& file);

}  // namespace gurney::groundmotions
