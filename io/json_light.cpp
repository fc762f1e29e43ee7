#include "io/json_light.h"

namespace hada {

Eigen::Vector3d vector_from(JsonObject& object, const std::string& key) {
  const auto values = object.numbers(key, 3);
  return {values[0], values[1], values[2]};
}

Json json_of_vector(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

Eigen::Vector3d direction_from(JsonObject& object, const std::string& key) {
  const Eigen::Vector3d way = vector_from(object, key);
  const double length = way.stableNorm();  // the squares of tiny or huge numbers would vanish
  if (!(length > 0.0)) object.fail(key, "has no length; give the way from the sample to the light");
  return (way / length).normalized();
}

Eigen::Vector3d strength_from(JsonObject& object, const std::string& key) {
  const Eigen::Vector3d strength = object.is_list(key)
                                       ? vector_from(object, key)
                                       : Eigen::Vector3d::Constant(object.number(key)).eval();
  if (strength.minCoeff() <= 0.0) object.fail(key, "must be larger than 0");
  return strength;
}

Json json_of_strength(const Eigen::Vector3d& strength) {
  if ((strength.array() == strength.x()).all()) return strength.x();
  return json_of_vector(strength);
}

}  // namespace hada
