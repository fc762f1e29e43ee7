#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace hada {

/// A formula of a place, as shader editors know it: numbers joined by arithmetic, and pictures that
/// are looked up. A node reads nodes that come before it.
class NodeGraph {
 public:
  using Id = int;
  enum class Op {
    number,
    x,
    y,
    z,
    add,
    subtract,
    multiply,
    divide,
    least,
    most,
    sine,
    cosine,
    arctangent,
    root,
    fraction,
    lookup
  };

  struct Node {
    Op op;
    std::array<Id, 2> in{0, 0};  // arctangent: y, x; lookup: u to the right, v up, both 0 to 1
    double value = 0.0;          // of a number
    std::string picture;         // that is looked up, linear between texels, v endless
  };

  Id number(double value) { return put({Op::number, {0, 0}, value, {}}); }
  Id place(Op axis) { return put({axis, {0, 0}, 0.0, {}}); }
  Id join(Op op, Id a, Id b) { return put({op, {a, b}, 0.0, {}}); }
  Id of(Op op, Id a) { return put({op, {a, a}, 0.0, {}}); }
  Id lookup(const std::string& picture, Id u, Id v) {
    return put({Op::lookup, {u, v}, 0.0, picture});
  }

  /// The last one is what the graph is for.
  const std::vector<Node>& nodes() const { return nodes_; }

  /// What a picture shows at (u, v).
  using Look = std::function<double(const std::string& picture, double u, double v)>;

  /// The value of every node at a place.
  std::vector<double> values_at(const std::array<double, 3>& place, const Look& look) const;

 private:
  Id put(Node node) {
    nodes_.push_back(std::move(node));
    return Id(nodes_.size()) - 1;
  }

  std::vector<Node> nodes_;
};

}  // namespace hada
