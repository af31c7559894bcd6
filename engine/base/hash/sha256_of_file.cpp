#include "engine/base/hash/sha256_of_file.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>

#include "engine/base/error.h"

namespace gurney {

std::string sha256_of_file(const std::string& path, std::uintmax_t bytes) {
  constexpr std::uintmax_t kBlock = 1 << 20;
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> sum(EVP_MD_CTX_new(),
                                                                    &EVP_MD_CTX_free);
  bool good = sum && EVP_DigestInit_ex(sum.get(), EVP_sha256(), nullptr) == 1;
  std::ifstream file(path, std::ios::binary);
  std::vector<char> block(static_cast<std::size_t>(std::min(bytes, kBlock)));
  while (good && bytes > 0) {
    const auto size = static_cast<std::size_t>(std::min(bytes, kBlock));
    good = bool(file.read(block.data(), static_cast<std::streamsize>(size))) &&
           EVP_DigestUpdate(sum.get(), block.data(), size) == 1;
    bytes -= size;
  }
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  good = good && EVP_DigestFinal_ex(sum.get(), digest, &length) == 1;
  require(good, path + ": cannot be read");
  std::string text;
  for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace gurney
