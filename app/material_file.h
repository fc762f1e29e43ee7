#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/extent.h"
#include "core/grid.h"
#include "core/random.h"
#include "fit/fit.h"
#include "synth/material.h"

namespace hada {

/// A material as it is kept in a file (`"hada": "material/1"`): what it is, how sure that is, and
/// enough about its origin to repeat it. Only the material itself must be there.
struct MaterialFile {
  struct Input {
    std::string name;  // of the file or folder it was fitted to
    std::string hash;  // of the values there
    Extent extent;     // unit, pitch and size
  };

  Material material;
  std::optional<Material> sigma;  // standard deviation, field by field
  Unit unit = Unit::mm;           // what "mm" in the names of the parameters stands for
  /// Of a picture whose brightness was fitted: linear, one value or three, see `painted`. Empty: a
  /// height was fitted, or a material that has an albedo of its own.
  std::vector<double> mean_albedo;
  double goodness_p = std::numeric_limits<double>::quiet_NaN();
  double runner_up_gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> on_bound;
  std::vector<FieldInterval> intervals;  // of parameters near a bound, where sigma says little
  int starts = 0;
  int agreeing = 0;
  /// Words that the data leave open: those of each choice cannot be told apart. Likeliest first.
  struct Choice {
    std::vector<std::string> words;
    double probability;
  };
  std::vector<Choice> choices;
  std::vector<std::pair<std::string, double>> kinds;  // names that people give, with probabilities
  /// What a sheet has beyond its spectrum, without and with the ridges of the material.
  struct BeyondSpectrum {
    struct Side {
      double chi_square = 0.0;  // of six moments of height, slope and curvature
      /// Mean distance of the quantiles in standard deviations; NaN where nothing was compared.
      double height = std::numeric_limits<double>::quiet_NaN(), slope = height, curvature = height;
    };
    Side gaussian, ridged;
  };
  std::optional<BeyondSpectrum> beyond_spectrum;
  std::vector<std::string> remarks;
  std::optional<Seed> seed;
  std::optional<Input> input;
};

/// throws  Error naming the file and the key for unknown or missing keys, an unknown material, and
///         values outside their bounds
MaterialFile read_material(const std::filesystem::path& path);

/// The same of a text that came another way; `where` names it in errors.
MaterialFile material_of(const std::string& text, const std::string& where);

std::string material_text(const MaterialFile& file);

/// 16 hexadecimal digits that change with any bit of the values (FNV-1a over their bytes).
std::string hash_of(const Grid<float>& values);

std::string_view name_of(const Material& material);

/// The names of all materials: "wrinkle, wood".
std::string material_names();

/// The default material of that name. throws  Error that lists the names if there is none
Material material_named(const std::string& name);

}  // namespace hada
