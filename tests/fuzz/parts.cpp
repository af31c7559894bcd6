#include "engine/base/hash/sha256.h"
#include "studies/run/part_folder.h"
#include "studies/run/study_identity.h"
#include "studies/run/task_result.h"
#include "tests/fuzz/feed.h"

namespace {

using namespace gurney;

constexpr const char* kIdentity = "job = 1\nanalysis_cases = 8\n\nschema = \"gurney-job/1\"\n";
constexpr std::string_view kMagic = "gurney part 3\n";

void read_part(const std::string& bytes) {
  const study::PartFormat format(kIdentity, 8);
  for (const study::PartEntry& entry : format.decode(bytes).entries)
    study::task_from_bytes(std::string_view(bytes).substr(entry.offset, entry.size));
}

}  // namespace

/// Parts as they are, and with the right magic word and checksum; tasks; the file `study`.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::text_of(data, size);
  fuzz::feed([&] { read_part(bytes); });
  fuzz::feed([&] {
    const std::string content = std::string(kMagic) + bytes;
    read_part(content + sha256(content));
  });
  fuzz::feed([&] { study::task_from_bytes(bytes); });
  fuzz::feed([&] {
    const study::PartFormat format(kIdentity, 8);
    std::vector<study::PartEntry> entries;
    read_part(format.encode({{3, bytes}}, entries));
  });
  fuzz::feed([&] { study::tasks_in(bytes); });
  fuzz::feed([&] { study::difference(bytes, kIdentity); });
  return 0;
}
