#include "reconstruct/band.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reconstruct/judge.h"
#include "reconstruct/least_squares.h"
#include "reconstruct/robust_pca.h"
#include "reconstruct/unit_normals.h"

namespace hada {
namespace {

// With twelve lights a tile stays in the second cache. Not a power of two: the samples of a pixel
// would displace each other from the first one.
constexpr int tile_pixels = 1032;

// Pixels of one row that lie together in a tile.
struct Run {
  int first;  // in the tile
  int row, col, count;
};

LightDoubt doubt_of(const LightStack& stack) {
  LightDoubt doubt;
  for (const Light& light : stack.lights) {
    doubt.tilt_squared.push_back(float(light.direction_sigma * light.direction_sigma));
  }
  for (const LightErrorMode& mode : stack.light_errors) {
    for (std::size_t k = 0; k < mode.size(); ++k) {
      const Eigen::Vector3d relative = mode[k] / stack.lights[k].strength.mean();
      for (int axis = 0; axis < 3; ++axis) doubt.modes.push_back(float(relative[axis]));
    }
  }
  return doubt;
}

// Everything one thread needs.
struct Workspace {
  Tile tile;
  TileSolver solver;
  Judgement judgement;
  LightDoubt doubt;
  GreyRows rows;
  std::vector<float> inside, shading, channel, product, squares;

  Workspace(const TileSource& source, const NormalPlan& plan, int pixels, bool keep_weights)
      : tile(source.tile(pixels, plan.shared)),
        solver(plan, tile, keep_weights),
        judgement(tile.lights, pixels),
        doubt(doubt_of(source.stack)),
        inside(std::size_t(tile.stride)) {}
};

// rho of I = rho * shading by weighted least squares, in one channel.
void channel_albedo(const TileSource& source, Workspace& work, const Run& run, int channel,
                    Grid<float>& albedo) {
  const Tile& tile = work.tile;
  source.fill_channel(tile, channel, run.row, run.col, work.channel);
  std::vector<float>& product = work.product;
  std::vector<float>& squares = work.squares;
  product.assign(std::size_t(run.count), 0.0f);
  squares.assign(std::size_t(run.count), 0.0f);
  for (int k = 0; k < tile.lights; ++k) {
    const std::size_t begin = tile.at(k, run.first);
    const float* weight = &tile.weight[begin];
    const float* shading = &work.shading[begin];
    const float* value = &work.channel[begin];
    for (std::size_t i = 0; i < product.size(); ++i) {
      product[i] += weight[i] * shading[i] * value[i];
      squares[i] += weight[i] * shading[i] * shading[i];
    }
  }
  const auto out = albedo.row(run.row).subspan(std::size_t(run.col), std::size_t(run.count));
  for (std::size_t i = 0; i < product.size(); ++i) {
    out[i] = squares[i] > 0.0f ? product[i] / squares[i] : 0.0f;
  }
}

void put(const TileSource& source, const NormalPlan& plan, const std::vector<Run>& runs,
         Workspace& work, NormalMaps& maps) {
  const Tile& tile = work.tile;
  Orientation& found = maps.orientation;
  const bool coloured = found.albedo.channels() > 1;
  if (coloured) shading_of(tile, plan.terms, work.shading);
  for (const Run& run : runs) {
    const auto col = std::size_t(run.col);
    put_unit_normals(tile, run.first, run.count,
                     {.normals = found.normals.row(run.row)[col].data(),
                      .rho = &found.rho.row(run.row)[col],
                      .mask = &found.mask.row(run.row)[col]});
    if (!coloured) continue;
    for (int c = 0; c < found.albedo.channels(); ++c) {
      channel_albedo(source, work, run, c, found.albedo.planes[std::size_t(c)]);
    }
  }
}

void put_judgement(const std::vector<Run>& runs, Workspace& work, NormalMaps& maps) {
  const Tile& tile = work.tile;
  Judgement& judgement = work.judgement;
  const Mask& mask = maps.orientation.mask;
  std::fill(work.inside.begin(), work.inside.end(), 0.0f);
  for (const Run& run : runs) {
    for (int i = 0; i < run.count; ++i) {
      const auto pixel = std::size_t(run.first + i);
      const bool valid = mask(run.row, run.col + i) != 0 && tile.z[pixel] > 0.0f;
      work.inside[pixel] = valid ? 1.0f : 0.0f;
    }
  }
  judge(tile, work.doubt, work.inside, judgement);
  for (const Run& run : runs) {
    for (int i = 0; i < run.count; ++i) {
      const auto pixel = std::size_t(run.first + i);
      if (work.inside[pixel] == 0.0f) continue;
      const int col = run.col + i;
      maps.residuals.squares(run.row, col) = judgement.squares[pixel];
      maps.residuals.freedom(run.row, col) = judgement.freedom[pixel];
      maps.noise_gain(run.row, col) = judgement.noise_gain[pixel];
      maps.light_variance(run.row, col) = judgement.light_variance[pixel];
      maps.albedo_gain(run.row, col) = judgement.albedo_gain[pixel];
      maps.orientation.inliers(run.row, col) =
          std::uint8_t(std::min(255.0f, judgement.inliers[pixel]));
    }
  }
}

LightSums sums_of(Judgement& judgement) {
  LightSums sums{judgement.picture, judgement.used, judgement.used_picture, judgement.left_out};
  for (auto* values :
       {&judgement.picture, &judgement.used, &judgement.used_picture, &judgement.left_out}) {
    std::fill(values->begin(), values->end(), 0.0);
  }
  return sums;
}

bool any_inside(const Mask& mask, int row, int col, int count) {
  const auto pixels = mask.row(row).subspan(std::size_t(col), std::size_t(count));
  return std::any_of(pixels.begin(), pixels.end(), [](auto inside) { return inside != 0; });
}

std::vector<LightSums> solve_together(const TileSource& source, const NormalPlan& plan, int begin,
                                      int end, bool uncertainty, NormalMaps& maps) {
  std::vector<Run> runs;
  int pixels = 0;
  const Mask& mask = source.stack.mask;
  for (int row = begin; row < end; ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      if (runs.empty() || runs.back().row != row || runs.back().col + runs.back().count != col) {
        runs.push_back({pixels, row, col, 0});
      }
      ++runs.back().count;
      ++pixels;
    }
  }
  if (pixels == 0) return {};
  Workspace work(source, plan, pixels, true);
  for (const Run& run : runs) source.fill(work.tile, run.first, run.row, run.col, run.count);
  source.let_go(begin, end);
  fit_robust_pca(work.tile);
  if (uncertainty) put_judgement(runs, work, maps);
  put(source, plan, runs, work, maps);
  if (!uncertainty) return {};
  return {sums_of(work.judgement)};
}

}  // namespace

void LightSums::add(const LightSums& other) {
  const auto add_to = [](std::vector<double>& to, const std::vector<double>& from) {
    to.resize(from.size(), 0.0);
    for (std::size_t k = 0; k < from.size(); ++k) to[k] += from[k];
  };
  add_to(picture, other.picture);
  add_to(used, other.used);
  add_to(used_picture, other.used_picture);
  add_to(left_out, other.left_out);
}

NormalMaps::NormalMaps(const LightStack& stack, bool uncertainty) {
  const int rows = stack.extent().rows;
  const int cols = stack.extent().cols;
  orientation.normals = NormalMap(rows, cols, Eigen::Vector3f::UnitZ());
  orientation.rho = Grid<float>(rows, cols);
  const int channels = stack.images.front().channels();
  if (channels > 1) orientation.albedo = Image(rows, cols, channels);
  orientation.mask = stack.mask;
  if (!uncertainty) return;
  orientation.inliers = Grid<std::uint8_t>(rows, cols);
  for (auto* map :
       {&residuals.squares, &residuals.freedom, &noise_gain, &light_variance, &albedo_gain}) {
    *map = Grid<float>(rows, cols);
  }
}

std::vector<LightSums> solve_band(const TileSource& source, const NormalPlan& plan, int begin,
                                  int end, bool uncertainty, NormalMaps& maps) {
  if (plan.estimator == Estimator::robust_pca) {
    return solve_together(source, plan, begin, end, uncertainty, maps);
  }
  const Mask& mask = source.stack.mask;
  const bool keep_weights = uncertainty || source.stack.images.front().channels() > 1;
  Workspace work(source, plan, std::min(tile_pixels, mask.cols()), keep_weights);
  // The plain method without sigmas looks at every sample once, and needs no tile of them.
  const bool direct =
      plan.estimator == Estimator::least_squares && source.reads_directly() && !uncertainty;
  std::vector<LightSums> sums;
  const auto solve_row = [&](int row) {
    for (int col = 0; col < mask.cols(); col += tile_pixels) {
      const int count = std::min(tile_pixels, mask.cols() - col);
      if (!any_inside(mask, row, col, count)) continue;
      const std::vector<Run> runs{{0, row, col, count}};
      work.tile.pixels = count;
      if (direct && count >= lane_count) {
        source.point_at_row(row, col, work.rows);
        fit_pseudo_inverse(work.rows, count, plan.pseudo_inverse, work.tile);
      } else {
        const bool all_trusted = source.fill(work.tile, 0, row, col, count);
        work.solver.solve(work.tile, all_trusted);
      }
      if (uncertainty) put_judgement(runs, work, maps);
      put(source, plan, runs, work, maps);
    }
    if (uncertainty) sums.push_back(sums_of(work.judgement));
  };
  for_each_band(begin, end, [&](int first, int last) {
    for (int row = first; row < last; ++row) solve_row(row);
    source.let_go(first, last);
  });
  return sums;
}

}  // namespace hada
