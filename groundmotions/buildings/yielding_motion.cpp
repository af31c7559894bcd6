#include "groundmotions/buildings/yielding_motion.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "groundmotions/buildings/isolation.h"
#include "groundmotions/buildings/modal_building.h"
#include "groundmotions/buildings/torsion.h"

namespace gurney::groundmotions {
namespace {

constexpr int kMaxIterations = 100;
/// Change of the mean velocity at which a solve ends, over its size: rounding is 1e-16, and floor motions
/// are wanted to 1e-3 (floor_record.cpp).
constexpr double kTolerance = 1e-12;

/// C of a damping ratio for each mode.
Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                              const Eigen::VectorXd& ratios) {
  const auto [squared_frequencies, shapes] = natural_modes(stiffness, mass);
  const Eigen::MatrixXd momenta = mass * shapes;
  const Eigen::VectorXd viscosities = 2 * ratios.array() * squared_frequencies.array().sqrt();
  return momenta * viscosities.asDiagonal() * momenta.transpose();
}

Vector2 forces_of(const std::array<PinchedLoop, 2>& loops) {
  return {loops[0].force, loops[1].force};
}

/// Shears at a place as ones at the axis and a torque.
Vector3 about_axis(const Vector2& place, const Vector2& shear) {
  return {shear.x(), shear.y(), place.x() * shear.y() - place.y() * shear.x()};
}

}  // namespace

YieldingMotion::Block YieldingMotion::block_of(std::vector<Eigen::Index> rows) const {
  const Eigen::VectorXd& mass = storeys_.mass;
  const Eigen::Index n = mass.size();
  TwistingMatrices m;
  Eigen::VectorXd ratios;
  if (const auto& twist = storeys_.twist) {
    const Eigen::VectorXd torsional =
        (storeys_.stiffness[0].array() * twist->columns.row(1).transpose().array().square() +
         storeys_.stiffness[1].array() * twist->columns.row(0).transpose().array().square()) /
        (gyration_ * gyration_);
    m = twisting_matrices(
        mass, twist->eccentricity, gyration_,
        {shear_stiffness(storeys_.stiffness[0]), shear_stiffness(storeys_.stiffness[1])},
        shear_stiffness(torsional));
    ratios = twist->damping;
  } else {
    const Eigen::Index a = rows.front();
    m = {mass.asDiagonal(), shear_stiffness(storeys_.stiffness[static_cast<std::size_t>(a)]),
         Eigen::MatrixXd::Zero(n, 2)};
    m.carried.col(a).setOnes();
    ratios = storeys_.damping[static_cast<std::size_t>(a)];
  }
  const Eigen::MatrixXd damping = modal_damping(m.mass, m.stiffness, ratios);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(m.mass.rows());
  return {std::move(rows),
          m.mass,
          damping,
          m.mass * m.carried,
          rest,
          rest,
          SymmetricFactors(2 / h_ * m.mass + damping + h_ / 2 * m.stiffness)};
}

YieldingMotion::YieldingMotion(const YieldingStoreys& storeys, double time_step)
    : storeys_(storeys),
      h_(time_step),
      gyration_(storeys.twist ? storeys.twist->gyration : 1.0),
      columns_(static_cast<std::size_t>(storeys.mass.size())),
      drift_(Eigen::Matrix3Xd::Zero(3, storeys.mass.size())),
      increment_(drift_),
      mean_force_(drift_) {
  assert(time_step > 0 && storeys.hardening >= 0 && storeys.hardening < 1);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto storey = static_cast<Eigen::Index>(i);
    const Vector2 whole(storeys.stiffness[0][storey], storeys.stiffness[1][storey]);
    std::vector<Vector2> places = {Vector2::Zero()};
    if (storeys.twist) {
      const double a = storeys.twist->columns(0, storey), b = storeys.twist->columns(1, storey);
      places = {{a, b}, {-a, b}, {-a, -b}, {a, -b}};
    }
    for (const Vector2& place : places)
      columns_[i].push_back(
          {place, whole / static_cast<double>(places.size()), Vector2::Zero(), Vector2::Zero()});
  }
  if (storeys.twist)
    blocks_ = {block_of({0, 1, 2})};
  else
    blocks_ = {block_of({0}), block_of({1})};
}

void YieldingMotion::find_increments() {
  const Eigen::Index n = drift_.cols();
  for (const Block& block : blocks_)
    for (std::size_t k = 0; k < block.rows.size(); ++k) {
      const auto floors = block.mean_velocity.segment(static_cast<Eigen::Index>(k) * n, n);
      for (Eigen::Index i = 0; i < n; ++i)
        increment_(block.rows[k], i) = h_ * (i > 0 ? floors[i] - floors[i - 1] : floors[i]);
    }
  increment_.row(2) /= gyration_;
}

void YieldingMotion::find_mean_forces() {
  mean_force_.setZero();
  for (Eigen::Index i = 0; i < drift_.cols(); ++i) {
    const double yield = storeys_.yield_drift[i];
    for (Column& column : columns_[static_cast<std::size_t>(i)]) {
      mean_force_.col(i) +=
          about_axis(column.place, mean_shear(column, yield, at_place(column.place, drift_.col(i)),
                                              at_place(column.place, increment_.col(i))));
    }
  }
}

Vector2 YieldingMotion::mean_shear(Column& column, double yield, const Vector2& start,
                                   const Vector2& way) const {
  const double alpha = storeys_.hardening;
  if (!storeys_.pinching) {
    const Sliding slid = slide(column.z, way / yield);
    column.next_z = slid.end;
    const Vector2 middle = start + way / 2;
    return column.stiffness.cwiseProduct(alpha * middle + (1 - alpha) * yield * slid.mean);
  }
  Vector2 mean;
  for (std::size_t a = 0; a < 2; ++a) {
    const auto k = static_cast<Eigen::Index>(a);
    const PinchedMove moved = move(column.loops[a], way[k] / yield, alpha, *storeys_.pinching);
    column.next_loops[a] = moved.end;
    mean[k] = column.stiffness[k] * yield * moved.mean;
  }
  return mean;
}

Vector2 YieldingMotion::shear(const Column& column, double yield, const Vector2& drift) const {
  const double alpha = storeys_.hardening;
  if (!storeys_.pinching)
    return column.stiffness.cwiseProduct(alpha * drift + (1 - alpha) * yield * column.z);
  return yield * column.stiffness.cwiseProduct(forces_of(column.loops));
}

Vector3 YieldingMotion::force(Eigen::Index storey) const {
  Vector3 result = Vector3::Zero();
  for (const Column& column : columns_[static_cast<std::size_t>(storey)])
    result += about_axis(column.place, shear(column, storeys_.yield_drift[storey],
                                             at_place(column.place, drift_.col(storey))));
  return result;
}

void YieldingMotion::find_residual(Block& block) const {
  const Eigen::Index n = drift_.cols();
  block.scratch = block.mean_velocity - block.velocity;
  block.residual.noalias() = block.mass * (2 / h_ * block.scratch);
  block.scratch.noalias() = block.damping * block.mean_velocity;
  block.residual += block.scratch;
  for (std::size_t k = 0; k < block.rows.size(); ++k) {
    const Eigen::Index row = block.rows[k], first = static_cast<Eigen::Index>(k) * n;
    const double scale = row == 2 ? gyration_ : 1;  // from a torque to r theta
    for (Eigen::Index i = 0; i < n; ++i) {
      const double below = mean_force_(row, i) / scale;
      block.residual[first + i] += i + 1 < n ? below - mean_force_(row, i + 1) / scale : below;
    }
  }
  block.residual += block.push;
}

void YieldingMotion::step(const Vector2& ground0, const Vector2& ground1) {
  const Vector2 ground = (ground0 + ground1) / 2;
  for (Block& block : blocks_) block.push.noalias() = block.carried * ground;
  // The elastic slope is the largest that mean forces have: with it the fixed point contracts, by
  // (omega h / 2)^2 / (1 + (omega h / 2)^2) at most.
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    find_increments();
    find_mean_forces();
    double change = 0, size = 0;
    for (Block& block : blocks_) {
      find_residual(block);
      block.solve.solve_in_place(block.residual);
      block.mean_velocity -= block.residual;
      change = std::max(change, block.residual.cwiseAbs().maxCoeff());
      size = std::max(size, block.mean_velocity.cwiseAbs().maxCoeff());
    }
    if (change <= kTolerance * size) break;
  }
  find_increments();
  find_mean_forces();

  energy_.kinetic = energy_.strain = 0;
  for (Block& block : blocks_) {
    const Eigen::VectorXd& mean = block.mean_velocity;
    block.velocity = 2 * mean - block.velocity;
    energy_.input -= h_ * block.push.dot(mean);
    block.scratch.noalias() = block.damping * mean;
    energy_.damping += h_ * mean.dot(block.scratch);
    block.scratch.noalias() = block.mass * block.velocity;
    energy_.kinetic += block.velocity.dot(block.scratch) / 2;
  }
  for (Eigen::Index i = 0; i < drift_.cols(); ++i) {
    energy_.hysteresis += mean_force_.col(i).dot(increment_.col(i));
    for (Column& column : columns_[static_cast<std::size_t>(i)]) {
      Vector2 elastic = storeys_.hardening * column.stiffness;
      Vector2 start = at_place(column.place, drift_.col(i)),
              end = start + at_place(column.place, increment_.col(i));
      if (storeys_.pinching) {  // drifts that unloading would take back
        elastic = column.stiffness;
        start = storeys_.yield_drift[i] * forces_of(column.loops);
        end = storeys_.yield_drift[i] * forces_of(column.next_loops);
        column.loops = column.next_loops;
      }
      energy_.strain += elastic.dot(end.cwiseAbs2()) / 2;
      energy_.hysteresis -= elastic.dot((end.cwiseAbs2() - start.cwiseAbs2())) / 2;
      column.z = column.next_z;
    }
  }
  drift_ += increment_;
}

Vector3 YieldingMotion::floor_acceleration(Eigen::Index floor, const Vector2& place) const {
  const Eigen::Index n = drift_.cols(), i = floor - 1;
  Vector3 push = Vector3::Zero();
  for (const Block& block : blocks_)
    for (std::size_t k = 0; k < block.rows.size(); ++k)
      push[block.rows[k]] =
          -block.damping.row(static_cast<Eigen::Index>(k) * n + i).dot(block.velocity);
  push.z() *= gyration_;  // from r theta to a torque
  push -= force(i);
  if (floor < n) push += force(floor);
  if (!storeys_.twist) return {push.x() / storeys_.mass[i], push.y() / storeys_.mass[i], 0};
  // Newton at the centre of mass e, Euler about it: m r^2 theta'' = torque - e x force.
  const Vector2 e = storeys_.twist->eccentricity.col(i), centre = push.head<2>() / storeys_.mass[i];
  const double yaw = (push.z() / storeys_.mass[i] - e.x() * centre.y() + e.y() * centre.x()) /
                     (gyration_ * gyration_);
  const Vector2 there = at_place(place - e, Vector3(centre.x(), centre.y(), yaw));
  return {there.x(), there.y(), yaw};
}

double YieldingMotion::yaw(Eigen::Index floor) const { return drift_.row(2).head(floor).sum(); }

Eigen::VectorXd YieldingMotion::column_drift() const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(drift_.cols());
  for (Eigen::Index i = 0; i < result.size(); ++i)
    for (const Column& column : columns_[static_cast<std::size_t>(i)])
      result[i] = std::max(result[i], at_place(column.place, drift_.col(i)).norm());
  return result;
}

}  // namespace gurney::groundmotions
