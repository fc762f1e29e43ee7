#include "app/reconstruction_files.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "app/files.h"
#include "io/image_file.h"
#include "io/json.h"
#include "io/surface_file.h"
#include "reconstruct/labels.h"

namespace hada {
namespace {

struct Look {
  Sample label;
  const char* name;  // as in the notes
  const char* told;
  std::array<float, 3> colour;  // sRGB
};

constexpr std::array looks{
    Look{Sample::lit, "lit", "lit", {0.93f, 0.93f, 0.90f}},
    Look{Sample::shadowed, "shadowed", "too dark to tell", {0.45f, 0.45f, 0.45f}},
    Look{Sample::saturated, "saturated", "saturated", {0.84f, 0.15f, 0.16f}},
    Look{Sample::attached_shadow, "attached_shadow", "in attached shadow", {0.10f, 0.10f, 0.10f}},
    Look{Sample::cast_shadow, "cast_shadow", "in cast shadow", {0.12f, 0.40f, 0.70f}},
    Look{Sample::highlight, "highlight", "highlights", {1.0f, 0.75f, 0.10f}},
};

Image picture_of(const Grid<Sample>& labels, const Mask& mask) {
  Image picture(labels.rows(), labels.cols(), 3);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      picture.planes[c][i] = mask[i] ? looks[std::size_t(labels[i])].colour[c] : 1.0f;
    }
  }
  return picture;
}

Grid<float> inside(Grid<float> values, const Mask& mask) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask[i]) values[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return values;
}

Grid<float> as_bytes(const Grid<std::uint8_t>& counts) {
  Grid<float> values(counts.rows(), counts.cols());
  for (std::size_t i = 0; i < counts.size(); ++i) values[i] = float(counts[i]) / 255.0f;
  return values;
}

}  // namespace

std::string surface_notes(const Reconstruction& r, const LitCapture& lit) {
  Json notes = {{"estimator", std::string(name_of(r.estimator))}};
  const auto note = [&](const char* key, double value) {
    if (std::isfinite(value)) notes[key] = value;
  };
  note("noise", r.noise);
  note("relighting_error", r.relighting_error);
  note("left_out_error", r.left_out_error);
  note("condition", r.condition);
  if (!r.labels.empty()) {
    const auto shares = label_shares(r.labels, r.surface.mask);
    for (const Look& look : looks) notes["samples"][look.name] = shares[std::size_t(look.label)];
  }
  for (const auto* remarks : {&lit.remarks, &r.remarks}) {
    for (const auto& remark : *remarks) notes["remarks"].push_back(remark);
  }
  notes["version"] = version();
  return notes.dump(1);
}

void put_reconstruction(Output& output, const std::string& folder, const Reconstruction& r,
                        const LitCapture& lit) {
  write_surface(output, folder, r.surface, surface_notes(r, lit));
  put_text(output, folder + "lights.json", lights_text(lit.lights));
  put_previews(output, folder, r.surface);
  write_exr(output.file(folder + "albedo_sigma.exr"),
            Image(inside(r.albedo_sigma, r.surface.mask)));
  write_integer_image(output.file(folder + "inliers.png"), Image(as_bytes(r.inliers)), 8);
  for (std::size_t k = 0; k < r.labels.size(); ++k) {
    put_picture(output, folder + fmt::format("labels/{:02}.png", k + 1),
                picture_of(r.labels[k], r.surface.mask));
  }
}

std::string told_of_labels(const Reconstruction& r) {
  if (r.labels.empty()) return "";
  std::string text = "samples: ";
  const auto shares = label_shares(r.labels, r.surface.mask);
  for (const Look& look : looks) {
    if (text.back() != ' ') text += ", ";
    text += fmt::format("{:.2f} % {}", 100.0 * shares[std::size_t(look.label)], look.told);
  }
  return text;
}

}  // namespace hada
