#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/vector.h"

/// Plain values as bytes, for files that only this program on this class of machine reads back.
/// A type T takes part by a function `template <class Archive> void visit(Archive&, T&)`, which
/// names its members once for both directions.
namespace gurney::study {

static_assert(std::endian::native == std::endian::little);

class ByteWriter {
 public:
  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    else
      visit(*this, value);
  }
  void operator()(std::string& text) {
    std::uint64_t size = text.size();
    (*this)(size);
    bytes_ += text;
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t size = list.size();
    (*this)(size);
    for (T& each : list) (*this)(each);
  }
  template <class T, class U, class... More>
  void operator()(T& first, U& second, More&... more) {
    (*this)(first);
    (*this)(second, more...);
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      std::memcpy(&value, take(sizeof value).data(), sizeof value);
    else
      visit(*this, value);
  }
  void operator()(std::string& text) {
    std::uint64_t size = 0;
    (*this)(size);
    text = take(size);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t size = 0;
    (*this)(size);
    require(size <= bytes_.size(), "the bytes end too early");
    list.resize(size);
    for (T& each : list) (*this)(each);
  }
  template <class T, class U, class... More>
  void operator()(T& first, U& second, More&... more) {
    (*this)(first);
    (*this)(second, more...);
  }

  bool done() const { return bytes_.empty(); }

 private:
  std::string_view take(std::uint64_t size) {
    require(size <= bytes_.size(), "the bytes end too early");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
};

template <class Archive>
void visit(Archive& archive, Vector3& v) {
  archive(v.x(), v.y(), v.z());
}

template <class Archive>
void visit(Archive& archive, Quaternion& q) {
  archive(q.w(), q.x(), q.y(), q.z());
}

}  // namespace gurney::study
