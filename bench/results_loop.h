#pragma once

#include <string>

namespace hada {

/// Lights, normals and height of virtual captures, as a section of the page of results.
std::string virtual_captures();

/// Wrinkles all the way round, with what their intervals hold, as a section of the page of results.
std::string closed_loop();

}  // namespace hada
