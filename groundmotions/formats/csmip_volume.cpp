#include "groundmotions/formats/caltech_components.h"
#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

std::string first_text(const SourceFile& file) {
  for (const std::string_view line : file.lines())
    if (!trimmed(line).empty()) return upper(trimmed(line).substr(0, 200));
  return {};
}

}  // namespace

bool recognises_csmip(const SourceFile& file) {
  const std::string line = first_text(file);
  return line.starts_with("UNCORRECTED ACCELEROGRAM DATA") ||
         line.starts_with("CORRECTED ACCELEROGRAM") ||
         line.starts_with("RESPONSE AND FOURIER AMPLITUDE SPECTRA");
}

/// @returns the acceleration of each channel of the file.
/// @throws Error for volume 3 (response spectra) and what caltech_components.h says.
std::vector<Component> read_csmip(const SourceFile& file, const ReadOptions& options) {
  if (first_text(file).starts_with("RESPONSE")) refuse_spectra(file.name(), "volume 3", "the .V2");
  return caltech_components(file, options);
}

}  // namespace gurney::groundmotions
