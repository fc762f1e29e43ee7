#include "app/draw/worn_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "app/draw/lettering.h"
#include "core/parallel.h"
#include "core/quantile.h"
#include "core/srgb.h"
#include "mechanics/worn_maps.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr std::array<double, 3> skin{0.78, 0.50, 0.36}, ground{0.80, 0.80, 0.78};
constexpr std::array<double, 3> nylon{0.10, 0.08, 0.08}, support{0.16, 0.11, 0.10};
constexpr double ambient = 0.25;
constexpr double gloss = 24.0, shine = 0.35;  // of the lobe of a yarn
constexpr Colour ink{0.05f, 0.05f, 0.05f};
constexpr int samples = 3;  // of a pixel, each way
const Vector3d light_in_view = Vector3d(-0.45, 0.5, 0.75).normalized();

struct Camera {
  Vector3d right, up, back, middle;
  double pitch_mm = 1.0;
  int rows = 0, cols = 0;
  Vector3d place(double row, double col) const {
    return middle + ((col - 0.5 * cols) * right + (0.5 * rows - row) * up) * pitch_mm;
  }
};

Camera camera_for(const WornKnit& knit, const WornView& view) {
  Vector3d low = knit.places[0], high = low;
  for (const Vector3d& p : knit.places) low = low.cwiseMin(p), high = high.cwiseMax(p);
  Camera camera;
  camera.up = Vector3d::Unit(view.axis);
  const double turn = view.turn_deg * std::numbers::pi / 180.0;
  camera.back = std::cos(turn) * Vector3d::Unit((view.axis + 1) % 3) +
                std::sin(turn) * Vector3d::Unit((view.axis + 2) % 3);
  camera.right = camera.up.cross(camera.back);
  const Vector3d size = high - low;
  const double whole = 1.08 * size[view.axis];
  const double height = view.height_mm > 0.0 ? view.height_mm : whole;
  camera.rows = view.rows;
  camera.pitch_mm = height / view.rows;
  double widest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != view.axis) widest = std::max(widest, size[axis]);
  }
  camera.cols = int(
      std::clamp(1.25 * widest / camera.pitch_mm + 110.0, 160.0, std::max(160.0, 1.0 * view.rows)));
  camera.middle = 0.5 * (low + high);
  if (view.height_mm > 0.0) camera.middle[view.axis] = view.middle_mm;
  camera.middle += 2.0 * size.norm() * camera.back;
  return camera;
}

// The knit as a surface of triangles, to ask which face of it a place lies in.
struct Faces {
  std::vector<ShellCell> cells;
  TriangleMesh mesh;
  std::vector<int> cell_of;  // each triangle

  explicit Faces(const WornKnit& knit) : cells(cells_of(knit)) {
    mesh.vertices_mm = knit.places;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto& c = cells[k].corners;
      for (std::size_t i = 2; i < c.size(); ++i) {
        mesh.triangles.push_back({c[0], c[i - 1], c[i]});
        cell_of.push_back(int(k));
      }
    }
  }
  const ShellCell& at(const MeshPlace& place) const {
    return cells[std::size_t(cell_of[std::size_t(place.triangle)])];
  }
};

// Where a ray that comes down along -d over `place` meets a yarn, and what it sees there.
struct YarnHit {
  double height = -1.0;  // over `place`, along d
  Vector3d normal, along;
  bool supports = false;
};

class Scene {
 public:
  Scene(const Body& body, const WornKnit& knit, const TautYarns* yarns, const Camera& camera,
        double radius)
      : body_(body),
        knit_(knit),
        yarns_(yarns),
        camera_(camera),
        faces_(knit),
        springs_(springs_of(knit)),
        tree_(faces_.mesh),
        radius_(radius),
        typical_mm_(std::sqrt(median(knit.area_mm2))) {
    light_ = light_in_view.x() * camera.right + light_in_view.y() * camera.up +
             light_in_view.z() * camera.back;
  }

  std::array<double, 3> yarn_colour(const Vector3d& from) const {
    const MeshPlace hit = body_.tree().first_hit(from, -camera_.back);
    if (hit.triangle < 0) return ground;
    const auto bare = skin_at(hit);
    const auto at = on_knit(hit.place);
    if (!at) return bare;
    return typical_mm_ < 4.0 * camera_.pitch_mm ? veiled(bare, *at) : with_yarns(bare, hit);
  }

  std::array<double, 3> map_colour(const Vector3d& from, const std::vector<double>& values,
                                   double low, double high) const {
    const MeshPlace hit = body_.tree().first_hit(from, -camera_.back);
    if (hit.triangle < 0) return ground;
    const auto at = on_knit(hit.place);
    if (!at) return skin_at(hit);
    double value = 0.0;
    for (int c = 0; c < 3; ++c) value += at->weights[c] * values[std::size_t(corner(*at, c))];
    const Colour colour = sequential((value - low) / std::max(high - low, 1e-300));
    const double lit = 0.35 + 0.65 * lit_by(body_.normal(hit));
    std::array<double, 3> result{};
    for (std::size_t p = 0; p < 3; ++p) result[p] = lit * linear_from_srgb(colour[p]);
    return result;
  }

 private:
  int corner(const MeshPlace& at, int c) const {
    return faces_.mesh.triangles[std::size_t(at.triangle)][std::size_t(c)];
  }
  std::optional<MeshPlace> on_knit(const Vector3d& place) const {
    const MeshPlace at = tree_.closest(place);
    if (at.distance > 0.5 * typical_mm_) return std::nullopt;
    return at;
  }
  double lit_by(const Vector3d& normal) const {
    return ambient + (1.0 - ambient) * std::max(0.0, normal.dot(light_));
  }
  std::array<double, 3> skin_at(const MeshPlace& hit) const {
    const double lit = lit_by(body_.normal(hit));
    return {skin[0] * lit, skin[1] * lit, skin[2] * lit};
  }

  // Kajiya and Kay: diffuse by the angle to the fibre, a lobe about the cone of mirrors.
  std::array<double, 3> fibre_light(const Vector3d& along, const Vector3d& normal,
                                    bool supports) const {
    const double l = along.dot(light_), v = along.dot(camera_.back);
    const double sine_l = std::sqrt(std::max(0.0, 1.0 - l * l)),
                 sine_v = std::sqrt(std::max(0.0, 1.0 - v * v));
    const double reached = std::clamp(0.3 + normal.dot(light_), 0.0, 1.0);
    const double diffuse = ambient + (1.0 - ambient) * sine_l * reached;
    const double lobe = reached * std::pow(std::max(0.0, sine_l * sine_v - l * v), gloss);
    std::array<double, 3> light{};
    for (std::size_t p = 0; p < 3; ++p) {
      light[p] = (supports ? support : nylon)[p] * diffuse + shine * lobe;
    }
    return light;
  }

  std::array<double, 3> veiled(const std::array<double, 3>& bare, const MeshPlace& at) const {
    const ShellCell& cell = faces_.at(at);
    const auto p = std::size_t(corner(at, 0));
    const auto direction = [&](int spring) -> Vector3d {
      const WornSpring& of = springs_[std::size_t(spring)];
      return (knit_.places[std::size_t(of.to)] - knit_.places[std::size_t(of.from)]).normalized();
    };
    const Vector3d along = direction(cell.along), up = direction(cell.up),
                   normal = knit_.normals[p];
    const double passed =
        see_through(knit_.wale_mm[p], knit_.course_mm[p], radius_, along, up, normal, camera_.back);
    const auto first = fibre_light(along, normal, false), second = fibre_light(up, normal, true);
    std::array<double, 3> mixed{};
    for (std::size_t c = 0; c < 3; ++c) {
      mixed[c] = passed * bare[c] + (1.0 - passed) * 0.5 * (first[c] + second[c]);
    }
    return mixed;
  }

  void try_line(int line_index, const Vector3d& place, YarnHit& best) const {
    const auto& line = yarns_->lines[std::size_t(line_index)];
    const Vector3d lift =
        radius_ *
        (knit_.normals[std::size_t(line.from)] + knit_.normals[std::size_t(line.to)]).normalized();
    Vector3d from = knit_.places[std::size_t(line.from)];
    for (std::size_t k = 0; k <= line.between.size(); ++k) {
      const Vector3d to =
          k < line.between.size() ? line.between[k] : knit_.places[std::size_t(line.to)];
      try_piece(place - lift, from, to, springs_[std::size_t(line_index)].stiffness > 1.0, best);
      from = to;
    }
  }

  void try_piece(const Vector3d& over, const Vector3d& from, const Vector3d& to, bool supports,
                 YarnHit& best) const {
    const double length = (to - from).norm();
    if (length == 0.0) return;
    const Vector3d q = (to - from) / length, &d = camera_.back;
    const Vector3d way = over - from, across = way - q * q.dot(way), slope = d - q * q.dot(d);
    const double a = slope.squaredNorm(), b = slope.dot(across),
                 c = across.squaredNorm() - radius_ * radius_, root = b * b - a * c;
    if (a < 1e-12 || root < 0.0) return;
    const double s = (-b + std::sqrt(root)) / a;
    const double t = q.dot(way + s * d);
    if (s <= std::max(best.height, 0.0) || t < -radius_ || t > length + radius_) return;
    best = {s, (across + s * slope) / radius_, q, supports};
  }

  std::array<double, 3> with_yarns(const std::array<double, 3>& bare, const MeshPlace& hit) const {
    // A slanting ray passes over other cells before it comes down here.
    const double facing = std::max(body_.normal(hit).dot(camera_.back), 0.1);
    const double reach = 2.0 * radius_ / facing;
    const int stops = std::clamp(int(2.0 * reach / typical_mm_) + 2, 2, 12);
    YarnHit best;
    int last = -1;
    for (int k = 0; k < stops; ++k) {
      const auto at = on_knit(hit.place + camera_.back * (reach * k / (stops - 1)));
      if (!at || faces_.cell_of[std::size_t(at->triangle)] == last) continue;
      last = faces_.cell_of[std::size_t(at->triangle)];
      for (const int line : faces_.at(*at).springs) try_line(line, hit.place, best);
    }
    return best.height < 0.0 ? bare : fibre_light(best.along, best.normal, best.supports);
  }

  const Body& body_;
  const WornKnit& knit_;
  const TautYarns* yarns_;
  const Camera& camera_;
  Faces faces_;
  std::vector<WornSpring> springs_;
  MeshTree tree_;
  double radius_;
  double typical_mm_;  // a stitch
  Vector3d light_;
};

template <class ColourAt>
Image painted(const Camera& camera, const ColourAt& colour_at) {
  Image picture(camera.rows, camera.cols, 3);
  for_each_index(camera.rows, [&](int row) {
    for (int col = 0; col < camera.cols; ++col) {
      std::array<double, 3> sum{};
      for (int s = 0; s < samples * samples; ++s) {
        const auto colour = colour_at(
            camera.place(row + (s / samples + 0.5) / samples, col + (s % samples + 0.5) / samples));
        for (std::size_t p = 0; p < 3; ++p) sum[p] += colour[p] / (samples * samples);
      }
      for (std::size_t p = 0; p < 3; ++p) {
        picture.planes[p](row, col) = srgb_from_linear(float(std::min(sum[p], 1.0)));
      }
    }
  });
  return picture;
}

}  // namespace

Image worn_picture(const Body& body, const WornKnit& knit, const TautYarns& yarns,
                   const WornView& view) {
  const Camera camera = camera_for(knit, view);
  const Scene scene(body, knit, &yarns, camera, view.yarn_radius_mm);
  Image picture = painted(camera, [&](const Vector3d& from) { return scene.yarn_colour(from); });
  draw_scale_bar(picture, camera.pitch_mm, ink);
  return picture;
}

Image worn_map(const Body& body, const WornKnit& knit, const std::vector<double>& values,
               const std::string& unit, const WornView& view) {
  const Camera camera = camera_for(knit, view);
  const Scene scene(body, knit, nullptr, camera, view.yarn_radius_mm);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  Image picture = painted(camera, [&, low = *low, high = *high](const Vector3d& from) {
    return scene.map_colour(from, values, low, high);
  });
  draw_scale_bar(picture, camera.pitch_mm, ink);
  draw_colour_bar(picture, *low, *high, unit, ink);
  return picture;
}

}  // namespace hada
