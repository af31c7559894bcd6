#include "groundmotions/formats/column_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

std::optional<std::string_view> value_behind(const std::vector<std::string_view>& lines,
                                             std::string_view key, std::size_t& line) {
  const auto at = std::ranges::find_if(
      lines, [&](std::string_view text) { return trimmed(text).starts_with(key); });
  if (at == lines.end()) return {};
  line = static_cast<std::size_t>(at - lines.begin());
  const auto colon = at->find(':', at->find(key) + key.size() - 1);
  return colon == at->npos ? std::string_view() : trimmed(at->substr(colon + 1));
}

std::string_view needed_behind(const std::vector<std::string_view>& lines, std::string_view key,
                               std::size_t& line, FileErrors& errors) {
  const auto found = value_behind(lines, key, line);
  if (!found) errors.add(fmt::format("the header lacks '{}'", key));
  return found.value_or("");
}

double rounding_of(std::string_view printed) {
  const auto point = printed.find('.');
  if (point == printed.npos) return 0.5;
  const auto end = std::min(printed.find_first_not_of("0123456789", point + 1), printed.size());
  return 0.5 * std::pow(10, -static_cast<double>(end - point - 1));
}

std::vector<Eigen::VectorXd> read_table(const SourceFile& file, std::size_t first_line,
                                        const FortranFormat& format, FileErrors& errors) {
  std::size_t end = file.lines().size();
  while (end > first_line && trimmed(file.lines()[end - 1]).empty()) --end;
  const std::size_t columns = format.per_line, rows = end - std::min(first_line, end);
  std::size_t line = first_line;
  const auto values =
      FieldReader(file, errors).read(line, rows * columns, format, EmptyField::kError, "samples");
  if (errors.any()) return {};
  using Row = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Row> table(values.data(), static_cast<Eigen::Index>(rows),
                                    static_cast<Eigen::Index>(columns));
  std::vector<Eigen::VectorXd> result;
  for (Eigen::Index i = 0; i < table.cols(); ++i) result.emplace_back(table.col(i));
  return result;
}

}  // namespace gurney::groundmotions
