#include "capture/joint_problem.h"

#include <algorithm>
#include <cmath>

#include "capture/light_cost.h"

namespace hada {
namespace {

ceres::LossFunction* robust(double weight = 1.0) {
  auto* cauchy = new ceres::CauchyLoss(JointProblem::robust_width);
  return new ceres::ScaledLoss(cauchy, weight, ceres::TAKE_OWNERSHIP);
}

constexpr JointProblem::Row other{JointProblem::Row::Kind::other, 0};

// Which part of a square from -1 to 1, cut into `parts` x `parts`, a place lies in.
int part_of(const Eigen::Vector2d& place, int parts) {
  const auto index = [&](double x) {
    return std::clamp(int(std::floor(0.5 * (x + 1.0) * parts)), 0, parts - 1);
  };
  return index(place.y()) * parts + index(place.x());
}

// How large things are in this scene.
double largest_radius(const JointState& state) {
  double radius = 0.0;
  for (const SphereState& sphere : state.spheres) radius = std::max(radius, sphere.prior[2]);
  return radius;
}

}  // namespace

JointProblem::JointProblem(JointState& state, const Evidence& evidence, LampModel model) {
  for (LightState& light : state.lights) {
    problem.AddParameterBlock(light.direction.data(), 3, new ceres::SphereManifold<3>);
    problem.AddParameterBlock(&light.log_strength, 1);
    problem.AddParameterBlock(&light.inverse_distance, 1);
    shared.insert(shared.end(),
                  {light.direction.data(), &light.log_strength, &light.inverse_distance});
    problem.SetParameterLowerBound(&light.inverse_distance, 0, 0.0);  // no lamp is behind infinity
    if (model == LampModel::distant) problem.SetParameterBlockConstant(&light.inverse_distance);
  }
  problem.AddParameterBlock(&state.table, 1);
  shared.push_back(&state.table);
  for (SphereState& sphere : state.spheres) {
    problem.AddParameterBlock(sphere.place.data(), 3);
    shared.push_back(sphere.place.data());
  }
  for (const MatteEvidence& seen : evidence.matte) add_matte(state, seen);
  for (const ChromeEvidence& seen : evidence.chrome) add_chrome(state, seen);
  if (!state.sheet.empty()) add_sheet(state, evidence.sheet);
  add_priors(state);
}

void JointProblem::add(ceres::CostFunction* cost, ceres::LossFunction* loss, Row row,
                       const std::vector<double*>& unknowns) {
  blocks.push_back(problem.AddResidualBlock(cost, loss, unknowns));
  rows.insert(rows.end(), std::size_t(cost->num_residuals()), row);
}

void JointProblem::add_matte(JointState& state, const MatteEvidence& seen) {
  SphereState& sphere = state.spheres[seen.sphere];
  problem.AddParameterBlock(sphere.surface.data(), 2);
  problem.SetParameterLowerBound(sphere.surface.data(), 1, 0.0);
  problem.SetParameterUpperBound(sphere.surface.data(), 1, 1.0);
  shared.push_back(sphere.surface.data());
  constexpr int parts = 4;
  const int first = int(seen.sphere * state.lights.size()) * parts * parts;
  for (std::size_t k = 0; k < state.lights.size(); ++k) {
    LightState& light = state.lights[k];
    for (std::size_t i = 0; i < seen.rays.size(); ++i) {
      if (std::isnan(seen.values[k][i])) continue;
      using Cost = ceres::AutoDiffCostFunction<MatteCost, 1, 3, 1, 1, 1, 3, 2>;
      add(new Cost(new MatteCost{seen.rays[i], seen.bends[i], seen.values[k][i], seen.thrown[k][i],
                                 &sphere.ambient[k], &sphere.sigma}),
          robust(),
          {Row::Kind::matte, first + int(k) * parts * parts + part_of(seen.places[i], parts)},
          {light.direction.data(), &light.log_strength, &light.inverse_distance, &state.table,
           sphere.place.data(), sphere.surface.data()});
    }
  }
}

void JointProblem::add_chrome(JointState& state, const ChromeEvidence& seen) {
  LightState& light = state.lights[seen.light];
  SphereState& sphere = state.spheres[seen.sphere];
  using Cost = ceres::AutoDiffCostFunction<ChromeCost, 2, 3, 1, 1, 3>;
  add(new Cost(new ChromeCost{seen.ray, seen.offset, across(vector_of(light.direction.data())),
                              &sphere.sigma}),
      robust(state.mirror_weight), {Row::Kind::chrome, 0},
      {light.direction.data(), &light.inverse_distance, &state.table, sphere.place.data()});
}

void JointProblem::add_sheet(JointState& state, const SheetEvidence& seen) {
  Eigen::Vector3d reach = Eigen::Vector3d::Constant(1e-12);
  for (const auto& point : seen.points) reach = reach.cwiseMax((point - seen.center).cwiseAbs());
  constexpr int parts = 8;
  const double relief_sigma = 0.1 * largest_radius(state);
  problem.AddParameterBlock(&state.sheet_ambient, 1);
  if (state.sheet_ambient_sigma > 0.0) {
    shared.push_back(&state.sheet_ambient);
    using Number = ceres::AutoDiffCostFunction<PriorCost<1>, 1, 1>;
    using One = Eigen::Matrix<double, 1, 1>;
    add(new Number(new PriorCost<1>{One(0.0), One(state.sheet_ambient_sigma)}), nullptr, other,
        {&state.sheet_ambient});
  } else {
    problem.SetParameterBlockConstant(&state.sheet_ambient);
  }
  for (std::size_t p = 0; p < seen.points.size(); ++p) {
    double* const pixel = state.sheet[p].data();
    problem.AddParameterBlock(pixel, 4);
    sheet.push_back(pixel);
    using Relief = ceres::AutoDiffCostFunction<ReliefCost, 1, 4>;
    add(new Relief(new ReliefCost{relief_sigma}), nullptr, other, {pixel});
    const Eigen::Vector2d place = (seen.points[p] - seen.center).head<2>();
    const int part = part_of(place.cwiseQuotient(reach.head<2>()), parts);
    for (std::size_t k = 0; k < state.lights.size(); ++k) {
      if (std::isnan(seen.values[p][k])) continue;
      LightState& light = state.lights[k];
      using Cost = ceres::AutoDiffCostFunction<SheetCost, 1, 3, 1, 1, 1, 4>;
      add(new Cost(new SheetCost{seen.points[p], seen.values[p][k], &state.sheet_sigma}), robust(),
          {Row::Kind::sheet, int(k) * parts * parts + part},
          {light.direction.data(), &light.log_strength, &light.inverse_distance,
           &state.sheet_ambient, pixel});
    }
  }
}

// Weak ones hold what the evidence leaves open: the scale of all strengths together, a reflectance
// that nothing shines on, the height of the table; the outline is what a sphere's place is known
// by.
void JointProblem::add_priors(JointState& state) {
  using One = Eigen::Matrix<double, 1, 1>;
  using Number = ceres::AutoDiffCostFunction<PriorCost<1>, 1, 1>;
  for (LightState& light : state.lights) {
    add(new Number(new PriorCost<1>{One(0.0), One(state.strength_sigma)}), nullptr, other,
        {&light.log_strength});
    // Where nothing tells how far a lamp is, it is at least not inside the scene.
    add(new Number(new PriorCost<1>{One(0.0), One(0.5 / largest_radius(state))}), nullptr, other,
        {&light.inverse_distance});
  }
  constexpr double table_sigma = 0.3;  // of the radius: a sheet bulges, and has something under it
  add(new Number(new PriorCost<1>{One(0.0), One(table_sigma * largest_radius(state))}), nullptr,
      other, {&state.table});
  for (SphereState& sphere : state.spheres) {
    using Place = ceres::AutoDiffCostFunction<OutlineCost, 3, 3, 1>;
    const bool matte = problem.HasParameterBlock(sphere.surface.data());
    const double weight = matte ? 1.0 : state.mirror_weight;
    add(new Place(new OutlineCost{vector_of(sphere.prior.data()), sphere.prior_sigma, state.eye}),
        new ceres::ScaledLoss(nullptr, weight, ceres::TAKE_OWNERSHIP), other,
        {sphere.place.data(), &state.table});
    if (!matte) continue;
    using Surface = ceres::AutoDiffCostFunction<PriorCost<2>, 2, 2>;
    add(new Surface(new PriorCost<2>{{sphere.surface[0], 0.5}, {10.0, 0.3}}), nullptr, other,
        {sphere.surface.data()});
  }
}

}  // namespace hada
