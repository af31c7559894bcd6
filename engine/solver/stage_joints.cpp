#include "engine/solver/quadrature.h"
#include "engine/solver/stage_solver.h"

// Joints between items in a stage.
namespace gurney {

void StageSolver::update_joints(const Input& input, const std::vector<Velocity>& v) {
  joints_.clear();
  for (std::size_t j : input.island->joints) {
    if (input.riders && input.riders->rests(j)) continue;
    JointWork& work = joints_.emplace_back();
    work.index = j;
    work.law = &assembly_.joints[j];
    work.stage.tau = input.tau;
    work.stage.ahead = input.loads.first ? kSdirkExtrapolation : 0;
    work.stage.start = input.start->joints[j];
    work.stage.rows = work.law->rows(items_[work.base()].pose(), items_[work.part()].pose(),
                                     work.stage.start.coordinate);
    for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
      JointLaw::Row& row = work.stage.rows.rows[r];
      // The law takes e at zero rate: it ends at e + tau u.
      row.value -= input.tau * row.rate(v[work.part()].chassis, v[work.base()].chassis);
    }
  }
}

void StageSolver::add_joint_forces(const std::vector<Velocity>& v) {
  for (JointWork& work : joints_)
    for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
      const JointLaw::Row& row = work.stage.rows.rows[r];
      work.rates[r] = row.rate(v[work.part()].chassis, v[work.base()].chassis);
      work.forces[r] = work.law->force(work.stage, r, work.rates[r]);
      items_[work.part()].add_force(row.part, -work.forces[r].force);
      items_[work.base()].add_force(row.base, work.forces[r].force);
    }
}

void StageSolver::add_joint_slopes() {
  for (const JointWork& work : joints_)
    for (std::size_t r = 0; r < work.stage.rows.count; ++r) {
      const JointLaw::Row& row = work.stage.rows.rows[r];
      items_[work.part()].add_slope(row.part, work.forces[r].slope);
      items_[work.base()].add_slope(row.base, work.forces[r].slope);
    }
}

void StageSolver::finish_joints(const Input& input, Output& out) const {
  out.end.joints.resize(input.start->joints.size());
  for (std::size_t j : input.island->joints) out.end.joints[j] = input.start->joints[j];
  for (const JointWork& work : joints_) {
    ItemStage::Output& part = out.items[work.part()];
    part.spring_rates +=
        work.law->finish(work.stage, work.rates, part.power, out.end.joints[work.index]);
    // Power of T on the base is work between the two; what is left of it on the part, -T u, is in losses and springs.
    double given = 0;
    for (std::size_t r = 0; r < work.stage.rows.count; ++r)
      given += work.forces[r].force * work.stage.rows.rows[r].base.dot(v_[work.base()].chassis);
    part.power.work_of_neighbours -= given;
    out.items[work.base()].power.work_of_neighbours += given;
  }
}

}  // namespace gurney
