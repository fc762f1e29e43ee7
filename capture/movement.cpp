#include "capture/movement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

#include "capture/edge_gradient.h"
#include "capture/opencv_view.h"
#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double most_px = 1600.0;         // along the longer side; larger pictures are reduced
constexpr std::size_t most_points = 1500;  // of an outline

Grid<float> reduced(const Grid<float>& grey, double step) {
  if (step <= 1.0) return grey;
  Grid<float> small(int(std::round(grey.rows() / step)), int(std::round(grey.cols() / step)));
  cv::Mat target = view(small);
  cv::resize(view(grey), target, target.size(), 0.0, 0.0, cv::INTER_AREA);
  return small;
}

void thin(Outline& outline) {
  const std::size_t stride = outline.pixels.size() / most_points + 1;
  Outline thinned{outline.what, outline.round, {}, {}};
  for (std::size_t i = 0; i < outline.pixels.size(); i += stride) {
    thinned.pixels.push_back(outline.pixels[i]);
    thinned.inward.push_back(outline.inward[i]);
  }
  outline = std::move(thinned);
}

Outline outline_of(const Sphere& sphere, double step) {
  Outline outline{"the " + std::string(name_of(sphere.kind)) + " sphere", true, {}, {}};
  const double radius = sphere.radius_px / step;
  const int count = std::max(16, int(2.0 * std::numbers::pi * radius));
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector2d outward(std::cos(turn), std::sin(turn));
    const Eigen::Vector2d at = sphere.center_px / step + radius * outward;
    outline.pixels.emplace_back(int(std::floor(at.x())), int(std::floor(at.y())));
    outline.inward.push_back(-outward);
  }
  thin(outline);
  return outline;
}

// Around a sphere the mask ends because the sphere was cut out of it, not the sample.
bool is_cut_out(const Eigen::Vector2d& at_px, const std::vector<Sphere>& spheres, double step) {
  constexpr double reach = 1.2;   // of the radius
  constexpr double smooth = 3.0;  // px of the reduced picture
  return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
    return (at_px - sphere.center_px).norm() < reach * sphere.radius_px + smooth * step;
  });
}

// The border of the mask, without the frame of the picture: there nothing ends.
Outline outline_of(const Mask& mask, const std::vector<Sphere>& spheres, double step) {
  Outline outline{"the sample", false, {}, {}};
  Grid<float> inside(mask.rows(), mask.cols());
  std::transform(mask.begin(), mask.end(), inside.begin(),
                 [](const auto m) { return m ? 1.0f : 0.0f; });
  const Grid<float> small = reduced(inside, step);
  Grid<float> soft(small.rows(), small.cols());
  cv::Mat target = view(soft);
  cv::GaussianBlur(view(small), target, {}, 2.0, 2.0, cv::BORDER_REPLICATE);
  constexpr int frame = 3;
  for (int row = frame; row + frame < small.rows(); ++row) {
    for (int col = frame; col + frame < small.cols(); ++col) {
      const bool at_border =
          small(row, col) >= 0.5f && (small(row - 1, col) < 0.5f || small(row + 1, col) < 0.5f ||
                                      small(row, col - 1) < 0.5f || small(row, col + 1) < 0.5f);
      if (!at_border || is_cut_out(step * Eigen::Vector2d(col, row), spheres, step)) continue;
      const Eigen::Vector2d up(soft(row, col + 1) - soft(row, col - 1),
                               soft(row + 1, col) - soft(row - 1, col));
      if (up.norm() < 0.1) continue;  // a hair, or a hole of one pixel
      outline.pixels.emplace_back(col, row);
      outline.inward.push_back(up.normalized());
    }
  }
  thin(outline);
  return outline;
}

Grid<float> mean_of(const std::vector<Grid<float>>& greys) {
  Grid<float> mean(greys[0].rows(), greys[0].cols());
  for (const auto& grey : greys) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += grey[i] / float(greys.size());
  }
  return mean;
}

// Moves the border of a mask, which lies a little inside, onto the edge that the mean picture
// shows.
void settle(Outline& outline, const Gradient& mean) {
  constexpr int farthest = 4;
  for (std::size_t i = 0; i < outline.pixels.size(); ++i) {
    double steepest = 0.0;
    Eigen::Vector2i best = outline.pixels[i];
    for (int out = -1; out <= farthest; ++out) {
      const Eigen::Vector2d off = -out * outline.inward[i];
      const Eigen::Vector2i at =
          outline.pixels[i] + Eigen::Vector2i(int(std::lround(off.x())), int(std::lround(off.y())));
      if (!mean.u.contains(at.y(), at.x())) continue;
      const double inward = outline.inward[i].x() * mean.u(at.y(), at.x()) +
                            outline.inward[i].y() * mean.v(at.y(), at.x());
      if (inward <= steepest) continue;
      steepest = inward;
      best = at;
    }
    outline.pixels[i] = best;
  }
}

// What the outline collects, for a point on average, if it is shifted.
double collected(const Gradient& gradient, const Outline& outline, int du, int dv) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.pixels.size(); ++i) {
    const int col = outline.pixels[i].x() + du;
    const int row = outline.pixels[i].y() + dv;
    if (!gradient.u.contains(row, col)) continue;
    const double inward =
        outline.inward[i].x() * gradient.u(row, col) + outline.inward[i].y() * gradient.v(row, col);
    sum += inward;
  }
  return sum / double(outline.pixels.size());
}

// The stretch of a round outline that faces a light, or all of any other.
Outline facing(const Outline& outline, const Eigen::Vector2d& towards) {
  if (!outline.round) return outline;
  Outline lit{outline.what, true, {}, {}};
  for (std::size_t i = 0; i < outline.pixels.size(); ++i) {
    if (outline.inward[i].dot(towards) > 0.0) continue;
    lit.pixels.push_back(outline.pixels[i]);
    lit.inward.push_back(outline.inward[i]);
  }
  return lit;
}

struct Peak {
  Eigen::Vector2d shift;
  double height = 0.0;
  bool clear = false;
};

Peak peak_of(const Gradient& gradient, const Outline& outline, int reach) {
  Peak peak;
  Eigen::Vector2i best(0, 0);
  peak.height = -HUGE_VAL;
  for (int dv = -reach; dv <= reach; ++dv) {
    for (int du = -reach; du <= reach; ++du) {
      const double height = collected(gradient, outline, du, dv);
      if (height <= peak.height) continue;
      peak.height = height;
      best = {du, dv};
    }
  }
  constexpr double visible = 0.03;  // of the brightness, to a pixel
  // One pixel off the peak, in every direction. The shading of a sphere falls by the inverse of its
  // radius, which on a bright table is all that is seen of it.
  const double falls = outline.round ? 0.08 : 0.02;
  peak.clear = peak.height > visible;
  peak.shift = best.cast<double>();
  for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), Eigen::Vector2i(0, 1),
                                     Eigen::Vector2i(1, 1), Eigen::Vector2i(1, -1)}) {
    const Eigen::Vector2i before = best - way;
    const Eigen::Vector2i after = best + way;
    const double left = peak.height - collected(gradient, outline, before.x(), before.y());
    const double right = peak.height - collected(gradient, outline, after.x(), after.y());
    peak.clear = peak.clear && left + right > 2.0 * falls * peak.height;
    if (way.sum() == 1 && left + right > 0.0) {
      peak.shift += 0.5 * (left - right) / (left + right) * way.cast<double>();
    }
  }
  return peak;
}

// How far off each thing lies in one picture.
struct Moved {
  std::string what;
  double distance = 0.0;
  Eigen::Vector2d shift;
};

std::string sentence(const std::string& name, const std::vector<Moved>& seen, double notable) {
  const auto is_off = [&](const Moved& thing) { return thing.distance >= notable; };
  const auto first = std::find_if(seen.begin(), seen.end(), is_off);
  if (first == seen.end()) return "";
  const bool together = std::all_of(seen.begin(), seen.end(), [&](const Moved& thing) {
    return (thing.shift - first->shift).norm() < std::max(notable, 0.25 * first->distance);
  });
  const std::string todo = "; photograph it again, or leave the picture out.";
  if (seen.size() > 1 && together) {
    return fmt::format(
        "{} is shifted by about {:.0f} px against the other pictures: the camera "
        "moved{}",
        name, first->distance, todo);
  }
  const std::string who = seen.size() > 1 ? "it" : "it or the camera";
  return fmt::format(
      "In {} {} lies about {:.0f} px off its place in the other pictures: {} "
      "moved{}",
      name, first->what, first->distance, who, todo);
}

}  // namespace

std::vector<Eigen::Vector2d> movements(const std::vector<Grid<float>>& greys,
                                       const std::vector<Eigen::Vector2d>& towards,
                                       const Outline& outline, int reach) {
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::Vector2d> shifts(greys.size(), {nowhere, nowhere});
  if (outline.pixels.empty()) return shifts;
  std::vector<Gradient> gradients(greys.size());
  std::vector<Peak> peaks(greys.size());
  std::vector<Outline> lit(greys.size());
  for_each_index(int(greys.size()), [&](int picture) {
    const auto k = std::size_t(picture);
    gradients[k] = gradient_of(greys[k]);
    lit[k] = facing(outline, towards[k]);
    if (!lit[k].pixels.empty()) peaks[k] = peak_of(gradients[k], lit[k], reach);
  });
  std::vector<double> u, v;
  for (const Peak& peak : peaks) {
    if (!peak.clear) continue;
    u.push_back(peak.shift.x());
    v.push_back(peak.shift.y());
  }
  if (u.size() < 3) return shifts;
  const Eigen::Vector2d usual(median(u), median(v));
  for (std::size_t k = 0; k < greys.size(); ++k) {
    if (!peaks[k].clear) continue;
    // An outline that fits its usual place nearly as well did not move.
    constexpr double clearly = 1.4;
    const double at_home =
        collected(gradients[k], lit[k], int(std::lround(usual.x())), int(std::lround(usual.y())));
    const bool moved = peaks[k].height > clearly * at_home;
    shifts[k] = moved ? Eigen::Vector2d(peaks[k].shift - usual) : Eigen::Vector2d(0.0, 0.0);
  }
  return shifts;
}

std::vector<std::string> remarks_on_movement(const std::vector<Image>& pictures,
                                             const std::vector<Light>& lights,
                                             const std::vector<Sphere>& spheres, const Mask& mask) {
  const double longer = std::max(pictures.front().rows(), pictures.front().cols());
  const double step = std::max(1.0, longer / most_px);
  std::vector<Grid<float>> greys(pictures.size());
  std::vector<Eigen::Vector2d> towards;
  for (const Light& light : lights) towards.emplace_back(light.direction.x(), -light.direction.y());
  for_each_index(int(greys.size()), [&](int k) {
    greys[std::size_t(k)] = reduced(luminance(pictures[std::size_t(k)]), step);
  });
  std::vector<Outline> outlines;
  if (!mask.empty()) {
    outlines.push_back(outline_of(mask, spheres, step));
    settle(outlines.back(), gradient_of(mean_of(greys)));
  }
  for (const Sphere& sphere : spheres) {
    if (sphere.kind == SphereKind::matte) outlines.push_back(outline_of(sphere, step));
  }
  std::vector<std::vector<Moved>> seen(greys.size());
  for (const Outline& outline : outlines) {
    const auto shifts = movements(greys, towards, outline);
    for (std::size_t k = 0; k < greys.size(); ++k) {
      if (!shifts[k].allFinite()) continue;
      seen[k].push_back({outline.what, step * shifts[k].norm(), step * shifts[k]});
    }
  }
  std::vector<std::string> remarks;
  const double notable = 1.5 * step;
  for (std::size_t k = 0; k < greys.size(); ++k) {
    const std::string remark = sentence(lights[k].image, seen[k], notable);
    if (!remark.empty()) remarks.push_back(remark);
  }
  return remarks;
}

}  // namespace hada
