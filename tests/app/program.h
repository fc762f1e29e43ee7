#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <sys/wait.h>

#include "tests/io/temporary_folder.h"

namespace hada {

struct Answer {
  int code = 0;
  std::string out;
  std::string err;
};

/// What the real program says to these words, run in a folder of its own.
inline Answer answer(const std::string& words) {
  const TemporaryFolder scratch;
  const std::string command = std::string("'") + HADA_PROGRAM + "' " + words + " > '" +
                              (scratch / "out").string() + "' 2> '" + (scratch / "err").string() +
                              "'";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), bytes_of(scratch / "out"), bytes_of(scratch / "err")};
}

/// A recipe that is photographed in a tenth of a second: a sheet and one matte sphere, four lights.
inline std::string small_recipe(double sphere_x_mm = 45.0) {
  const auto light = [](double slant, double azimuth) {
    return "{\"slant_deg\": " + std::to_string(slant) +
           ", \"azimuth_deg\": " + std::to_string(azimuth) + ", \"strength\": 1.0}";
  };
  return R"({"hada": "recipe/1", "name": "small", "material": {"material": "wrinkle",
    "parameters": {"components": [{"amplitude_mm": 0.3, "long_mm": 6.0, "short_mm": 3.0,
    "angle_rad": 0.4}], "floor_mm4": 0.0}},
    "sheet": {"width_mm": 80.0, "height_mm": 80.0, "seed": 3},
    "rig": {"pitch_mm": 0.8, "rows": 110, "cols": 180, "oversampling": 2,
    "sheet_place_mm": [-25.0, 0.0], "lights": [)" +
         light(30, 0) + ", " + light(40, 90) + ", " + light(35, 180) + ", " + light(45, 270) +
         R"(], "light_diameter_deg": 2.0, "spheres": [{"kind": "matte", "place_mm": [)" +
         std::to_string(sphere_x_mm) + R"(, 0.0], "diameter_mm": 36.0, "albedo": 0.7}],
    "table_albedo": 0.02, "ambient": 0.0, "exposure": 0.8, "read_noise": 0.0005,
    "shot_noise": 0.002, "bits": 16, "seed": 7}})";
}

/// Photographs the small recipe into `folder`.
inline Answer make_capture(const std::filesystem::path& folder) {
  const TemporaryFolder scratch;
  put(scratch / "small.json", small_recipe());
  return answer("photograph " + (scratch / "small.json").string() + " -o " + folder.string());
}

}  // namespace hada
