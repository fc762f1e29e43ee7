#pragma once

#include <cstddef>
#include <utility>
#include <variant>

#include "synth/material.h"

namespace hada {

/// Calls `visit` with the default of every material in the variant, in its order.
template <class Visit>
void for_each_material(const Visit& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(std::variant_alternative_t<I, Material>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Material>>{});
}

}  // namespace hada
