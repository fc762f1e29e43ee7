#include "reconstruct/coarse_nodes.h"

#include <algorithm>
#include <utility>

namespace hada {
namespace {

// Nodes by how many others would profit, the latest first among equals.
class Queue {
 public:
  explicit Queue(std::vector<int> gain)
      : gain_(std::move(gain)), next_(gain_.size(), none), previous_(gain_.size(), none) {}

  int gain(int node) const { return gain_[std::size_t(node)]; }
  void insert(int node) {
    const auto list = std::size_t(gain(node));
    if (list >= first_.size()) first_.resize(list + 1, none);
    const int after = first_[list];
    next_[std::size_t(node)] = after;
    previous_[std::size_t(node)] = none;
    if (after != none) previous_[std::size_t(after)] = node;
    first_[list] = node;
  }
  void remove(int node) {
    const int before = previous_[std::size_t(node)];
    const int after = next_[std::size_t(node)];
    (before != none ? next_[std::size_t(before)] : first_[std::size_t(gain(node))]) = after;
    if (after != none) previous_[std::size_t(after)] = before;
  }
  void change(int node, int by) {
    remove(node);
    // What depends on what is not quite the same seen from both ends of an edge: they are rounded
    // apart.
    gain_[std::size_t(node)] = std::max(0, gain_[std::size_t(node)] + by);
    insert(node);
  }
  // One with the largest gain; -1 if none is left.
  int take() {
    while (!first_.empty() && first_.back() == none) first_.pop_back();
    if (first_.empty()) return none;
    const int node = first_.back();
    remove(node);
    return node;
  }

 private:
  static constexpr int none = -1;
  std::vector<int> gain_, next_, previous_;
  std::vector<int> first_;  // of the nodes of every gain
};

enum : std::uint8_t { fine, coarse, undecided };

}  // namespace

std::vector<float> heaviest_edges(const SparseRows& graph) {
  std::vector<float> heaviest(std::size_t(graph.rows()), 0.0f);
  for (int node = 0; node < graph.rows(); ++node) {
    for (const float weight : graph.weights_of(node)) {
      heaviest[std::size_t(node)] = std::max(heaviest[std::size_t(node)], weight);
    }
  }
  return heaviest;
}

std::vector<std::uint8_t> coarse_nodes(const SparseRows& graph) {
  const std::vector<float> heaviest = heaviest_edges(graph);
  const auto depends = [&](int node, float weight) {
    return is_strong(weight, heaviest[std::size_t(node)]);
  };
  // work(other) for all others that `node` depends on, or that depend on it.
  const auto for_strong = [&](int node, bool on_others, const auto& work) {
    const auto columns = graph.columns_of(node);
    const auto weights = graph.weights_of(node);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (depends(on_others ? node : columns[i], weights[i])) work(columns[i]);
    }
  };
  std::vector<int> gain(std::size_t(graph.rows()), 0);
  for (int node = 0; node < graph.rows(); ++node) {
    for_strong(node, false, [&](int) { ++gain[std::size_t(node)]; });
  }
  Queue queue(std::move(gain));
  std::vector<std::uint8_t> kind(std::size_t(graph.rows()), fine);
  for (int node = graph.rows() - 1; node >= 0; --node) {
    if (heaviest[std::size_t(node)] == 0.0f) continue;
    kind[std::size_t(node)] = undecided;
    queue.insert(node);
  }
  for (int node = queue.take(); node >= 0; node = queue.take()) {
    const auto is_undecided = [&](int other) { return kind[std::size_t(other)] == undecided; };
    kind[std::size_t(node)] = coarse;
    if (queue.gain(node) == 0) {  // no other profits: coarse only if it depends on none that is
      for_strong(node, true, [&](int other) {
        if (kind[std::size_t(other)] == coarse) kind[std::size_t(node)] = fine;
      });
      continue;
    }
    for_strong(node, false, [&](int other) {
      if (!is_undecided(other)) return;
      queue.remove(other);
      kind[std::size_t(other)] = fine;
      for_strong(other, true, [&](int third) {
        if (is_undecided(third)) queue.change(third, 1);
      });
    });
    for_strong(node, true, [&](int other) {
      if (is_undecided(other)) queue.change(other, -1);
    });
  }
  return kind;
}

}  // namespace hada
