#include "app/part_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hada {
namespace {

double squared(double x) {
  return x * x;
}

double distance(const WrinkleComponent<>& a, const WrinkleComponent<>& b) {
  return squared(std::log(a.long_mm / b.long_mm)) + squared(std::log(a.short_mm / b.short_mm)) +
         squared(std::log(a.amplitude_mm / b.amplitude_mm));
}

template <class M>
auto& first_list(M& material) {
  return material.*(std::get<0>(std::decay_t<M>::parts()).member);
}

/// Parts whose order is a matter of luck; those of other materials have theirs by meaning.
template <class M>
concept HasShuffledParts = HasParts<M> && requires(const M& material) {
  distance(first_list(material)[0], first_list(material)[0]);
};

std::vector<int> counting(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

}  // namespace

int part_count(const Material& material) {
  return std::visit(
      [](const auto& m) {
        if constexpr (HasParts<std::decay_t<decltype(m)>>) return int(first_list(m).size());
        return 0;
      },
      material);
}

std::vector<int> part_order(const Material& found, const Material& truth) {
  const auto match = [&](const auto& wanted) {
    using M = std::decay_t<decltype(wanted)>;
    if constexpr (HasShuffledParts<M>) {
      const auto& targets = first_list(wanted);
      const auto& parts = first_list(std::get<M>(found));
      auto order = counting(parts.size());
      if (parts.size() < targets.size()) return std::vector<int>{};
      auto best = order;
      double smallest = HUGE_VAL;
      do {
        double sum = 0.0;
        for (std::size_t i = 0; i < targets.size(); ++i) {
          sum += distance(parts[std::size_t(order[i])], targets[i]);
        }
        if (sum < smallest) {
          smallest = sum;
          best = order;
        }
      } while (std::next_permutation(order.begin(), order.end()));
      best.resize(targets.size());
      return best;
    } else if constexpr (HasParts<M>) {
      const auto wished = first_list(wanted).size();
      if (first_list(std::get<M>(found)).size() >= wished) return counting(wished);
    }
    return std::vector<int>{};
  };
  return std::visit(match, truth);
}

Material reordered(const Material& material, const std::vector<int>& order) {
  Material result = material;
  std::visit(
      [&](auto& m) {
        using M = std::decay_t<decltype(m)>;
        if constexpr (HasParts<M>) {
          const auto& parts = first_list(std::get<M>(material));
          first_list(m).clear();
          for (const int part : order) first_list(m).push_back(parts[std::size_t(part)]);
        }
      },
      result);
  return result;
}

std::vector<double> values_of(const Material& material) {
  std::vector<double> values;
  std::visit(
      [&](const auto& m) {
        visit_fields(
            m, [&](const std::string&, const auto&, double value) { values.push_back(value); });
      },
      material);
  return values;
}

}  // namespace hada
