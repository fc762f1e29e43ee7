#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/comparison.h"
#include "app/lit_capture.h"
#include "app/material_file.h"
#include "app/measurement.h"
#include "io/output.h"
#include "reconstruct/reconstruct.h"

namespace hada {

/// What is known of a surface that was not measured but made: how close the path came to it.
struct TruthCheck {
  Comparison surface;
  std::vector<double> light_errors;  // radians
  Material material;                 // what it was made from
};

/// Everything from the photographs to the new surface.
struct WholePath {
  std::string name;  // of the capture, for a person
  LitCapture lit;
  Reconstruction reconstruction;
  Measurement measurement;
  MaterialFile material;
  Surface synthesized;
  std::optional<TruthCheck> truth;
};

struct WholePathOptions {
  std::string material = "wrinkle";
  int components = 0;  // 0: the data decide
  Seed seed = 1;       // of the new surface
};

/// photographs -> lights -> surface -> measurement -> material -> more of the surface.
WholePath whole_path(LitCapture lit, const std::string& name, const WholePathOptions& options,
                     const Terminal& terminal);

/// How close the path came to the truth that a virtual camera left in `folder`.
TruthCheck check_truth(const WholePath& path, const std::filesystem::path& folder);

/// Writes lights.json, surface/, measure.json, material.json, synth/ and report.html.
void write_whole_path(const WholePath& path, Output& output);

/// The few lines that a person reads first.
void tell(const WholePath& path, const std::filesystem::path& folder, const Terminal& terminal);

/// The same for a program.
std::string whole_path_text(const WholePath& path, const std::filesystem::path& folder);

}  // namespace hada
