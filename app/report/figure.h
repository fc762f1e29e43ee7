#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/draw/maps.h"
#include "app/draw/spectrum_picture.h"
#include "app/report/plot.h"
#include "core/sphere.h"

/// Figures of the report: an SVG that holds the picture, its scale and its colours, and a caption.
namespace hada {

/// What the colours of a map mean.
struct ColourBar {
  Range range;
  std::string label;  // with its unit
};

struct MapFigure {
  Image picture;
  double width = 0.0;       // of the picture, in `unit`
  std::string unit = "mm";  // of the scale bar
  std::optional<ColourBar> colours;
  std::string caption;
};

std::string map_figure(const MapFigure& figure);

/// A spectrum with its frequency axes. unit: of the surface ("mm"); power_unit: of the density,
/// that of a height in `unit` if it is not given.
std::string spectrum_figure(const Image& picture, const SpectrumStyle& style,
                            const std::string& unit, const std::string& caption,
                            const std::string& power_unit = "");

/// A small photograph with circles on the spheres and a cross on each highlight.
struct PhotographFigure {
  Image picture;       // a thumbnail
  double pixel = 1.0;  // photograph pixels to one of the thumbnail
  std::vector<Sphere> spheres;
  std::vector<Eigen::Vector2d> highlights_px;
  std::string caption;
};

std::string photograph_figure(const PhotographFigure& figure);

/// A plot with a caption.
std::string plot_figure(const std::string& svg, const std::string& caption);

}  // namespace hada
