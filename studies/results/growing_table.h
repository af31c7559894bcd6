#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "studies/results/columns.h"
#include "studies/results/hdf5_writer.h"

namespace gurney::study {

/// A group of 1-D columns that grow row by row, in blocks: memory does not grow with the rows.
///
/// Columns are added first, then rows: put() in the order of the columns, then end_row().
class GrowingTable {
 public:
  /// Makes the group and its scale `row`.
  GrowingTable(Hdf5Writer& file, const std::string& name);

  void add_number(const std::string& name, const std::string& units, const std::string& meaning);
  void add_whole(const std::string& name, const std::string& meaning);
  void add_text(const std::string& name, const std::string& meaning, std::size_t width);

  template <class Row>
  void add(std::span<const TableColumn<Row>> columns) {
    for (const TableColumn<Row>& column : columns) {
      if (column.whole())
        add_whole(column.name, column.meaning);
      else
        add_number(column.name, column.units, column.meaning);
      if (column.missing != 0) file_.set_attribute(path(column.name), "_FillValue", column.missing);
    }
  }

  GrowingTable& put(double value);
  GrowingTable& put(const std::string& value);

  template <class Row>
  GrowingTable& put(std::span<const TableColumn<Row>> columns, const Row& row) {
    for (const TableColumn<Row>& column : columns) put(column.value(row));
    return *this;
  }

  void end_row();
  std::int64_t rows() const { return rows_; }

  /// Writes what is left of the last block.
  void finish();

 private:
  struct Values {
    std::string path;
    Hdf5Type type;
    std::vector<double> numbers;
    std::vector<std::int64_t> whole;
    std::vector<std::string> texts;
  };

  std::string path(const std::string& column) const { return "/" + name_ + "/" + column; }
  void add(const Hdf5Spec& spec, Hdf5Type type, std::size_t width);
  void write_block();

  Hdf5Writer& file_;
  std::string name_;
  std::vector<Values> columns_;
  std::size_t next_ = 0;  ///< column that put() fills
  std::int64_t rows_ = 0, written_ = 0;
};

}  // namespace gurney::study
