#include <algorithm>

#include "groundmotions/formats/caltech_components.h"
#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

bool recognises_usc(const SourceFile& file) {
  bool is_volume = false;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, file.lines().size()); ++i)
    is_volume =
        is_volume ||
        upper(file.lines()[i].substr(0, 200)).find("OF UNCORRECTED ACCELEROGRAM DATA OF VOL") !=
            std::string::npos;
  return is_volume;
}

/// @throws Error for volume 3 (response spectra) and what caltech_components.h says.
std::vector<Component> read_usc(const SourceFile& file, const ReadOptions& options) {
  const std::string first = upper(file.lines()[0].substr(0, 200));
  if (first.find("RESPONSE") != std::string::npos || first.find("SPECTR") != std::string::npos)
    refuse_spectra(file.name(), "volume 3", "volume 2");
  return caltech_components(file, options);
}

}  // namespace gurney::groundmotions
