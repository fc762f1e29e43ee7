#include "app/telling.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

// "8 distant lights"; near ones have a position.
std::string lights_told(const std::vector<Light>& lights) {
  const auto near = std::count_if(lights.begin(), lights.end(),
                                  [](const Light& light) { return light.position.has_value(); });
  if (near == 0) return counted(lights.size(), "distant light");
  const std::string text = counted(std::size_t(near), "near light");
  const std::size_t distant = lights.size() - std::size_t(near);
  return distant == 0 ? text : text + " and " + counted(distant, "distant one");
}

// "2 spheres (matte, chrome)"
std::string spheres_told(const std::vector<Sphere>& spheres) {
  std::string kinds;
  for (const Sphere& sphere : spheres) {
    kinds += (kinds.empty() ? "" : ", ") + std::string(name_of(sphere.kind));
  }
  return counted(spheres.size(), "sphere") + " (" + kinds + ")";
}

double root_mean_square(const Grid<float>& values, const Mask& mask) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask[i]) continue;
    sum += double(values[i]) * values[i];
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

}  // namespace

double direction_sigma_deg(const std::vector<Light>& lights) {
  double sum = 0.0;
  int count = 0;
  for (const auto& light : lights) {
    if (!std::isfinite(light.direction_sigma)) continue;
    sum += light.direction_sigma * light.direction_sigma;
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(sum / count) / degree;
}

double mean_deg(const std::vector<double>& radians) {
  double sum = 0.0;
  for (const double angle : radians) sum += angle;
  return radians.empty() ? 0.0 : sum / double(radians.size()) / degree;
}

std::string size_text(const Extent& extent) {
  return fmt::format("{} x {}", extent.cols, extent.rows);
}

std::string with_sigma(double value, double sigma) {
  if (!(sigma > 0.0) || !std::isfinite(sigma)) return fmt::format("{:.4g}", value);
  constexpr double exact = 1e-6;  // of the value: more digits tell nobody anything
  if (sigma < exact * std::abs(value)) return fmt::format("{:.6g}", value);
  // Two digits of the sigma, and the value as far as they reach.
  const double size = std::max(std::abs(value), sigma);
  if (size < 1e-4) return fmt::format("{:.3g} \u00b1 {:.2g}", value, sigma);
  const int digits = std::clamp(1 - int(std::floor(std::log10(sigma))), 0, 12);
  return fmt::format("{:.{}f} \u00b1 {:.{}f}", value, digits, sigma, digits);
}

std::string told(const Calibration& c) {
  std::vector<Sphere> spheres;
  for (const auto& reading : c.readings) spheres.push_back(reading.sphere);
  std::string text =
      lights_told(c.lights) + " read off " + spheres_told(spheres) +
      fmt::format(", each direction known to {:.2g} deg", direction_sigma_deg(c.lights));
  if (c.readings.size() > 1) {
    text += fmt::format("; the spheres disagree by {:.2f} deg", c.disagreement / degree);
  }
  return text;
}

std::string told(const LitCapture& lit) {
  if (lit.calibration) return told(*lit.calibration);
  std::string text = lights_told(lit.lights.lights) + " taken from " + lit.source;
  if (!lit.lights.spheres.empty()) text += ", read off " + spheres_told(lit.lights.spheres);
  return text;
}

std::string told(const Reconstruction& r) {
  const Surface& s = r.surface;
  const auto unit = name_of(s.extent.unit);
  std::string text = fmt::format("surface of {} pixels ({:.4g} x {:.4g} {}): height {:.3g} {} rms",
                                 size_text(s.extent), s.extent.width(), s.extent.height(), unit,
                                 root_mean_square(s.height, s.mask), unit);
  if (!s.normal_sigma.empty()) {
    text += fmt::format(", normals known to {:.2g} deg",
                        root_mean_square(s.normal_sigma, s.mask) / degree);
  }
  text += fmt::format(", relighting error {:.1f} %", 100.0 * r.relighting_error);
  if (!(r.left_out_error > 0.0)) return text;  // too few lights to leave one out
  return text + fmt::format(" ({:.1f} % of samples left out)", 100.0 * r.left_out_error);
}

std::vector<std::string> told(const MaterialFile& file) {
  std::map<std::string, double> sigma;
  if (file.sigma) {
    std::visit(
        [&](const auto& m) {
          visit_fields(
              m, [&](const std::string& path, const auto&, double value) { sigma[path] = value; });
        },
        *file.sigma);
  }
  std::vector<std::string> lines;
  std::string group;
  std::visit(
      [&](const auto& m) {
        visit_words(m, [&](const auto& word, const std::string& text) {
          lines.push_back(fmt::format("  {} {}", word.name, text));
        });
        visit_fields(m, [&](const std::string& path, const auto& field, double value) {
          if (is_left_out(field, value)) return;
          // One line for a part, one for a list of numbers, one for a field.
          const bool listed = path.back() == ']';
          const auto end = path.rfind(listed ? '[' : '.');
          const std::string owner = end == std::string::npos ? "" : path.substr(0, end);
          if (owner != group || lines.empty() || owner.empty()) {
            lines.push_back("  " + (owner.empty() ? "" : owner + ": "));
          } else {
            lines.back() += ", ";
          }
          group = owner;
          if (!listed) lines.back() += std::string(field.name) + " ";
          lines.back() += with_sigma(value, sigma[path]);
        });
      },
      file.material);
  constexpr std::size_t most_choices = 5;
  for (std::size_t k = 0; k < std::min(most_choices, file.choices.size()); ++k) {
    lines.push_back(fmt::format("  {:5.1f} %  {}", 100.0 * file.choices[k].probability,
                                fmt::join(file.choices[k].words, " = ")));
  }
  if (!file.kinds.empty()) {
    std::string kinds;
    for (const auto& [kind, probability] : file.kinds) {
      kinds += fmt::format("{}{} {:.1f} %", kinds.empty() ? "  " : ", ", kind, 100.0 * probability);
    }
    lines.push_back(kinds);
  }
  if (file.choices.empty()) {
    lines.insert(lines.begin(), fmt::format("{} ({} of {} starts agree)", name_of(file.material),
                                            file.agreeing, file.starts));
  } else {
    lines.insert(lines.begin(),
                 fmt::format("{} (of {} sequences)", name_of(file.material), file.starts));
  }
  return lines;
}

std::string told(const TruthCheck& truth) {
  std::string text =
      fmt::format("against the truth: lights {:.2f} deg", mean_deg(truth.light_errors));
  if (truth.surface.overlap) {
    const Overlap& o = *truth.surface.overlap;
    text += fmt::format(", normals {:.2f} deg, height {:.2f} % of its spread",
                        o.normal_mean / degree, 100.0 * o.height_rmse / o.height_std);
  }
  return text;
}

}  // namespace hada
