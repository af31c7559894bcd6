#pragma once

#include "engine/base/lanes.h"
#include "engine/base/vector.h"

namespace gurney {

/// A vector of one body, or of four side by side (lanes.h).
template <class T>
struct Vec3 {
  T x{}, y{}, z{};
};

template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
Vec3<T> operator*(const T& a, const Vec3<T>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class T>
Vec3<T> operator/(const Vec3<T>& a, const T& b) {
  return {a.x / b, a.y / b, a.z / b};
}
/// a b + c.
template <class T>
[[gnu::always_inline]] inline Vec3<T> mul_add(const T& a, const Vec3<T>& b, const Vec3<T>& c) {
  return {mul_add(a, b.x, c.x), mul_add(a, b.y, c.y), mul_add(a, b.z, c.z)};
}
template <class T>
[[gnu::always_inline]] inline T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return mul_add(a.z, b.z, mul_add(a.y, b.y, a.x * b.x));
}
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T norm(const Vec3<T>& a) {
  return sqrt(dot(a, a));
}
/// Zero stays zero.
template <class T>
Vec3<T> normalized(const Vec3<T>& a) {
  const T squared = dot(a, a);
  return a / select(squared > T{}, sqrt(squared), splat<T>(1));
}
template <class T>
Vec3<T> select(const Mask<T>& mask, const Vec3<T>& yes, const Vec3<T>& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// A 3 x 3 matrix by its columns.
template <class T>
struct Mat3 {
  Vec3<T> x, y, z;
};

template <class T>
Mat3<T> operator+(const Mat3<T>& a, const Mat3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Mat3<T> operator-(const Mat3<T>& a, const Mat3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Mat3<T> operator*(const T& a, const Mat3<T>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> operator*(const Mat3<T>& m, const Vec3<T>& v) {
  return mul_add(v.z, m.z, mul_add(v.y, m.y, v.x * m.x));
}
template <class T>
[[gnu::always_inline]] inline Mat3<T> operator*(const Mat3<T>& a, const Mat3<T>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class T>
Mat3<T> transposed(const Mat3<T>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// a times the identity.
template <class T>
Mat3<T> diagonal(const T& a) {
  return {{a, T{}, T{}}, {T{}, a, T{}}, {T{}, T{}, a}};
}
/// a b'.
template <class T>
Mat3<T> outer(const Vec3<T>& a, const Vec3<T>& b) {
  return {b.x * a, b.y * a, b.z * a};
}

/// Velocities or forces of a rigid body.
template <class T>
struct Vec6 {
  Vec3<T> linear;   ///< velocity or momentum of its centre, or force
  Vec3<T> angular;  ///< angular velocity or momentum, or moment
};

template <class T>
Vec6<T> operator+(const Vec6<T>& a, const Vec6<T>& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}
template <class T>
Vec6<T> operator-(const Vec6<T>& a) {
  return {-a.linear, -a.angular};
}
template <class T>
Vec6<T> operator*(const T& a, const Vec6<T>& b) {
  return {a * b.linear, a * b.angular};
}
template <class T>
[[gnu::always_inline]] inline Vec6<T> mul_add(const T& a, const Vec6<T>& b, const Vec6<T>& c) {
  return {mul_add(a, b.linear, c.linear), mul_add(a, b.angular, c.angular)};
}
template <class T>
T dot(const Vec6<T>& a, const Vec6<T>& b) {
  return dot(a.linear, b.linear) + dot(a.angular, b.angular);
}
template <class T>
std::array<T, 6> entries(const Vec6<T>& a) {
  return {a.linear.x, a.linear.y, a.linear.z, a.angular.x, a.angular.y, a.angular.z};
}

template <class T>
Vec3<T> splat(const Vector3& v) {
  return {splat<T>(v.x()), splat<T>(v.y()), splat<T>(v.z())};
}
template <class T>
Mat3<T> splat(const Matrix3& m) {
  return {splat<T>(Vector3(m.col(0))), splat<T>(Vector3(m.col(1))), splat<T>(Vector3(m.col(2)))};
}
template <class T>
Vec6<T> splat(const Eigen::Matrix<double, 6, 1>& v) {
  return {splat<T>(Vector3(v.template head<3>())), splat<T>(Vector3(v.template tail<3>()))};
}
template <class T>
Vector3 lane(const Vec3<T>& v, std::size_t k) {
  return {lane(v.x, k), lane(v.y, k), lane(v.z, k)};
}

inline void set_lane(Vec3<double>& to, std::size_t, const Vector3& v) {
  to = {v.x(), v.y(), v.z()};
}
inline void set_lane(Vec3<Lanes>& to, std::size_t k, const Vector3& v) {
  to.x[k] = v.x();
  to.y[k] = v.y();
  to.z[k] = v.z();
}

}  // namespace gurney
