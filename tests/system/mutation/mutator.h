#pragma once

#include <random>
#include <string>
#include <vector>

namespace gurney::study {

/// Damages files, always in the same way for one seed.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string text(std::string bytes) {
    for (unsigned i = random_() % 3 + 1; i > 0; --i) change_text(bytes);
    return bytes;
  }

  /// A file of records, tables or HDF5: bytes change, also near marks of its structure.
  std::string binary(std::string bytes) {
    if (pick(8) == 0) return bytes.substr(0, pick(bytes.size()));
    for (std::size_t i = pick(6) + 1; i > 0 && !bytes.empty(); --i) {
      const std::size_t at = place(bytes), length = std::min(pick(9) + 1, bytes.size() - at);
      const char value = static_cast<char>(random_());
      switch (pick(3)) {
        case 0:
          bytes[at] ^= static_cast<char>(1 << pick(8));
          break;
        case 1:
          bytes.replace(at, length, length, pick(2) ? '\xff' : '\0');
          break;
        default:
          bytes[at] = value;
      }
    }
    return bytes;
  }

 private:
  std::size_t pick(std::size_t below) { return below == 0 ? 0 : random_() % below; }

  const std::string& of(const std::vector<std::string>& list) { return list[pick(list.size())]; }

  void change_text(std::string& bytes) {
    static const std::vector<std::string> kNumbers = {"nan",
                                                      "inf",
                                                      "-inf",
                                                      "1e308",
                                                      "-1e300",
                                                      "1e-300",
                                                      "5e-324",
                                                      "-1",
                                                      "0",
                                                      "1e16",
                                                      "1e9",
                                                      "2147483647",
                                                      "4294967295",
                                                      "-0.0",
                                                      "1e5",
                                                      "1e-9",
                                                      "\"a\"",
                                                      "[1, 2]",
                                                      "{ a = 1 }",
                                                      "9223372036854775807",
                                                      "99999999999999999999"};
    static const std::vector<std::string> kTokens = {
        "[",        "]",       "{",     "}", "\"", "'''",  "\\u001b[2J", std::string(1, '\0'),
        "\xff\xfe", "\n",      "[[x]]", "=", ",",  "\r\n", "#",          "a.b",
        "=1+1",     "\x1b[31m"};
    const std::size_t at = pick(bytes.size()), length = std::min(pick(40), bytes.size() - at);
    switch (pick(8)) {
      case 0:
        if (!bytes.empty()) bytes[at] = static_cast<char>(random_());
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 3:
        bytes.insert(at, of(kTokens));
        break;
      case 4:
        move_line(bytes, at);
        break;
      default:
        replace_number(bytes, at, of(kNumbers));
    }
  }

  /// The first number behind `at`.
  static void replace_number(std::string& bytes, std::size_t at, const std::string& by) {
    const std::size_t first = bytes.find_first_of("0123456789", at);
    if (first == std::string::npos) return;
    const std::size_t end = std::min(bytes.find_first_not_of("0123456789.e-", first), bytes.size());
    bytes.replace(first, end - first, by);
  }

  void move_line(std::string& bytes, std::size_t at) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const std::string line = bytes.substr(at, end - at) + "\n";
    if (pick(2)) bytes.erase(at, end - at);
    bytes.insert(pick(bytes.size()), line);
  }

  /// Anywhere, or near one of HDF5's marks.
  std::size_t place(const std::string& bytes) {
    static const std::vector<std::string> kMarks = {"TREE", "HEAP", "SNOD",
                                                    "GCOL", "OHDR", "\x89HDF"};
    const std::size_t anywhere = pick(bytes.size());
    if (pick(3) == 0) return anywhere;
    const std::size_t mark = bytes.find(of(kMarks), anywhere);
    return mark == std::string::npos ? anywhere : std::min(mark + pick(300), bytes.size() - 1);
  }

  std::mt19937 random_;
};

}  // namespace gurney::study
