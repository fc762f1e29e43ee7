#pragma once

#include <string>

#include <Eigen/Core>

#include "io/json.h"

/// How vectors and strengths of light are spelled in every file that knows them.
namespace hada {

/// Three finite numbers.
Eigen::Vector3d vector_from(JsonObject& object, const std::string& key);
Json json_of_vector(const Eigen::Vector3d& vector);

/// The way to a light, made unit length.
/// throws  Error if it has no length
Eigen::Vector3d direction_from(JsonObject& object, const std::string& key);

/// One positive number for all channels, or [r, g, b].
Eigen::Vector3d strength_from(JsonObject& object, const std::string& key);
Json json_of_strength(const Eigen::Vector3d& strength);

}  // namespace hada
