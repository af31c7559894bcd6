#include "studies/run/task_result.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

// A structured binding names all members, so that a new one must be added here.
auto members(WheelDemands& s) {
  auto& [a, b, c, d, e, f] = s;
  return std::tie(a, b, c, d, e, f);
}
auto members(PointDemands& s) {
  auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
auto members(Demands& s) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w, x, y, z, aa, ab, ac, ad,
         ae, af, ag, ah] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, t, u, v, w, x, y, z, aa, ab,
                  ac, ad, ae, af, ag, ah);
}
auto members(EnergyAccount& s) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q);
}
auto members(WheelSample& s) {
  auto& [a, b, c, d, e, f, g, h, i] = s;
  return std::tie(a, b, c, d, e, f, g, h, i);
}
auto members(PointSample& s) {
  auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
auto members(Sample& s) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
}
auto members(Quality& s) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
}
auto members(ItemResponse& s) {
  auto& [a, b, c, d, e, of_single_runs] = s;
  return std::tie(a, b, c, d, e);
}
auto members(Impact& s) {
  auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = s;
  return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
}
auto members(ZoneOutcome& s) {
  auto& [a, b, c, d, e] = s;
  return std::tie(a, b, c, d, e);
}
auto members(TetherOutcome& s) {
  auto& [a, b, c] = s;
  return std::tie(a, b, c);
}
auto members(Response& s) {
  auto& [a, b, c, d, e, f, g, h] = s;
  return std::tie(a, b, c, d, e, f, g, h);
}
auto members(StudyRun& s) {
  auto& [a, b, c, d, e, f, g, h] = s;
  return std::tie(a, b, c, d, e, f, g, h);
}
auto members(TaskCost& s) {
  auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
auto members(TaskResult& s) {
  auto& [a, b, c, d] = s;
  return std::tie(a, b, c, d);
}
auto members(Vector3& v) { return std::tie(v.x(), v.y(), v.z()); }
auto members(Quaternion& q) { return std::tie(q.w(), q.x(), q.y(), q.z()); }

/// Gives every number another value: 1.5, 2.5, ... (whole: 1, 2, ...); every list two elements.
class Filler {
 public:
  template <class T>
  void operator()(T& value) {
    ++next_;
    if constexpr (std::is_same_v<T, bool>)
      value = !value;
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(1 + next_ % 3);
    else if constexpr (std::is_floating_point_v<T>)
      value = 0.5 + next_;
    else if constexpr (std::is_arithmetic_v<T>)
      value = static_cast<T>(next_);
    else
      std::apply([&](auto&... each) { ((*this)(each), ...); }, members(value));
  }
  void operator()(std::string& text) { text = "text " + std::to_string(++next_) + '\0' + "x"; }
  template <class T>
  void operator()(std::vector<T>& list) {
    list.resize(2);
    for (T& each : list) (*this)(each);
  }
  template <class T, std::size_t n>
  void operator()(std::array<T, n>& list) {
    for (T& each : list) (*this)(each);
  }
  int filled() const { return next_; }

 private:
  int next_ = 0;
};

/// Numbers that differ.
struct Comparison {
  int differences = 0;

  template <class T>
  void operator()(T& a, T& b) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>)
      differences += a != b;
    else
      all(members(a), members(b));
  }
  template <class T>
  void operator()(std::vector<T>& a, std::vector<T>& b) {
    differences += a.size() != b.size();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) (*this)(a[i], b[i]);
  }
  template <class T, std::size_t n>
  void operator()(std::array<T, n>& a, std::array<T, n>& b) {
    for (std::size_t i = 0; i < n; ++i) (*this)(a[i], b[i]);
  }
  template <class... T>
  void all(std::tuple<T&...> a, std::tuple<T&...> b) {
    each(a, b, std::index_sequence_for<T...>());
  }
  template <class Tuple, std::size_t... i>
  void each(Tuple& a, Tuple& b, std::index_sequence<i...>) {
    ((*this)(std::get<i>(a), std::get<i>(b)), ...);
  }
};

TaskResult filled_result() {
  TaskResult result;
  Filler()(result);
  return result;
}

TEST(TaskBytes, GiveBackEveryMember) {
  TaskResult result = filled_result();
  TaskResult empty;
  Comparison against_defaults;
  against_defaults(result, empty);
  ASSERT_GT(against_defaults.differences, 0);
  TaskResult back = task_from_bytes(to_bytes(result));
  Comparison comparison;
  comparison(result, back);
  EXPECT_EQ(comparison.differences, 0);
  EXPECT_EQ(to_bytes(back), to_bytes(result));
}

TEST(TaskBytes, HaveEveryNumberThatIsFilledIn) {
  TaskResult result = filled_result();
  EXPECT_EQ(result.runs[1].response.items[1].history[1].wheels[7].mode != WheelMode::kSticks, true);
  TaskResult changed = filled_result();
  changed.runs[1].response.items[1].history[1].energy.numerical_loss += 1;
  EXPECT_NE(to_bytes(result), to_bytes(changed));
}

TEST(TaskBytes, ThatEndTooEarlyOrTooLateAreRefused) {
  TaskResult result;
  result.runs.resize(1);
  const std::string bytes = to_bytes(result);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(error_text([&] { task_from_bytes(bytes.substr(0, size)); }),
              "the bytes end too early")
        << size;
  EXPECT_EQ(error_text([&] { task_from_bytes(bytes + "x"); }),
            "there are more bytes than an analysis case has");
}

}  // namespace
}  // namespace gurney::study
