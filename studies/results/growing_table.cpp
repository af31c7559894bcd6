#include "studies/results/growing_table.h"

#include <cassert>
#include <numeric>

namespace gurney::study {
namespace {

constexpr std::int64_t kRowsPerBlock = 4096;  // a chunk of the file

}  // namespace

GrowingTable::GrowingTable(Hdf5Writer& file, const std::string& name) : file_(file), name_(name) {
  file_.add_group("/" + name);
  file_.add_growing({path("row"), "1", "row of the table", {}}, Hdf5Type::kInt64);
}

void GrowingTable::add(const Hdf5Spec& spec, Hdf5Type type, std::size_t width) {
  file_.add_growing(spec, type, width);
  columns_.push_back({spec.path, type, {}, {}, {}});
}

void GrowingTable::add_number(const std::string& name, const std::string& units,
                              const std::string& meaning) {
  add({path(name), units, meaning, {path("row")}}, Hdf5Type::kFloat64, 1);
}

void GrowingTable::add_whole(const std::string& name, const std::string& meaning) {
  add({path(name), "1", meaning, {path("row")}}, Hdf5Type::kInt64, 1);
}

void GrowingTable::add_text(const std::string& name, const std::string& meaning,
                            std::size_t width) {
  add({path(name), "1", meaning, {path("row")}}, Hdf5Type::kText, width);
}

GrowingTable& GrowingTable::put(double value) {
  Values& column = columns_.at(next_++);
  assert(column.type != Hdf5Type::kText);
  if (column.type == Hdf5Type::kInt64)
    column.whole.push_back(static_cast<std::int64_t>(value));
  else
    column.numbers.push_back(value);
  return *this;
}

GrowingTable& GrowingTable::put(const std::string& value) {
  Values& column = columns_.at(next_++);
  assert(column.type == Hdf5Type::kText);
  column.texts.push_back(value);
  return *this;
}

void GrowingTable::end_row() {
  assert(next_ == columns_.size());
  next_ = 0;
  if (++rows_ - written_ == kRowsPerBlock) write_block();
}

void GrowingTable::finish() {
  if (rows_ > written_) write_block();
}

void GrowingTable::write_block() {
  std::vector<std::int64_t> index(static_cast<std::size_t>(rows_ - written_));
  std::iota(index.begin(), index.end(), written_);
  file_.append(path("row"), index);
  for (Values& column : columns_) {
    file_.append(column.path, column.numbers);
    file_.append(column.path, column.whole);
    file_.append(column.path, column.texts);
    column.numbers.clear();
    column.whole.clear();
    column.texts.clear();
  }
  written_ = rows_;
}

}  // namespace gurney::study
