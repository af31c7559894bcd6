#include "groundmotions/suites/list_suite.h"
#include "tests/fuzz/feed.h"

/// Lists of records and search reports of PEER.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  fuzz::feed([&] {
    const groundmotions::SourceFile file("list.csv", fuzz::text_of(data, size));
    if (recognises_list_suite(file)) read_list_suite(file);
    if (recognises_peer_search_results(file)) read_peer_search_results(file);
  });
  return 0;
}
