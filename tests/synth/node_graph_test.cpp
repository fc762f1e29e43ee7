#include "synth/node_graph.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Op = NodeGraph::Op;

TEST(NodeGraph, WorksOutEachNodeFromThoseBefore) {
  NodeGraph graph;
  const auto x = graph.place(Op::x), y = graph.place(Op::y), z = graph.place(Op::z);
  const auto square =
      graph.join(Op::add, graph.join(Op::multiply, x, x), graph.join(Op::multiply, y, y));
  const auto r = graph.of(Op::root, square);
  const auto theta = graph.join(Op::arctangent, y, x);
  const auto wave = graph.join(Op::subtract, graph.of(Op::cosine, z), graph.of(Op::sine, z));
  const auto held = graph.join(Op::least, graph.join(Op::most, wave, graph.number(-0.5)), r);
  const auto part = graph.of(Op::fraction, graph.join(Op::divide, theta, graph.number(2.0)));
  graph.lookup("section", part, held);
  const auto values = graph.values_at({3.0, -4.0, 2.0}, [](const auto& name, double u, double v) {
    EXPECT_EQ(name, "section");
    return 10.0 * u + v;
  });
  ASSERT_EQ(values.size(), graph.nodes().size());
  EXPECT_DOUBLE_EQ(values[std::size_t(r)], 5.0);
  EXPECT_DOUBLE_EQ(values[std::size_t(theta)], std::atan2(-4.0, 3.0));
  EXPECT_DOUBLE_EQ(values[std::size_t(held)], -0.5);
  EXPECT_DOUBLE_EQ(values[std::size_t(part)], 1.0 + 0.5 * std::atan2(-4.0, 3.0));
  EXPECT_DOUBLE_EQ(values.back(), 10.0 * values[std::size_t(part)] - 0.5);
}

}  // namespace
}  // namespace hada
