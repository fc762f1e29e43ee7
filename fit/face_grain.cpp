#include "fit/face_grain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/error.h"
#include "core/quantile.h"
#include "fit/absorbance.h"
#include "fit/pith.h"
#include "measure/line_field.h"

namespace hada {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int fewest_parts = 12;      // that must show fibres
constexpr double least_gain = 12.0;   // of the information criterion, for a period
constexpr double neighbours = 3.0;    // parts whose streaks are partly the same rows
constexpr double pulled = 0.0025;     // slope by which borders of rings may pull the fibres
constexpr double compared_px = 18.0;  // rows over which the slope of a streak is a mean
constexpr double loss_scale = 2.5;    // scatters, of the Cauchy loss

/// slope = state[0] + state[1] sin + state[2] cos of turn s / length; length 0: state[0] alone.
struct Wave {
  double length = 0.0;
  Eigen::Vector3d state = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double scatter = 0.0;
  double cost = HUGE_VAL;  // robust, for one scatter shared by all that are compared
};

/// A part as a line of least squares: where, and its slope.
struct Part {
  double s, slope, weight;
};

Eigen::Vector3d row_of(double s, double length) {
  if (length <= 0.0) return {1.0, 0.0, 0.0};
  return {1.0, std::sin(turn * s / length), std::cos(turn * s / length)};
}

Wave fitted(const std::vector<Part>& parts, double length, double scale, int rounds) {
  Wave wave{.length = length};
  std::vector<double> slopes;
  for (const Part& part : parts) slopes.push_back(part.slope);
  wave.state[0] = median(slopes);
  for (int round = 0; round <= rounds; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::vector<double> sizes;
    wave.cost = 0.0;
    for (const Part& part : parts) {
      const Eigen::Vector3d row = row_of(part.s, length);
      const double off = part.slope - row.dot(wave.state);
      const double relative = off / (loss_scale * scale);
      const double weight = part.weight / (1.0 + relative * relative);
      normal += weight * row * row.transpose();
      right += weight * part.slope * row;
      wave.cost += part.weight * std::log1p(relative * relative) * loss_scale * loss_scale;
      sizes.push_back(std::abs(off));
    }
    wave.scatter = std::max(1.4826 * median(sizes), 1e-6);
    if (length <= 0.0) normal.diagonal().tail<2>().setOnes();
    normal.diagonal() *= 1.0 + 1e-9;
    wave.covariance = normal.inverse() * neighbours * wave.scatter * wave.scatter;
    if (round < rounds) wave.state = normal.ldlt().solve(right);
  }
  return wave;
}

/// The period that explains the parts best, from `least` to `most`.
Wave best_wave(const std::vector<Part>& parts, double least, double most, double scale) {
  constexpr int lengths = 160;
  Wave best;
  for (int k = 0; k < lengths; ++k) {
    const Wave wave =
        fitted(parts, least * std::pow(most / least, double(k) / (lengths - 1)), scale, 4);
    if (wave.cost < best.cost) best = wave;
  }
  double reach = std::pow(most / least, 1.0 / (lengths - 1)) - 1.0;
  for (int halving = 0; halving < 12; ++halving, reach *= 0.5) {
    for (const double factor : {1.0 - reach, 1.0 + reach}) {
      const Wave wave = fitted(parts, best.length * factor, scale, 8);
      if (wave.cost < best.cost) best = wave;
    }
  }
  return best;
}

/// How many parts are worth one that scatters on its own: those of one place along the wave lie on
/// the same rings, whose borders pull them alike. So few places have less to say of a wave, of
/// which four numbers are not known.
double together(const std::vector<Part>& parts, const Wave& wave) {
  constexpr double unknown = 4.0;
  std::map<double, double> sums;
  double squares = 0.0;
  for (const Part& part : parts) {
    const double off = part.slope - row_of(part.s, wave.length).dot(wave.state);
    const double clipped = std::clamp(off, -3.0 * wave.scatter, 3.0 * wave.scatter);
    sums[part.s] += clipped;
    squares += clipped * clipped;
  }
  double of_places = 0.0;
  for (const auto& [place, sum] : sums) of_places += sum * sum;
  if (!(squares > 0.0)) return neighbours;
  const double free = std::max(double(sums.size()) - unknown, 1.0);
  const double by_few =
      1.0 + 0.93 / free;  // 90 % of Student's t, to first order, over a Gaussian's
  return std::max(neighbours, of_places / squares * double(sums.size()) / free * by_few * by_few);
}

/// Standard deviation of the length, by leaving out one place after another (the jackknife): what
/// is wrong with a place is wrong with all its parts.
double length_sigma(const std::vector<Part>& parts, const Wave& wave) {
  std::map<double, std::vector<Part>> without;
  for (const Part& part : parts) without[part.s];
  for (auto& [place, rest] : without) {
    for (const Part& part : parts) {
      if (part.s != place) rest.push_back(part);
    }
  }
  double sum = 0.0, squares = 0.0;
  for (const auto& [place, rest] : without) {
    const double off =
        best_wave(rest, 0.9 * wave.length, 1.1 * wave.length, wave.scatter).length - wave.length;
    sum += off;
    squares += off * off;
  }
  const double count = double(without.size());
  return std::sqrt(std::max(squares - sum * sum / count, 0.0) * (count - 1.0) / count);
}

/// Where streaks are clearer their slope is surer.
std::vector<Part> along(const std::vector<Streak>& seen, int axis) {
  std::vector<double> likeness;
  for (const Streak& streak : seen) likeness.push_back(streak.likeness);
  const double usual = median(likeness);
  std::vector<Part> parts;
  for (const Streak& streak : seen) {
    parts.push_back(
        {streak.place[axis], streak.slope, std::clamp(streak.likeness / usual, 0.2, 2.0)});
  }
  return parts;
}

/// What a mean over `width` leaves of the amplitude of a wave.
double left_by_mean(double width, double length) {
  const double half = 0.5 * turn * width / length;
  return half < 1e-6 ? 1.0 : std::sin(half) / half;
}

Grid<float> absorbance_of(const Surface& surface) {
  if (surface.albedo.empty()) {
    throw Error("wood: the surface has no albedo; give a picture of a face");
  }
  return absorbance(luminance(surface.albedo));
}

/// Parts so small that there are some dozens of them.
StreakOptions tiles_for(const Extent& extent) {
  return {.tile_rows = 32, .tile_cols = std::clamp(extent.cols / 6, 36, 80)};
}

int parts_of(const Extent& extent) {
  const auto tiles = tiles_for(extent);
  return extent.rows / tiles.tile_rows * (extent.cols / tiles.tile_cols);
}

FaceGrain grain_of(const std::vector<Streak>& seen, const Extent& extent) {
  const auto tiles = tiles_for(extent);
  const double height = extent.height(), width = extent.width();
  const auto up = along(seen, 1), across = along(seen, 0);
  const Wave straight = fitted(up, 0.0, fitted(up, 0.0, 0.1, 3).scatter, 8);
  const double tile_up = tiles.tile_rows * extent.pitch,
               tile_across = tiles.tile_cols * extent.pitch;
  Wave wavy, interlocked;
  if (height > 6.0 * tile_up) wavy = best_wave(up, 2.5 * tile_up, height / 1.2, straight.scatter);
  if (width > 4.0 * tile_across)
    interlocked = best_wave(across, 2.5 * tile_across, width / 1.2, straight.scatter);
  const bool is_wavy = wavy.cost <= interlocked.cost;
  const Wave& wave = is_wavy ? wavy : interlocked;
  FaceGrain grain;
  grain.parts = int(seen.size());
  const double independent = double(seen.size()) / neighbours;
  const double gain = 2.0 * independent * std::log(straight.scatter / wave.scatter) -
                      3.0 * std::log(std::max(independent, 2.0));
  const double amplitude = std::hypot(wave.state[1], wave.state[2]);
  if (!(gain > least_gain) || amplitude < 2.0 * pulled) {
    grain.gradient = {straight.state[0], std::hypot(std::sqrt(straight.covariance(0, 0)), pulled)};
    grain.scatter = straight.scatter;
    return grain;
  }
  // Once more, with the scatter that is left.
  const auto& parts = is_wavy ? up : across;
  Wave sharp = best_wave(parts, 0.9 * wave.length, 1.1 * wave.length, wave.scatter);
  sharp.covariance *= together(parts, sharp) / neighbours;
  const double left = is_wavy ? left_by_mean(tile_up, sharp.length) *
                                    left_by_mean(compared_px * extent.pitch, sharp.length)
                              : left_by_mean(tile_across, sharp.length);
  const double found = std::hypot(sharp.state[1], sharp.state[2]);
  const double spread = std::sqrt(0.5 * (sharp.covariance(1, 1) + sharp.covariance(2, 2)));
  grain.kind = is_wavy ? FaceGrain::Kind::wavy : FaceGrain::Kind::interlocked;
  grain.gradient = {sharp.state[0], std::hypot(std::sqrt(sharp.covariance(0, 0)), pulled)};
  // What the means leave of a wave is known to a few parts in a hundred of what they take.
  const double corrected = found * std::max(0.05 * (1.0 - left), 0.01);
  grain.amplitude = {found / left, std::hypot(std::hypot(spread, pulled), corrected) / left};
  grain.phase = {std::atan2(sharp.state[2], sharp.state[1]), spread / found};
  // A phase known to so much at both ends of the face (uniform parts: span / sqrt 12 from the
  // mean).
  const double span = (is_wavy ? height : width) / std::sqrt(12.0);
  const double by_phase = sharp.length * sharp.length / turn * spread / found / span;
  // Columns of parts are few, and wide enough for a wave to bend within one.
  const double by_columns = is_wavy ? 0.0 : length_sigma(parts, sharp);
  grain.length = {sharp.length, std::max(by_phase, by_columns)};
  grain.scatter = sharp.scatter;
  return grain;
}

}  // namespace

FaceGrain face_grain(const Surface& surface, const StreakReading& reading) {
  auto seen =
      streaks(absorbance_of(surface), surface.mask, surface.extent, tiles_for(surface.extent));
  if (reading) {
    for (Streak& streak : seen) streak.slope = reading(streak);
    std::erase_if(seen, [](const Streak& streak) { return std::isnan(streak.slope); });
  }
  if (int(seen.size()) < fewest_parts) {
    throw Error(
        "wood: too few fibres can be seen on this face; give a sharp picture with the stem "
        "upright");
  }
  FaceGrain grain = grain_of(seen, surface.extent);
  grain.asked = parts_of(surface.extent);
  return grain;
}

bool looks_like_a_face(const Surface& surface) {
  constexpr double far = 6.0;          // diagonals to where lines meet that run side by side
  constexpr double least_share = 0.2;  // of the parts must show fibres
  const auto map = absorbance_of(surface);
  const auto seen = streaks(map, surface.mask, surface.extent, tiles_for(surface.extent));
  if (int(seen.size()) < fewest_parts ||
      double(seen.size()) < least_share * parts_of(surface.extent))
    return false;
  const auto directions = ring_directions(line_field(map, surface.mask), surface.extent);
  if (directions.size() < fewest_directions) return true;
  const double diagonal = std::hypot(surface.extent.width(), surface.extent.height());
  return pith_guess(directions, surface.extent).place.norm() > far * diagonal;
}

}  // namespace hada
