#include "synth/wood_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "synth/wood_solid.h"

namespace hada {
namespace {

using Op = NodeGraph::Op;
using Id = NodeGraph::Id;

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double texels_per_pixel = 2.0;  // of the cut
constexpr int most_texels = 4096;         // along a side of a picture
constexpr int lean_rows = 512;
constexpr double beyond = 1.1;  // of what the cut reaches

/// How far the cut goes.
struct Reach {
  double rho = 0.0;  // largest effective radius, mm
  double z = 1.0;    // largest height above z = 0 or below, mm
};

Reach reach_of(const Wood<>& wood, const WoodSolid& solid, const Extent& extent) {
  const Cut cut = cut_of(wood);
  Reach reach;
  constexpr int parts = 32;  // of each side
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; j <= parts; ++j) {
      const StemVector at = cut.at((double(i) / parts - 0.5) * extent.width(),
                                   (double(j) / parts - 0.5) * extent.height());
      reach.rho = std::max(reach.rho, solid.place_at(at).rho);
      reach.z = std::max(reach.z, std::abs(at[2]));
    }
  }
  if (!wood.ring_radii_mm.empty()) reach.rho = std::max(reach.rho, wood.ring_radii_mm.back());
  reach.z = std::max(reach.z, 0.5 * std::max(extent.width(), extent.height()));
  return {beyond * reach.rho, beyond * reach.z};
}

int texels(double length, double pitch) {
  return std::clamp(int(std::ceil(length / pitch)), 2, most_texels);
}

Image section_picture(const WoodSolid& solid, double rho, double pitch) {
  Image picture(texels(turn * rho, pitch), texels(rho, pitch), 3);
  const double step = rho / picture.cols();
  for_each_index(picture.rows(), [&](int row) {
    for (int col = 0; col < picture.cols(); ++col) {
      const auto place =
          solid.place_in_section((col + 0.5) * step, turn * (row + 0.5) / picture.rows());
      const auto colour = solid.colour_at(place, step);
      for (std::size_t c = 0; c < 3; ++c) picture.planes[c](row, col) = colour[c];
    }
  });
  return picture;
}

Image lean_picture(const WoodSolid& solid, const Reach& reach, double pitch) {
  Image picture(lean_rows, texels(reach.rho, pitch), 1);
  for_each_index(picture.rows(), [&](int row) {
    const double z = reach.z * (1.0 - 2.0 * (row + 0.5) / picture.rows());
    for (int col = 0; col < picture.cols(); ++col)
      picture.planes[0](row, col) =
          float(solid.arc_at((col + 0.5) * reach.rho / picture.cols(), z));
  });
  return picture;
}

/// Writes formulas into a graph.
class Writer {
 public:
  explicit Writer(NodeGraph& graph) : graph_(graph) {}

  Id number(double value) { return graph_.number(value); }
  Id add(Id a, Id b) { return graph_.join(Op::add, a, b); }
  Id subtract(Id a, Id b) { return graph_.join(Op::subtract, a, b); }
  Id times(Id a, double b) { return graph_.join(Op::multiply, a, number(b)); }
  Id times(Id a, Id b) { return graph_.join(Op::multiply, a, b); }
  Id over(Id a, Id b) { return graph_.join(Op::divide, a, b); }
  Id of(Op op, Id a) { return graph_.of(op, a); }
  Id within(Id a, double low, double high) {
    return graph_.join(Op::least, graph_.join(Op::most, a, number(low)), number(high));
  }
  /// `share` of a side of `count` texels, between the middles of the first and the last.
  Id inside(Id share, int count) { return within(share, 0.5 / count, 1.0 - 0.5 / count); }

 private:
  NodeGraph& graph_;
};

/// r (1 + sum of lobes), `effective_radius` of synth/growth.h.
Id grown(Writer& w, const Wood<>& wood, Id r, Id theta) {
  Id factor = w.number(1.0);
  std::map<double, std::pair<Id, Id>> waves;  // by order
  for (const auto& lobe : wood.lobes) {
    if (lobe.cosine == 0.0 && lobe.sine == 0.0) continue;
    if (!waves.contains(lobe.order)) {
      const Id angle = w.times(theta, lobe.order);
      waves[lobe.order] = {w.of(Op::cosine, angle), w.of(Op::sine, angle)};
    }
    const auto [cosine, sine] = waves[lobe.order];
    Id height = w.add(w.times(cosine, lobe.cosine), w.times(sine, lobe.sine));
    if (lobe.to_mm > lobe.from_mm) {
      const Id above = w.subtract(r, w.number(lobe.from_mm));
      height =
          w.times(height, w.within(w.times(above, 1.0 / (lobe.to_mm - lobe.from_mm)), 0.0, 1.0));
    }
    factor = w.add(factor, height);
  }
  return w.times(r, factor);
}

}  // namespace

WoodGraph wood_graph(const Wood<>& wood, const Extent& extent, Seed seed) {
  WoodGraph graph;
  graph.complete = wood.wobble_mm == 0.0 && wood.figure_specular == 0.0;
  Wood<> plain = wood;
  plain.wobble_mm = 0.0;
  const WoodSolid solid(plain, seed);
  const Reach reach = reach_of(plain, solid, extent);
  const double pitch = extent.pitch / texels_per_pixel;
  const Image& section = graph.pictures["section"] = section_picture(solid, reach.rho, pitch);

  Writer w(graph.nodes);
  const Id z = graph.nodes.place(Op::z);
  const auto arm = [&](Op axis, double pith, double lean) {
    return w.subtract(graph.nodes.place(axis), w.add(w.number(pith), w.times(z, lean)));
  };
  const Id dx = arm(Op::x, wood.pith_mm[0], wood.pith_lean[0]);
  const Id dy = arm(Op::y, wood.pith_mm[1], wood.pith_lean[1]);
  const Id r = w.of(Op::root, w.add(w.times(dx, dx), w.times(dy, dy)));
  const Id theta = graph.nodes.join(Op::arctangent, dy, dx);
  const Id rho = w.add(grown(w, wood, r, theta), w.times(z, wood.taper));

  Id arc = w.times(z, wood.spiral);
  if (wood.wave_amplitude > 0.0) {
    const double wave = turn / wood.wave_length_mm;
    const Id phase = w.add(w.times(z, wave), w.number(wood.wave_phase_rad));
    const Id swing = w.subtract(w.number(std::cos(wood.wave_phase_rad)), w.of(Op::cosine, phase));
    arc = w.add(arc, w.times(swing, wood.wave_amplitude / wave));
  }
  if (wood.interlock_amplitude > 0.0 || wood.fluctuation > 0.0) {
    plain.spiral = plain.wave_amplitude = 0.0;
    const Image& lean = graph.pictures["lean"] = lean_picture(WoodSolid(plain, seed), reach, pitch);
    const Id u = w.inside(w.times(rho, 1.0 / reach.rho), lean.cols());
    const Id v = w.add(w.times(z, 0.5 / reach.z), w.number(0.5));
    arc = w.add(arc, graph.nodes.lookup("lean", u, w.inside(v, lean.rows())));
  }
  const Id thick = graph.nodes.join(Op::most, r, w.number(1e-6));
  const Id angle = w.subtract(theta, w.over(arc, thick));
  const Id around = w.of(Op::fraction, w.times(angle, 1.0 / turn));
  const Id u = w.inside(w.times(rho, 1.0 / reach.rho), section.cols());
  graph.nodes.lookup("section", u, w.subtract(w.number(1.0), around));
  return graph;
}

}  // namespace hada
