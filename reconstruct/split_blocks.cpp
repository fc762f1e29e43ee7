#include "reconstruct/split_blocks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "reconstruct/extra_edges.h"

namespace hada {
namespace {

using Node = PixelLevel::Node;

class Splitter {
 public:
  Splitter(PixelLevel& fine, std::vector<std::vector<int>> split_cols, float least,
           PixelLevel& coarse)
      : fine_(fine), coarse_(coarse), least_(least) {
    for (const auto& extra : fine.extras) {
      split_cols[std::size_t(extra.row / 2)].push_back(extra.col / 2);
    }
    for (int row = 0; row < coarse.at.rows; ++row) {
      auto& cols = split_cols[std::size_t(row)];
      std::sort(cols.begin(), cols.end());
      cols.erase(std::unique(cols.begin(), cols.end()), cols.end());
      for (const int col : cols) blocks_.push_back({row, col});
    }
  }

  void run() {
    if (blocks_.empty()) return;
    index_ = Grid<int>(coarse_.at.rows, coarse_.at.cols, -1, coarse_.memory());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      index_(blocks_[i].row, blocks_[i].col) = int(i);
    }
    parents_.assign(blocks_.size(), {});
    for (std::size_t i = 0; i < blocks_.size(); ++i) find_parts(int(i));
    for (const Place& block : blocks_) forget_crossings(block);
    for (const Place& block : blocks_) add_crossings(block);
    list_extra_edges(std::move(sums_), coarse_);
  }

 private:
  struct Member {
    Node node;
    Place place;
    int part;    // while parts are joined: a member that it hangs together with
    float held;  // sum of all its edges
  };
  struct Link {
    int a, b;  // members
    float weight;
  };

  float held(Node node) const {
    if (fine_.unit()) return float(fine_.code[std::size_t(node)] & 15);
    const float inverse = fine_.inverse[std::size_t(node)];
    return inverse > 0.0f ? 1.0f / inverse : 0.0f;
  }
  float east(int row, int col) const {
    if (col < 0 || col + 1 >= fine_.at.cols || row >= fine_.at.rows) return 0.0f;
    const auto cell = std::size_t(fine_.at.cell(row, col));
    if (!fine_.unit()) return fine_.east[cell];
    return fine_.code[cell] && fine_.code[std::size_t(fine_.at.cell(row, col + 1))] ? 1.0f : 0.0f;
  }
  float south(int row, int col) const {
    if (row < 0 || row + 1 >= fine_.at.rows || col >= fine_.at.cols) return 0.0f;
    const auto cell = std::size_t(fine_.at.cell(row, col));
    if (!fine_.unit()) return fine_.south[cell];
    return fine_.code[cell] && fine_.code[std::size_t(fine_.at.cell(row + 1, col))] ? 1.0f : 0.0f;
  }

  void find_members(const Place& block) {
    members_.clear();
    const auto add = [&](Node node, int row, int col) {
      const float sum = held(node);
      if (sum > 0.0f) members_.push_back({node, {row, col}, int(members_.size()), sum});
    };
    for (int row = 2 * block.row; row < std::min(2 * block.row + 2, fine_.at.rows); ++row) {
      for (int col = 2 * block.col; col < std::min(2 * block.col + 2, fine_.at.cols); ++col) {
        add(Node(fine_.at.cell(row, col)), row, col);
        auto extra = std::lower_bound(
            fine_.extras.begin(), fine_.extras.end(), std::pair(row, col),
            [](const auto& e, const auto& at) { return std::pair(e.row, e.col) < at; });
        for (; extra != fine_.extras.end() && extra->row == row && extra->col == col; ++extra) {
          add(Node(fine_.at.size()) + Node(extra - fine_.extras.begin()), row, col);
        }
      }
    }
  }

  int member(Node node) const {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (members_[i].node == node) return int(i);
    }
    return -1;
  }

  void find_links(const Place& block) {
    links_.clear();
    const auto add = [&](Node from, Node to, float weight) {
      const int a = member(from);
      const int b = member(to);
      if (a >= 0 && b >= 0 && weight > 0.0f) links_.push_back({a, b, weight});
    };
    const int row = 2 * block.row;
    const int col = 2 * block.col;
    const auto cell = [&](int r, int c) { return Node(fine_.at.cell(r, c)); };
    add(cell(row, col), cell(row, col + 1), east(row, col));
    add(cell(row + 1, col), cell(row + 1, col + 1), east(row + 1, col));
    add(cell(row, col), cell(row + 1, col), south(row, col));
    add(cell(row, col + 1), cell(row + 1, col + 1), south(row, col + 1));
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const Node node = members_[i].node;
      if (!fine_.is_extra(node)) continue;
      const std::size_t extra = std::size_t(node) - fine_.at.size();
      for (int e = fine_.extras[extra].first_edge; e < fine_.last_edge(extra); ++e) {
        const auto& edge = fine_.edges[std::size_t(e)];
        if (!fine_.is_extra(edge.to) || node < edge.to) add(node, edge.to, edge.weight);
      }
    }
  }

  int part_of(int member) const {
    while (members_[std::size_t(member)].part != member) {
      member = members_[std::size_t(member)].part;
    }
    return member;
  }

  void find_parts(int index) {
    const Place block = blocks_[std::size_t(index)];
    find_members(block);
    find_links(block);
    for (const Link& link : links_) {
      const auto& a = members_[std::size_t(link.a)];
      const auto& b = members_[std::size_t(link.b)];
      if (link.weight < least_ * std::max(a.held, b.held)) continue;
      const auto [low, high] = std::minmax({part_of(link.a), part_of(link.b)});
      members_[std::size_t(high)].part = low;
    }
    // The part that is held most becomes the cell.
    std::vector<float> size(members_.size(), 0.0f);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      members_[i].part = part_of(int(i));
      size[std::size_t(members_[i].part)] += members_[i].held;
    }
    const int largest = int(std::max_element(size.begin(), size.end()) - size.begin());
    const auto cell = std::size_t(coarse_.at.cell(block.row, block.col));
    coarse_.reach_across[cell] = coarse_.reach_along[cell] = 0.0f;
    std::vector<Node> node(members_.size(), Node(cell));
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const int part = members_[i].part;
      if (part == largest) continue;
      if (part == int(i)) {
        node[i] = Node(coarse_.nodes());
        coarse_.extras.push_back({block.row, block.col, 0.0f, 0.0f, 0});
      } else {
        node[i] = node[std::size_t(part)];
      }
    }
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const Member& m = members_[i];
      if (fine_.is_extra(m.node)) {
        fine_.extras[std::size_t(m.node) - fine_.at.size()].parent = node[i];
        continue;
      }
      parents_[std::size_t(index)][std::size_t(2 * (m.place.row % 2) + m.place.col % 2)] = node[i];
      if (node[i] != Node(cell)) fine_.moved.push_back({m.place.row, m.node, node[i]});
    }
    for (const Link& link : links_) {
      const Node a = node[std::size_t(link.a)];
      const Node b = node[std::size_t(link.b)];
      if (a != b) {
        sums_.push_back({std::min(a, b), std::max(a, b), link.weight});
        continue;
      }
      const Way way =
          way_between(members_[std::size_t(link.a)].place, members_[std::size_t(link.b)].place);
      if (way != Way::along) across_of(a) += link.weight;
      if (way != Way::across) along_of(a) += link.weight;
    }
  }

  float& across_of(Node node) {
    return coarse_.is_extra(node)
               ? coarse_.extras[std::size_t(node) - coarse_.at.size()].reach_across
               : coarse_.reach_across[std::size_t(node)];
  }
  float& along_of(Node node) {
    return coarse_.is_extra(node)
               ? coarse_.extras[std::size_t(node) - coarse_.at.size()].reach_along
               : coarse_.reach_along[std::size_t(node)];
  }

  void forget_crossings(const Place& block) {
    const auto [row, col] = block;
    const auto cell = [&](int r, int c) { return std::size_t(coarse_.at.cell(r, c)); };
    coarse_.east[cell(row, col)] = coarse_.south[cell(row, col)] = 0.0f;
    if (col > 0) coarse_.east[cell(row, col - 1)] = 0.0f;
    if (row > 0) coarse_.south[cell(row - 1, col)] = 0.0f;
  }

  bool is_split(int row, int col) const {
    return index_.contains(row, col) && index_(row, col) >= 0;
  }

  Node parent(int row, int col) const {
    const int index = index_(row / 2, col / 2);
    if (index < 0) return Node(coarse_.at.cell(row / 2, col / 2));
    return parents_[std::size_t(index)][std::size_t(2 * (row % 2) + col % 2)];
  }
  Node parent(Node node, const Place& place) const {
    if (fine_.is_extra(node)) return fine_.extras[std::size_t(node) - fine_.at.size()].parent;
    return parent(place.row, place.col);
  }

  // An edge between two blocks, by the nodes that its ends went to and the places of those.
  void add_crossing(Node a, Node b, const Place& at_a, const Place& at_b, float weight) {
    if (coarse_.is_extra(a) || coarse_.is_extra(b)) {
      sums_.push_back({std::min(a, b), std::max(a, b), weight});
      return;
    }
    const Place first{std::min(at_a.row, at_b.row) / 2, std::min(at_a.col, at_b.col) / 2};
    auto& sums = at_a.row / 2 != at_b.row / 2 ? coarse_.south : coarse_.east;
    sums[std::size_t(coarse_.at.cell(first.row, first.col))] += weight;
  }

  void add_crossings(const Place& block) {
    const int top = 2 * block.row;
    const int left = 2 * block.col;
    const auto add = [&](float weight, const Place& a, const Place& b) {
      if (weight > 0.0f) add_crossing(parent(a.row, a.col), parent(b.row, b.col), a, b, weight);
    };
    for (int row = top; row < std::min(top + 2, fine_.at.rows); ++row) {
      add(east(row, left + 1), {row, left + 1}, {row, left + 2});
      if (left > 0 && !is_split(block.row, block.col - 1)) {
        add(east(row, left - 1), {row, left - 1}, {row, left});
      }
    }
    for (int col = left; col < std::min(left + 2, fine_.at.cols); ++col) {
      add(south(top + 1, col), {top + 1, col}, {top + 2, col});
      if (top > 0 && !is_split(block.row - 1, block.col)) {
        add(south(top - 1, col), {top - 1, col}, {top, col});
      }
    }
    find_members(block);
    for (const Member& m : members_) {
      if (!fine_.is_extra(m.node)) continue;
      const std::size_t extra = std::size_t(m.node) - fine_.at.size();
      for (int e = fine_.extras[extra].first_edge; e < fine_.last_edge(extra); ++e) {
        const auto& edge = fine_.edges[std::size_t(e)];
        if (fine_.is_extra(edge.to) && edge.to < m.node) continue;
        const Place to = place_of(fine_, edge.to);
        if (to.row / 2 == block.row && to.col / 2 == block.col) continue;  // a link of `find_parts`
        add_crossing(fine_.extras[extra].parent, parent(edge.to, to), m.place, to, edge.weight);
      }
    }
  }

  PixelLevel& fine_;
  PixelLevel& coarse_;
  float least_;
  std::vector<Place> blocks_;
  Grid<int> index_;  // of a block in blocks_, -1 if it hangs together
  std::vector<std::array<Node, 4>> parents_;
  std::vector<EdgeSum> sums_;
  std::vector<Member> members_;
  std::vector<Link> links_;
};

}  // namespace

void split_blocks(PixelLevel& fine, std::vector<std::vector<int>> split_cols, float least,
                  PixelLevel& coarse) {
  Splitter(fine, std::move(split_cols), least, coarse).run();
  std::sort(fine.moved.begin(), fine.moved.end(),
            [](const auto& a, const auto& b) { return a.cell < b.cell; });
}

}  // namespace hada
