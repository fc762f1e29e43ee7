#include "synth/node_graph.h"

#include <algorithm>
#include <cmath>

namespace hada {

std::vector<double> NodeGraph::values_at(const std::array<double, 3>& place,
                                         const Look& look) const {
  std::vector<double> values;
  for (const Node& node : nodes_) {
    const double a = values.empty() ? 0.0 : values[std::size_t(node.in[0])];
    const double b = values.empty() ? 0.0 : values[std::size_t(node.in[1])];
    const auto value = [&] {
      switch (node.op) {
        case Op::number:
          return node.value;
        case Op::x:
          return place[0];
        case Op::y:
          return place[1];
        case Op::z:
          return place[2];
        case Op::add:
          return a + b;
        case Op::subtract:
          return a - b;
        case Op::multiply:
          return a * b;
        case Op::divide:
          return a / b;
        case Op::least:
          return std::min(a, b);
        case Op::most:
          return std::max(a, b);
        case Op::sine:
          return std::sin(a);
        case Op::cosine:
          return std::cos(a);
        case Op::arctangent:
          return std::atan2(a, b);
        case Op::root:
          return std::sqrt(a);
        case Op::fraction:
          return a - std::floor(a);
        case Op::lookup:
          return look(node.picture, a, b);
      }
      return 0.0;
    };
    values.push_back(value());
  }
  return values;
}

}  // namespace hada
