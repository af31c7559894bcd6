#include <algorithm>
#include <map>
#include <variant>

#include "engine/base/error.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/hdf5_writer.h"

// Results files without HDF5: columns in memory, by the same names. The last one written is that which is
// read, whatever its path.
namespace gurney::study {
namespace {

using Texts = std::vector<std::string>;
using Column = std::variant<std::vector<double>, Texts>;

struct File {
  std::map<std::string, Column> columns;
  std::map<std::string, Texts> attributes;
};

File& file() {
  static File last;
  return last;
}

template <class Value>
void put(const std::string& path, std::span<const Value> values) {
  file().columns[path] = std::vector<double>(values.begin(), values.end());
}

template <class Values>
Values column(const std::string& path) {
  const auto found = file().columns.find(path);
  require(found != file().columns.end() && std::holds_alternative<Values>(found->second),
          path + ": no such column");
  return std::get<Values>(found->second);
}

void note(const std::string& object, const std::string& name, const Texts& values) {
  if (object == "/") file().attributes[name] = values;
}

}  // namespace

Hdf5Writer::Hdf5Writer() : file_(0) { file() = {}; }
Hdf5Writer::~Hdf5Writer() = default;
void Hdf5Writer::add_group(const std::string&) {}
void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const std::string& value) {
  note(object, name, {value});
}
void Hdf5Writer::set_attribute(const std::string&, const std::string&, std::int64_t) {}
void Hdf5Writer::set_attribute(const std::string&, const std::string&, double) {}
void Hdf5Writer::set_attribute(const std::string& object, const std::string& name,
                               const Texts& values) {
  note(object, name, values);
}
void Hdf5Writer::set_attribute(const std::string&, const std::string&,
                               const std::vector<std::uint8_t>&) {}
std::vector<std::uint64_t> Hdf5Writer::shape_of(const Hdf5Spec&) const { return {}; }
void Hdf5Writer::write(const Hdf5Spec& spec, const Shape&, std::span<const double> v) {
  put(spec.path, v);
}
void Hdf5Writer::write(const Hdf5Spec& spec, const Shape&, std::span<const std::int64_t> v) {
  put(spec.path, v);
}
void Hdf5Writer::write(const Hdf5Spec& spec, const Shape&, std::span<const std::uint8_t> v) {
  put(spec.path, v);
}
void Hdf5Writer::write(const Hdf5Spec& spec, const Shape&, std::span<const std::string> v) {
  file().columns[spec.path] = Texts(v.begin(), v.end());
}
void Hdf5Writer::make_scale(const std::string&, std::uint64_t) {}
std::string Hdf5Writer::image() { return {}; }

Hdf5Reader::Hdf5Reader(const std::string& path) : path_(path), file_(0) {
  for (const auto& [name, values] : file().columns) {
    datasets_.emplace_back();
    datasets_.back().path = name;
  }
}
Hdf5Reader::~Hdf5Reader() = default;
bool Hdf5Reader::has(const std::string& path) const { return file().columns.contains(path); }
Texts Hdf5Reader::attributes() const {
  Texts names;
  for (const auto& [name, value] : file().attributes) names.push_back(name);
  return names;
}
std::string Hdf5Reader::text_attribute(const std::string& name) const {
  const auto found = file().attributes.find(name);
  return found == file().attributes.end() || found->second.empty() ? "" : found->second.front();
}
std::vector<double> Hdf5Reader::numbers(const std::string& path) const {
  return column<std::vector<double>>(path);
}
Texts Hdf5Reader::strings(const std::string& path) const { return column<Texts>(path); }
void Hdf5Reader::require_length(const Texts& paths, std::uint64_t length) const {
  for (const std::string& path : paths)
    require(std::visit([](const auto& values) { return values.size(); }, file().columns.at(path)) ==
                length,
            path + ": has another length");
}

}  // namespace gurney::study
