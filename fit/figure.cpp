#include "fit/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr int fewest_pictures = 6;
constexpr int fewest_samples = 5;      // of a pixel: two are spent on k_d and alpha
constexpr double least_spread = 0.15;  // radians along the trunk, of the lights
constexpr double steepest_dive = 0.7;  // radians
constexpr int tried_dives = 21;
constexpr int most_wood_pixels = 2000;  // that k_s and n are found from
constexpr double least_sharpness = 1.5;
// What the gloss must explain, over what it leaves. A lobe that may lie anywhere takes the largest
// of nine residuals away from each pixel, though there is nothing but noise: 1.3 times what is
// left.
constexpr double least_explained = 3.0;
constexpr double least_known = 0.35;  // standard deviation of ln n

/// What the pictures show of one pixel: brightness under light of strength 1.
struct Seen {
  std::vector<double> value, upright, delta;  // L, l_z, angle along the trunk
};

struct Gloss {
  double specular, sharpness;
};

/// One pixel under a gloss: its k_d and alpha, and what that leaves.
struct Local {
  double diffuse = 0.0, dive = 0.0, cost = HUGE_VAL;
};

double lobe(double angle, double sharpness) {
  return std::pow(std::max(std::cos(angle), 0.0), sharpness);
}

Local at_dive(const Seen& seen, const Gloss& gloss, double dive) {
  double up = 0.0, across = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < seen.value.size(); ++i) {
    const double matte =
        seen.value[i] - gloss.specular * lobe(seen.delta[i] - dive, gloss.sharpness);
    up += seen.upright[i] * seen.upright[i];
    across += seen.upright[i] * matte;
    squares += matte * matte;
  }
  const double diffuse = std::max(across / up, 0.0);
  return {diffuse, dive, squares - 2.0 * diffuse * across + diffuse * diffuse * up};
}

/// By trying dives, then by halving the steps around the best.
Local best_at(const Seen& seen, const Gloss& gloss) {
  constexpr double step = 2.0 * steepest_dive / (tried_dives - 1);
  Local best;
  for (int k = 0; k < tried_dives; ++k) {
    const Local tried = at_dive(seen, gloss, -steepest_dive + k * step);
    if (tried.cost < best.cost) best = tried;
  }
  // The cost is smooth: a parabola through three of them, closer each time.
  for (double reach = 0.5 * step; reach > 1e-5; reach *= 0.25) {
    const Local below = at_dive(seen, gloss, best.dive - reach);
    const Local above = at_dive(seen, gloss, best.dive + reach);
    const double curvature = below.cost - 2.0 * best.cost + above.cost;
    double shift = curvature > 0.0 ? 0.5 * (below.cost - above.cost) / curvature : 0.0;
    shift = std::clamp(shift, -1.0, 1.0);
    for (const Local& tried : {below, above, at_dive(seen, gloss, best.dive + shift * reach)}) {
      if (tried.cost < best.cost) best = tried;
    }
  }
  return best;
}

/// Derivatives of the pictures of a pixel with respect to k_d, alpha, ln k_s and ln n.
Eigen::Matrix<double, Eigen::Dynamic, 4> slopes_of(const Seen& seen, const Gloss& gloss,
                                                   const Local& local) {
  Eigen::Matrix<double, Eigen::Dynamic, 4> slopes(Eigen::Index(seen.value.size()), 4);
  for (std::size_t i = 0; i < seen.value.size(); ++i) {
    const double angle = seen.delta[i] - local.dive;
    const double cosine = std::max(std::cos(angle), 1e-9);
    const double gloss_here = gloss.specular * lobe(angle, gloss.sharpness);
    slopes.row(Eigen::Index(i)) << seen.upright[i],
        gloss_here * gloss.sharpness * std::sin(angle) / cosine, gloss_here,
        gloss_here * gloss.sharpness * std::log(cosine);
  }
  return slopes;
}

Eigen::VectorXd rest_of(const Seen& seen, const Gloss& gloss, const Local& local) {
  Eigen::VectorXd rest(Eigen::Index(seen.value.size()));
  for (std::size_t i = 0; i < seen.value.size(); ++i) {
    rest[Eigen::Index(i)] = seen.value[i] - local.diffuse * seen.upright[i] -
                            gloss.specular * lobe(seen.delta[i] - local.dive, gloss.sharpness);
  }
  return rest;
}

/// The normal equations of ln k_s and ln n, k_d and alpha of every pixel eliminated.
struct Projected {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double cost = 0.0;
  double spare = 0.0;  // samples that no pixel spends
};

Projected projected(const std::vector<Seen>& pixels, const Gloss& gloss) {
  std::vector<Projected> parts(pixels.size());
  for_each_index(int(pixels.size()), [&](int k) {
    const Seen& seen = pixels[std::size_t(k)];
    const Local local = best_at(seen, gloss);
    const auto slopes = slopes_of(seen, gloss, local);
    const Eigen::VectorXd rest = rest_of(seen, gloss, local);
    const auto own = slopes.leftCols<2>();
    const auto shared = slopes.rightCols<2>();
    Eigen::Matrix2d inner = own.transpose() * own;
    inner.diagonal().array() += 1e-12 * (inner.trace() + 1e-300);
    const Eigen::LDLT<Eigen::Matrix2d> solver(inner);
    const Eigen::Matrix2d carried = solver.solve(own.transpose() * shared);
    auto& part = parts[std::size_t(k)];
    part.normal = shared.transpose() * shared - shared.transpose() * own * carried;
    part.right = shared.transpose() * rest - carried.transpose() * (own.transpose() * rest);
    part.cost = rest.squaredNorm();
    part.spare = double(seen.value.size()) - 2.0;
  });
  Projected sum;
  for (const Projected& part : parts) {
    sum.normal += part.normal;
    sum.right += part.right;
    sum.cost += part.cost;
    sum.spare += part.spare;
  }
  return sum;
}

/// What is left where every pixel is matte.
double matte_cost(const std::vector<Seen>& pixels) {
  double cost = 0.0;
  for (const Seen& seen : pixels) cost += at_dive(seen, {0.0, 1.0}, 0.0).cost;
  return cost;
}

/// Levenberg and Marquardt's descent from `gloss`.
Gloss descended(const std::vector<Seen>& pixels, Gloss gloss, Projected& at) {
  double damping = 1e-3;
  at = projected(pixels, gloss);
  for (int round = 0; round < 40; ++round) {
    Eigen::Matrix2d damped = at.normal;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::Vector2d move = damped.ldlt().solve(at.right).cwiseMax(-0.7).cwiseMin(0.7).eval();
    const Gloss next{gloss.specular * std::exp(move[0]),
                     std::clamp(gloss.sharpness * std::exp(move[1]), 1.0, 1000.0)};
    const Projected there = projected(pixels, next);
    if (there.cost < at.cost) {
      const bool settled = at.cost - there.cost < 1e-9 * at.cost;
      gloss = next;
      at = there;
      damping *= 0.3;
      if (settled) break;
    } else {
      damping *= 6.0;
      if (damping > 1e6) break;
    }
  }
  return gloss;
}

Seen seen_at(const LightStack& stack, const Eigen::Vector2d& trunk, int row, int col) {
  Seen seen;
  const Eigen::Vector2d place = stack.extent().place(row, col);
  for (std::size_t i = 0; i < stack.images.size(); ++i) {
    const Sample sample = stack.samples[i](row, col);
    if (sample == Sample::saturated || sample == Sample::shadowed) continue;
    const auto& planes = stack.images[i].planes;
    double value = 0.0;
    Eigen::Vector3d towards = Eigen::Vector3d::Zero();
    for (std::size_t c = 0; c < planes.size(); ++c) {
      const Eigen::Vector3d light = arriving(stack.lights[i], int(c), {place.x(), place.y(), 0.0});
      value += planes[c](row, col) / light.norm() / double(planes.size());
      towards = light;
    }
    towards.normalize();
    if (!(towards.z() > 0.0) || !std::isfinite(value)) continue;
    seen.value.push_back(value);
    seen.upright.push_back(towards.z());
    seen.delta.push_back(std::asin(std::clamp(towards.head<2>().dot(trunk), -1.0, 1.0)));
  }
  return seen;
}

}  // namespace

Figure figure_of(const LightStack& stack, const FigureOptions& options) {
  if (int(stack.images.size()) < fewest_pictures) {
    throw Error("figure: " + std::to_string(stack.images.size()) +
                " pictures are too few to tell gloss from colour; take at least 6, better 9");
  }
  const Eigen::Vector2d trunk(std::cos(options.trunk_rad), std::sin(options.trunk_rad));
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (const Light& light : stack.lights) {
    const double along = std::asin(std::clamp(light.direction.head<2>().dot(trunk), -1.0, 1.0));
    lowest = std::min(lowest, along);
    highest = std::max(highest, along);
  }
  if (highest - lowest < least_spread) {
    throw Error(
        "figure: the lights hardly differ along the trunk; move the lamp up and down it, or say "
        "how the trunk lies (--trunk)");
  }

  const int rows = stack.mask.rows(), cols = stack.mask.cols();
  double inside = 0.0;
  for (const auto value : stack.mask) inside += value ? 1.0 : 0.0;
  const int stride = std::max(1, int(std::sqrt(inside / most_wood_pixels)));
  std::vector<Seen> pixels;
  for (int row = 0; row < rows; row += stride) {
    for (int col = 0; col < cols; col += stride) {
      if (!stack.mask(row, col)) continue;
      Seen seen = seen_at(stack, trunk, row, col);
      if (int(seen.value.size()) >= fewest_samples) pixels.push_back(std::move(seen));
    }
  }
  if (pixels.size() < 30) {
    throw Error("figure: hardly a pixel is seen in enough pictures; check mask and exposure");
  }

  double mean = 0.0, samples = 0.0;
  for (const Seen& seen : pixels) {
    for (const double value : seen.value) mean += value;
    samples += double(seen.value.size());
  }
  mean /= samples;
  Gloss best{};
  Projected at;
  at.cost = HUGE_VAL;
  for (const double sharpness : {6.0, 25.0, 100.0}) {
    Projected there;
    const Gloss gloss = descended(pixels, {0.4 * mean, sharpness}, there);
    if (there.cost >= at.cost) continue;
    best = gloss;
    at = there;
  }

  const double variance = at.cost / std::max(at.spare - 2.0, 1.0);
  Eigen::Matrix2d information = at.normal / std::max(variance, 1e-300);
  information.diagonal().array() += 1e-12;
  const Eigen::Matrix2d covariance = information.inverse();
  const double known = std::sqrt(std::max(covariance(1, 1), 0.0));
  const bool explains = matte_cost(pixels) - at.cost > least_explained * at.cost;
  if (best.sharpness < least_sharpness || !(known < least_known) || !explains) {
    throw Error(
        "figure: no lobe of gloss can be told from diffuse light (n near 1, or no gloss at all); "
        "polish or varnish the cut, or spread the lights further along the trunk");
  }

  Figure figure;
  figure.specular = best.specular;
  figure.sharpness = best.sharpness;
  figure.specular_sigma = best.specular * std::sqrt(covariance(0, 0));
  figure.sharpness_sigma = best.sharpness * known;
  figure.residual = std::sqrt(variance);
  figure.diffuse = Grid<float>(rows, cols, 0.0f);
  figure.dive_rad = figure.dive_sigma = figure.diffuse;
  figure.mask = Mask(rows, cols, 0);
  for_each_index(rows, [&](int row) {
    for (int col = 0; col < cols; ++col) {
      if (!stack.mask(row, col)) continue;
      const Seen seen = seen_at(stack, trunk, row, col);
      if (int(seen.value.size()) < fewest_samples) continue;
      const Local local = best_at(seen, best);
      const auto own = slopes_of(seen, best, local).leftCols<2>().eval();
      const Eigen::Matrix2d inner = own.transpose() * own;
      const double determinant = inner.determinant();
      figure.mask(row, col) = 1;
      figure.diffuse(row, col) = float(local.diffuse);
      figure.dive_rad(row, col) = float(local.dive);
      // Where no light comes near the lobe nothing is known of the dive but its bounds.
      figure.dive_sigma(row, col) = float(
          std::min(determinant > 0.0 ? std::sqrt(variance * inner(0, 0) / determinant) : HUGE_VAL,
                   steepest_dive / std::sqrt(3.0)));
    }
  });
  return figure;
}

}  // namespace hada
