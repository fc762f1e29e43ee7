#include "fit/knit_track.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/parallel.h"
#include "core/quantile.h"
#include "fit/knit_stitch.h"
#include "measure/line_field.h"

namespace hada {
namespace {

using Eigen::Vector2d;

constexpr double longest_step = 0.2;     // in stitches
constexpr double farthest_apart = 0.35;  // from where neighbours say it is, in stitches

/// Value and gradient (per unit, y up) of a picture between its pixels.
struct Reading {
  double value;
  Vector2d slope;
};

class PictureField {
 public:
  explicit PictureField(const TrackedPicture& picture) : picture_(picture) {}

  bool holds(const Vector2d& place, int margin = 1) const {
    const Vector2d at = picture_.extent.pixel(place);
    return at[0] >= margin && at[0] <= picture_.extent.rows - 2 - margin && at[1] >= margin &&
           at[1] <= picture_.extent.cols - 2 - margin;
  }

  double value(std::size_t plane, const Vector2d& place) const {
    return mixed(plane, place, [](const Grid<float>& g, int r, int c) { return double(g(r, c)); });
  }

  Reading reading(std::size_t plane, const Vector2d& place) const {
    const double scale = 0.5 / picture_.extent.pitch;
    return {value(plane, place),
            {scale * mixed(plane, place,
                           [](const Grid<float>& g, int r, int c) {
                             return double(g(r, c + 1) - g(r, c - 1));
                           }),
             scale * mixed(plane, place, [](const Grid<float>& g, int r, int c) {
               return double(g(r - 1, c) - g(r + 1, c));
             })}};
  }

 private:
  template <class Of>
  double mixed(std::size_t plane, const Vector2d& place, const Of& of) const {
    const Vector2d at = picture_.extent.pixel(place);
    const int r = int(at[0]), c = int(at[1]);
    const double v = at[0] - r, u = at[1] - c;
    const auto& g = picture_.planes[plane];
    return (1.0 - v) * ((1.0 - u) * of(g, r, c) + u * of(g, r, c + 1)) +
           v * ((1.0 - u) * of(g, r + 1, c) + u * of(g, r + 1, c + 1));
  }

  const TrackedPicture& picture_;
};

/// The places around a crossing: straight between it and its eight neighbours, as springs are.
struct Shape {
  Vector2d middle, right, left, up, down;  // from the middle to the neighbours
  std::array<Vector2d, 4> twist;           // right up, left up, right down, left down

  Vector2d at(double u, double v) const {
    const Vector2d along = u < 0.0 ? -u * left : u * right, across = v < 0.0 ? -v * down : v * up;
    return middle + along + across +
           std::abs(u * v) * twist[std::size_t((u < 0.0) + 2 * (v < 0.0))];
  }
  double stitch() const { return std::min((right - left).norm(), (up - down).norm()) / 2.0; }
};

Shape shape_at(const BentKnit& bent, int wale, int course) {
  Shape s;
  s.middle = bent.at(wale, course);
  const auto way = [&](int i, int j) -> Vector2d {
    return bent.at(wale + i, course + j) - s.middle;
  };
  s.right = way(1, 0), s.left = way(-1, 0), s.up = way(0, 1), s.down = way(0, -1);
  s.twist = {way(1, 1) - s.right - s.up, way(-1, 1) - s.left - s.up, way(1, -1) - s.right - s.down,
             way(-1, -1) - s.left - s.down};
  return s;
}

/// Calls `visit` with each of the up to eight neighbours of a crossing.
template <class Visit>
void around(const BentKnit& bent, int k, const Visit& visit) {
  const int wale = k % bent.wales, course = k / bent.wales;
  for (int j = std::max(0, course - 1); j <= std::min(bent.courses - 1, course + 1); ++j) {
    for (int i = std::max(0, wale - 1); i <= std::min(bent.wales - 1, wale + 1); ++i) {
      if (j * bent.wales + i != k) visit(std::size_t(j * bent.wales + i));
    }
  }
}

const std::vector<StitchLook::Sample>& samples_of(const StitchLook& look, int course, int first) {
  return look.courses[std::size_t(course + first) % look.courses.size()];
}

/// Correlation over all planes, each about its own mean.
double likeness_of(const PictureField& field, const std::vector<StitchLook::Sample>& samples,
                   const Shape& shape, int stride) {
  double both = 0.0, seen = 0.0, known = 0.0;
  const std::size_t planes = samples[0].values.size();
  for (std::size_t p = 0; p < planes; ++p) {
    double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
    for (std::size_t k = 0; k < samples.size(); k += std::size_t(stride)) {
      const Vector2d place = shape.at(samples[k].wale, samples[k].course);
      if (!field.holds(place)) return 0.0;
      const double x = field.value(p, place), y = samples[k].values[p];
      n += 1.0, a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
    }
    both += ab - a * b / n, seen += aa - a * a / n, known += bb - b * b / n;
  }
  return both / std::sqrt(std::max(seen * known, 1e-30));
}

/// The step that brings a stitch closer to its look, in the unit of the picture; not finite where
/// the picture ends.
Vector2d step_of(const PictureField& field, const std::vector<StitchLook::Sample>& samples,
                 const Shape& shape) {
  const std::size_t planes = samples[0].values.size();
  // Unknown: the step d, the contrast g, and a brightness for each plane, which its mean takes out:
  // I + slope d = brightness + g look.
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t p = 0; p < planes; ++p) {
    double n = 0.0, value_sum = 0.0, value_squares = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), with_value = sum;
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    for (const auto& sample : samples) {
      const Vector2d place = shape.at(sample.wale, sample.course);
      if (!field.holds(place, 2)) return Vector2d::Constant(NAN);
      const Reading here = field.reading(p, place);
      const Eigen::Vector3d row(here.slope.x(), here.slope.y(), -double(sample.values[p]));
      n += 1.0, value_sum += here.value, value_squares += here.value * here.value;
      sum += row, with_value += here.value * row, products += row * row.transpose();
    }
    gram += products - sum * sum.transpose() / n;
    right -= with_value - value_sum / n * sum;
  }
  gram.diagonal() *= 1.0 + 1e-9;
  return gram.ldlt().solve(right).head<2>();
}

/// One round of steps over all crossings; where `together`, each goes with its neighbours.
/// returns  the root mean square step, in stitches
double move(BentKnit& bent, const PictureField& field, const StitchLook& look, int first,
            bool together) {
  const BentKnit before = bent;
  Places& places = bent.places;
  const int count = int(places.size());
  std::vector<Vector2d> steps(places.size());
  std::vector<double> weight(places.size());
  for_each_index(count, [&](int k) {
    const Shape shape = shape_at(before, k % bent.wales, k / bent.wales);
    const auto& samples = samples_of(look, k / bent.wales, first);
    Vector2d step = step_of(field, samples, shape);
    const double longest = longest_step * shape.stitch();
    weight[std::size_t(k)] = 1e-3 + std::max(0.0, likeness_of(field, samples, shape, 3));
    if (!step.allFinite()) step.setZero(), weight[std::size_t(k)] = 1e-6;
    steps[std::size_t(k)] = step * std::min(1.0, longest / std::max(step.norm(), 1e-300));
  });
  double sum = 0.0;
  for (int k = 0; k < count; ++k) {
    const auto at = std::size_t(k);
    Vector2d step = steps[at];
    if (together) {
      double all = weight[at];
      step *= all;
      around(bent, k, [&](std::size_t n) { step += weight[n] * steps[n], all += weight[n]; });
      step /= all;
    }
    places[at].head<2>() += step;
    sum += step.squaredNorm();
  }
  return std::sqrt(sum / count);
}

/// Crossings whose displacement is not that of their neighbours: indices, with where they should
/// be.
std::vector<std::pair<std::size_t, Vector2d>> strayed(const BentKnit& bent, const BentKnit& guess) {
  std::vector<std::pair<std::size_t, Vector2d>> all;
  for (int k = 0; k < int(bent.places.size()); ++k) {
    const auto at = std::size_t(k);
    std::vector<double> x, y;
    around(bent, k, [&](std::size_t n) {
      const Eigen::Vector3d moved = bent.places[n] - guess.places[n];
      x.push_back(moved.x()), y.push_back(moved.y());
    });
    const Vector2d wanted = guess.places[at].head<2>() + Vector2d(median(x), median(y));
    const double stitch = shape_at(guess, k % bent.wales, k / bent.wales).stitch();
    if ((bent.places[at].head<2>() - wanted).norm() > farthest_apart * stitch) {
      all.emplace_back(at, wanted);
    }
  }
  return all;
}

}  // namespace

TrackedPicture tracked_picture(const Surface& surface, double smooth_px) {
  TrackedPicture picture{surface.extent, {}};
  for (const auto& plane : surface.albedo.planes) {
    Grid<float> root = plane;
    for (float& value : root) value = std::sqrt(std::max(0.0f, value));
    picture.planes.push_back(smoothed(root, surface.mask, smooth_px));
  }
  return picture;
}

StitchLook look_of(const TrackedPicture& rest, const Knit<>& knit) {
  constexpr int finest = 24;  // samples to a wale
  const int repeat = int(knit.colour_repeat.size());
  Knit<> period = knit;
  period.course_mm *= repeat, period.course_phase /= repeat;
  Surface surface;
  surface.extent = rest.extent;
  surface.mask = full_mask(rest.extent);
  surface.albedo.planes = rest.planes;
  const int cols = std::clamp(int(std::lround(knit.wale_mm / rest.extent.pitch)), 8, finest);
  const MeanStitch mean = mean_stitch(surface, period, cols);
  StitchLook look;
  look.courses.resize(std::size_t(repeat));
  const int rows = mean.weight.rows();
  for (int row = 0; row < rows; ++row) {
    const double up = (1.0 - (row + 0.5) / rows) * repeat;
    const int course = int(std::lround(up));
    for (int col = 0; col < cols; ++col) {
      if (mean.weight(row, col) == 0.0f) continue;
      StitchLook::Sample sample{(col + 0.5) / cols - 0.5, up - course, {}};
      for (const auto& plane : mean.planes) sample.values.push_back(plane(row, col));
      look.courses[std::size_t(course % repeat)].push_back(std::move(sample));
    }
  }
  return look;
}

double mean_likeness(const TrackedPicture& picture, const StitchLook& look, const BentKnit& bent,
                     int first, const ComparedPlaces& compared) {
  const PictureField field(picture);
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < int(bent.places.size()); k += compared.every, ++count) {
    const int course = k / bent.wales;
    sum += likeness_of(field, samples_of(look, course, first),
                       shape_at(bent, k % bent.wales, course), compared.stride);
  }
  return sum / std::max(count, 1);
}

BentKnit tracked(const std::vector<TrackedPicture>& levels, const std::vector<StitchLook>& looks,
                 const BentKnit& guess, int first) {
  constexpr int most_rounds = 15;
  constexpr double still = 3e-3;  // of a pixel
  BentKnit bent = guess;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const PictureField field(levels[level]);
    const bool together = level + 1 < levels.size();
    for (int round = 0; round < most_rounds; ++round) {
      const double moved = move(bent, field, looks[level], first, together);
      if (moved < still * levels[level].extent.pitch) break;
    }
    for (const auto& [k, wanted] : strayed(bent, guess)) bent.places[k].head<2>() = wanted;
  }
  return bent;
}

}  // namespace hada
