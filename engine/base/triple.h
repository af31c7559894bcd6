#pragma once

#include "engine/base/lanes.h"
#include "engine/base/vector.h"

namespace gurney {

/// A vector of one caster, or of four (lanes.h). Sums of products in the order of Eigen's.
template <class T>
struct Triple {
  T x{}, y{}, z{};
};

template <class T>
Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Triple<T> operator-(const Triple<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
Triple<T> operator*(const T& a, const Triple<T>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class T>
Triple<T> operator/(const Triple<T>& a, const T& b) {
  return {a.x / b, a.y / b, a.z / b};
}
template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T norm(const Triple<T>& a) {
  return root(dot(a, a));
}
template <class T>
Triple<T> normalized(const Triple<T>& a) {
  const T squared = dot(a, a);
  return a / select(squared > T{}, root(squared), same<T>(1));
}
template <class T>
Triple<T> select(const Mask<T>& mask, const Triple<T>& yes, const Triple<T>& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// A 3 x 3 matrix by its columns.
template <class T>
struct Columns {
  Triple<T> x, y, z;
};

template <class T>
[[gnu::always_inline]] inline Triple<T> operator*(const Columns<T>& m, const Triple<T>& v) {
  return {madd(m.z.x, v.z, madd(m.y.x, v.y, m.x.x * v.x)),
          madd(m.z.y, v.z, madd(m.y.y, v.y, m.x.y * v.x)),
          m.x.z * v.x + (m.y.z * v.y + m.z.z * v.z)};
}
template <class T>
[[gnu::always_inline]] inline Columns<T> operator*(const Columns<T>& a, const Columns<T>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class T>
Columns<T> transposed(const Columns<T>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}

template <class T>
Triple<T> same(const Vector3& v) {
  return {same<T>(v.x()), same<T>(v.y()), same<T>(v.z())};
}
template <class T>
Columns<T> same(const Matrix3& m) {
  return {same<T>(Vector3(m.col(0))), same<T>(Vector3(m.col(1))), same<T>(Vector3(m.col(2)))};
}
template <class T>
Vector3 of_lane(const Triple<T>& v, std::size_t lane) {
  return {of_lane(v.x, lane), of_lane(v.y, lane), of_lane(v.z, lane)};
}

inline void put_lane(Triple<double>& to, std::size_t, const Vector3& v) {
  to = {v.x(), v.y(), v.z()};
}
inline void put_lane(Triple<Lanes>& to, std::size_t lane, const Vector3& v) {
  to.x[lane] = v.x();
  to.y[lane] = v.y();
  to.z[lane] = v.z();
}

}  // namespace gurney
