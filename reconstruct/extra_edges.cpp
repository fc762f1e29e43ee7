#include "reconstruct/extra_edges.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hada {

Place place_of(const PixelLevel& level, PixelLevel::Node node) {
  if (level.is_extra(node)) {
    const auto& extra = level.extras[std::size_t(node) - level.at.size()];
    return {extra.row, extra.col};
  }
  const auto stride = level.at.stride();
  const auto in_row = node % stride;
  return {int(node / stride) - 1,
          int(in_row < level.at.block ? 2 * in_row : 2 * (in_row - level.at.block) + 1)};
}

Way way_between(const Place& a, const Place& b) {
  if (a.row != b.row) return Way::along;
  return a.col != b.col ? Way::across : Way::within;
}

void list_extra_edges(std::vector<EdgeSum> sums, PixelLevel& coarse) {
  const std::size_t count = sums.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, weight] = sums[i];
    if (coarse.is_extra(a)) {
      sums.push_back({b, a, weight});
    } else {
      sums[i] = {b, a, weight};
    }
  }
  std::stable_sort(sums.begin(), sums.end(), [](const EdgeSum& s, const EdgeSum& t) {
    return std::tie(s.a, s.b) < std::tie(t.a, t.b);
  });
  std::size_t next = 0;
  for (std::size_t i = 0; i < coarse.extras.size(); ++i) {
    const auto node = PixelLevel::Node(coarse.at.size() + i);
    coarse.extras[i].first_edge = int(coarse.edges.size());
    for (; next < sums.size() && sums[next].a == node; ++next) {
      if (int(coarse.edges.size()) > coarse.extras[i].first_edge &&
          coarse.edges.back().to == sums[next].b) {
        coarse.edges.back().weight += sums[next].weight;
      } else {
        coarse.edges.push_back({sums[next].b, sums[next].weight});
      }
    }
  }
}

void add_extra_edges(PixelLevel& coarse) {
  for (auto& extra : coarse.extras) {
    for (float* reach : {&extra.reach_across, &extra.reach_along}) {
      *reach = *reach > 0.0f ? 0.5f / *reach : 0.0f;
    }
  }
  const auto count = [&](std::size_t node, float weight) {
    if (weight == 0.0f) return;
    float& inverse = coarse.inverse[node];
    inverse = inverse > 0.0f ? inverse / (1.0f + weight * inverse) : 1.0f / weight;
    if (node < coarse.even.size()) coarse.even[node] = 0;
  };
  for (std::size_t i = 0; i < coarse.extras.size(); ++i) {
    const auto& extra = coarse.extras[i];
    const auto node = PixelLevel::Node(coarse.at.size() + i);
    for (int e = extra.first_edge; e < coarse.last_edge(i); ++e) {
      auto& edge = coarse.edges[std::size_t(e)];
      const Way way = way_between({extra.row, extra.col}, place_of(coarse, edge.to));
      const bool to_extra = coarse.is_extra(edge.to);
      const auto other = to_extra ? std::size_t(edge.to) - coarse.at.size() : std::size_t(edge.to);
      const float reach_across =
          to_extra ? coarse.extras[other].reach_across : coarse.reach_across[other];
      const float reach_along =
          to_extra ? coarse.extras[other].reach_along : coarse.reach_along[other];
      const float across = extra.reach_across + reach_across;
      const float along = extra.reach_along + reach_along;
      edge.weight /= 1.0f + edge.weight * (way == Way::across  ? across
                                           : way == Way::along ? along
                                                               : std::min(across, along));
      count(std::size_t(node), edge.weight);
      if (!to_extra) count(other, edge.weight);
    }
  }
}

}  // namespace hada
