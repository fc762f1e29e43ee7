#pragma once

#include <string>

#include "app/draw/maps.h"
#include "app/whole_path.h"

/// The sections of the report, each a piece of HTML.
namespace hada {

/// A relief with its scale and its colours.
std::string relief_figure(const Surface& surface, const ReliefStyle& style,
                          const std::string& caption);

/// What was measured: the pictures with spheres and highlights on them, and the lights.
std::string pictures_section(const WholePath& path);
std::string lights_section(const WholePath& path);

/// What was found: height, normals, albedo, and how sure each is.
std::string surface_section(const WholePath& path);

/// Rings, sectors and spectrum, measured against the fitted material.
std::string spectrum_section(const WholePath& path);

/// The parameters with their sigma.
std::string material_section(const WholePath& path);

/// Measured and new surface side by side.
std::string synthesis_section(const WholePath& path);

/// How close the path came to a known truth; empty where there is none.
std::string truth_section(const WholePath& path);

/// What is poor and what would help.
std::string advice_section(const WholePath& path);

}  // namespace hada
