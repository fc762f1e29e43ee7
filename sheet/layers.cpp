#include "sheet/layers.h"

#include <algorithm>
#include <array>

#include "sheet/layer_solver.h"
#include "sheet/overlaps.h"

namespace hada {
namespace {

// The pairs of faces that overlap, numbered; "a lies above b" as a literal.
class Pairs {
 public:
  explicit Pairs(const Overlaps& overlaps) : faces_(int(overlaps.cells_of.size())) {
    index_.assign(std::size_t(faces_) * std::size_t(faces_), -1);
    for (int a = 0; a < faces_; ++a) {
      for (int b = a + 1; b < faces_; ++b) {
        if (!overlaps.cells_of[std::size_t(a)].meets(overlaps.cells_of[std::size_t(b)])) continue;
        index_[std::size_t(a) * std::size_t(faces_) + std::size_t(b)] = int(pairs_.size());
        pairs_.push_back({a, b});
      }
    }
  }
  Literal above(int a, int b) const {
    const std::size_t low = std::size_t(std::min(a, b)), high = std::size_t(std::max(a, b));
    return 2 * index_[low * std::size_t(faces_) + high] + (a < b ? 0 : 1);
  }
  bool has(int a, int b) const { return above(std::min(a, b), std::max(a, b)) >= 0; }
  int count() const { return int(pairs_.size()); }
  const std::array<int, 2>& operator[](int pair) const { return pairs_[std::size_t(pair)]; }

 private:
  int faces_;
  std::vector<int> index_;
  std::vector<std::array<int, 2>> pairs_;
};

// What meets along a segment: for each edge on it the two faces, folds of either side apart.
struct Meeting {
  std::vector<std::array<int, 2>> folds[2];  // both faces on the left, on the right
  std::vector<std::array<int, 2>> flats;     // left face, right face
  std::vector<int> through;                  // faces that the segment runs through
};

Meeting meeting(const Sheet& sheet, const Overlaps& overlaps, int segment) {
  Meeting meet;
  const auto [left, right] = overlaps.sides_of[std::size_t(segment)];
  const auto covers = [&](int cell, int face) {
    return cell >= 0 && overlaps.faces_of[std::size_t(cell)].has(face);
  };
  for (const int e : overlaps.edges_of[std::size_t(segment)]) {
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (a < 0 || b < 0) continue;
    const bool a_left = covers(left, a), b_left = covers(left, b);
    if (a_left == b_left) {
      meet.folds[a_left ? 0 : 1].push_back({a, b});
    } else {
      meet.flats.push_back(a_left ? std::array{a, b} : std::array{b, a});
    }
  }
  if (left >= 0 && right >= 0) {
    meet.through =
        (overlaps.faces_of[std::size_t(left)] & overlaps.faces_of[std::size_t(right)]).members();
  }
  return meet;
}

// Says what the segments forbid; returns the pair that contradicts itself, or -1.
int add_meetings(const Sheet& sheet, const Overlaps& overlaps, const Pairs& pairs,
                 LayerSolver& solver) {
  int conflict = -1;
  const auto same = [&](int a, int b, int c, int d) {  // a over b as c over d
    if (a == b || c == d || !pairs.has(a, b) || !pairs.has(c, d)) return;
    if (!solver.equal(pairs.above(a, b), pairs.above(c, d)) && conflict < 0) {
      conflict = pairs.above(a, b) / 2;
    }
  };
  for (int s = 0; s < int(overlaps.sides_of.size()); ++s) {
    const Meeting meet = meeting(sheet, overlaps, s);
    for (int side = 0; side < 2; ++side) {
      const auto& folds = meet.folds[side];
      for (std::size_t i = 0; i < folds.size(); ++i) {
        const auto [a, b] = folds[i];
        for (const int c : meet.through) same(a, c, b, c);
        for (const auto& flat : meet.flats) {
          const int c = flat[std::size_t(side)];
          if (c != a && c != b) same(a, c, b, c);
        }
        for (std::size_t j = i + 1; j < folds.size(); ++j) {
          const auto [c, d] = folds[j];
          if (a == c || a == d || b == c || b == d) continue;
          if (!pairs.has(a, c) || !pairs.has(a, d) || !pairs.has(b, c) || !pairs.has(b, d))
            continue;
          solver.even(pairs.above(a, c), pairs.above(a, d), pairs.above(b, c), pairs.above(b, d));
        }
      }
    }
    for (std::size_t i = 0; i < meet.flats.size(); ++i) {
      const auto [a, b] = meet.flats[i];
      for (const int c : meet.through) {
        if (c != a && c != b) same(a, c, b, c);
      }
      for (std::size_t j = i + 1; j < meet.flats.size(); ++j) {
        same(a, meet.flats[j][0], b, meet.flats[j][1]);
      }
    }
  }
  return conflict;
}

// Mountains and valleys say which of their faces is above.
int add_creases(const Sheet& sheet, const FlatState& state, const Pairs& pairs,
                LayerSolver& solver) {
  for (int e = 0; e < sheet.edges(); ++e) {
    const Crease crease = sheet.creases[std::size_t(e)];
    if (crease != Crease::mountain && crease != Crease::valley) continue;
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (!pairs.has(a, b)) continue;
    // A valley lays its other face on the printed side of this one.
    const bool b_above = (crease == Crease::valley) != bool(state.turned[std::size_t(a)]);
    const Literal literal = b_above ? pairs.above(b, a) : pairs.above(a, b);
    if (!solver.fix(literal)) return literal / 2;
  }
  return -1;
}

int add_chosen(const FlatState& state, const std::vector<FaceOrder>& chosen, const Pairs& pairs,
               LayerSolver& solver) {
  for (const FaceOrder& o : chosen) {
    if (o.order == 0 || !pairs.has(o.face, o.other)) continue;
    const bool above = (o.order > 0) != bool(state.turned[std::size_t(o.other)]);
    const Literal literal = above ? pairs.above(o.face, o.other) : pairs.above(o.other, o.face);
    if (!solver.fix(literal)) return literal / 2;
  }
  return -1;
}

void add_circles(const Overlaps& overlaps, const Pairs& pairs, LayerSolver& solver) {
  const int faces = int(overlaps.cells_of.size());
  for (int a = 0; a < faces; ++a) {
    std::vector<int> over;  // the faces after a that overlap it
    for (int b = a + 1; b < faces; ++b) {
      if (pairs.has(a, b)) over.push_back(b);
    }
    for (std::size_t i = 0; i < over.size(); ++i) {
      const int b = over[i];
      const BitSet both = overlaps.cells_of[std::size_t(a)] & overlaps.cells_of[std::size_t(b)];
      for (std::size_t j = i + 1; j < over.size(); ++j) {
        const int c = over[j];
        if (!pairs.has(b, c) || !both.meets(overlaps.cells_of[std::size_t(c)])) continue;
        solver.not_all_equal(pairs.above(a, b), pairs.above(b, c), pairs.above(c, a));
      }
    }
  }
}

std::string blocked(const Pairs& pairs, int pair, const std::string& by) {
  const auto [a, b] = pairs[pair];
  return "faces " + std::to_string(a) + " and " + std::to_string(b) +
         " cannot lie over each other in either order: " + by;
}

}  // namespace

std::string Layers::states() const {
  std::vector<int> digits{1};  // least first
  for (const std::uint64_t states : part_states) {
    // Digits of a product of 64-bit numbers, base 10^9 in two halves would be faster and longer.
    std::vector<int> sum(digits.size() + 20, 0);
    std::uint64_t rest = states;
    for (std::size_t shift = 0; rest > 0; ++shift, rest /= 10) {
      for (std::size_t i = 0; i < digits.size(); ++i) sum[i + shift] += digits[i] * int(rest % 10);
    }
    for (std::size_t i = 0; i + 1 < sum.size(); ++i) {
      sum[i + 1] += sum[i] / 10;
      sum[i] %= 10;
    }
    while (sum.size() > 1 && sum.back() == 0) sum.pop_back();
    digits = std::move(sum);
  }
  std::string text;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) text += char('0' + *digit);
  return possible ? text : "0";
}

Layers layer_orders(const Sheet& sheet, const FlatState& state, const LayerOptions& options) {
  const Overlaps over = overlaps(sheet, state);
  const Pairs pairs(over);
  LayerSolver solver(pairs.count());
  Layers result;
  result.overlapping_pairs = pairs.count();
  if (const int pair = add_meetings(sheet, over, pairs, solver); pair >= 0) {
    result.reason = blocked(pairs, pair, "a fold would have to pass through a layer");
    return result;
  }
  if (const int pair = add_creases(sheet, state, pairs, solver); pair >= 0) {
    result.reason = blocked(pairs, pair, "mountains and valleys contradict each other there");
    return result;
  }
  if (const int pair = add_chosen(state, options.chosen, pairs, solver); pair >= 0) {
    result.reason = blocked(pairs, pair, "the chosen orders contradict each other");
    return result;
  }
  add_circles(over, pairs, solver);
  if (const auto pair = solver.simplify()) {
    result.reason = blocked(pairs, *pair, "either way paper would pass through paper");
    return result;
  }
  const auto parts = solver.parts();
  for (const auto& part : parts) {
    // Parts do not touch: choosing in one leaves the others as they were.
    result.part_states.push_back(options.count ? solver.count(part, options.most) : 1);
    if (result.part_states.back() == 0 || !solver.choose(part)) {
      result.part_states.back() = 0;
      result.reason = blocked(pairs, part[0],
                              "no order of the " + std::to_string(part.size()) +
                                  " open overlaps around them is free of crossings");
      return result;
    }
  }
  result.possible = true;
  for (int pair = 0; pair < pairs.count(); ++pair) {
    const auto [a, b] = pairs[pair];
    const bool above = solver.value(pair) != bool(state.turned[std::size_t(b)]);
    result.order.push_back({a, b, above ? 1 : -1});
  }
  return result;
}

}  // namespace hada
