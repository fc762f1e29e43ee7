#include "synth/material.h"

#include <cmath>
#include <numeric>
#include <type_traits>
#include <variant>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "core/parallel.h"
#include "fit/forged.h"
#include "fit/knit.h"
#include "fit/wood.h"
#include "fit/wrinkle.h"
#include "io/json.h"
#include "measure/measured_map.h"
#include "measure/polar.h"
#include "synth/synthesize.h"

/// What every material promises. Each test runs for every type in the variant `Material`.
namespace hada {
namespace {

template <class Variant>
struct TypesOf;
template <class... M>
struct TypesOf<std::variant<M...>> {
  using type = ::testing::Types<M...>;
};

/// A fit by name of the material: one line for each.
auto fitted(const Wrinkle<>& shape, const Surface& surface) {
  return fit_wrinkle(surface, {.components = int(shape.components.size())});
}

auto fitted(const Forged<>&, const Surface& surface) {
  return fit_forged(surface, {.fewest_folds = 4, .most_folds = 8});
}

auto fitted(const Knit<>&, const Surface& surface) {
  return fit_knit(surface);
}

auto fitted(const Wood<>&, const Surface& surface) {
  return fit_wood(surface);
}

const Extent extent{160, 160, 0.2, Unit::mm};

template <class M>
std::vector<double> values_of(const M& material) {
  std::vector<double> values;
  visit_fields(material, [&](const std::string&, const auto&, double v) { values.push_back(v); });
  return values;
}

template <class M>
struct MaterialContract : ::testing::Test {};
TYPED_TEST_SUITE(MaterialContract, TypesOf<Material>::type);

TYPED_TEST(MaterialContract, HasDefaultsInsideItsBounds) {
  const TypeParam material;
  visit_fields(material, [](const std::string& path, const auto& field, double value) {
    EXPECT_GE(value, field.low) << path;
    EXPECT_LE(value, field.high) << path;
    EXPECT_LT(field.low, field.high) << path;
    EXPECT_FALSE(field.meaning.empty()) << path;
  });
}

TYPED_TEST(MaterialContract, ComesBackFromPacking) {
  const TypeParam material;
  const auto packed = pack(material);
  EXPECT_EQ(packed.size(), solver_bounds_of(material).size());
  const auto back = values_of(unpack(material, packed.data()));
  const auto values = values_of(material);
  for (std::size_t k = 0; k < values.size(); ++k) {
    // A logarithm and back; a 0 comes back as 1e-20 of its high bound, 1e3 at most.
    EXPECT_NEAR(back[k], values[k], 1e-12 * std::abs(values[k]) + 1e-17);
  }
}

TYPED_TEST(MaterialContract, ComesBackFromJson) {
  const TypeParam material;
  const Json json = json_of(material);
  const Json read = Json::parse(json.dump());
  EXPECT_EQ(values_of(material_from<TypeParam>(JsonObject(read, "test"))), values_of(material));
}

// Of a spectrum at one frequency.
template <Spectral M>
void expect_right_derivatives(const M& material) {
  using Jet = ceres::Jet<double, 1>;
  const auto packed = pack(material);
  const double fx = 0.021, fy = 0.043;
  const auto at = [&](std::size_t k, double step) {
    auto moved = packed;
    moved[k] += step;
    return psd(unpack(material, moved.data()), fx, fy);
  };
  for (std::size_t k = 0; k < packed.size(); ++k) {
    std::vector<Jet> jets(packed.begin(), packed.end());
    jets[k].v[0] = 1.0;
    const Jet value = psd(unpack(material, jets.data()), fx, fy);
    EXPECT_NEAR(value.a, at(k, 0.0), 1e-14 * std::abs(value.a));
    // A central difference errs by h^2 / 6 of the third derivative and by rounding / h.
    const double h = 1e-4;
    EXPECT_NEAR(value.v[0], (at(k, h) - at(k, -h)) / (2.0 * h), 1e-6 * std::abs(value.a));
  }
}

TYPED_TEST(MaterialContract, HasTheSameValueOverJetsAndTheRightDerivatives) {
  static_assert(Spectral<TypeParam> || Grown<TypeParam>);
  if constexpr (Spectral<TypeParam>) expect_right_derivatives(TypeParam{});
}

TYPED_TEST(MaterialContract, IsSynthesisedToTheSameBytesAtAnyThreadCount) {
  set_threads(1);
  const auto alone = synthesize(TypeParam{}, extent, 5);
  set_threads(3);
  const auto shared = synthesize(TypeParam{}, extent, 5);
  set_threads(0);
  EXPECT_EQ(alone.height, shared.height);
  EXPECT_EQ(alone.albedo, shared.albedo);
}

TYPED_TEST(MaterialContract, IsRecoveredFromItsSurface) {
  const TypeParam material;
  const auto fit = fitted(material, synthesize(material, extent, 6));
  const auto expected = values_of(material), sigma = values_of(fit.sigma);
  std::size_t k = 0;
  visit_fields(fit.material, [&](const std::string& path, const auto& field, double value) {
    const double half = 0.5 * std::numbers::pi;
    const double error = field.scale == Scale::half_turn
                             ? half_turn(value - expected[k] + half) - half
                             : value - expected[k];
    // A noise-free map still holds the rounding of floats, which the smallest fields may take in.
    EXPECT_LE(std::abs(error), 5.0 * sigma[k] + 1e-8) << path;
    ++k;
  });
}

TYPED_TEST(MaterialContract, LooksTheSameToMeasureAfterAFit) {
  const TypeParam material;
  const auto original = synthesize(material, extent, 7);
  const auto again = synthesize(fitted(material, original).material, extent, 8);
  const auto before = rings(power_spectrum(measured_map(original), original.mask, extent), 16);
  const auto after = rings(power_spectrum(measured_map(again), again.mask, extent), 16);
  // Steel is stretched between its lowest and highest place, whose luck is in its size and in the
  // error of its levels: there the shape is compared, where it is stronger than that error.
  const bool steel = std::is_same_v<TypeParam, Forged<>>;
  const auto total = [](const Rings& rings) {
    return std::accumulate(rings.power.begin(), rings.power.end(), 0.0);
  };
  const double size = steel ? total(before) / total(after) : 1.0;
  const double faintest = steel ? 0.03 : 1e-3;
  for (std::size_t k = 0; k < before.density.size(); ++k) {
    // Rings that hold a thousandth of the power or more; each side scatters by its sigma, and the
    // fit by less than one of them.
    if (before.power[k] < faintest * before.power[0]) continue;
    const double sigma = std::hypot(before.sigma[k], size * after.sigma[k]);
    EXPECT_NEAR(size * after.density[k], before.density[k], 5.0 * sigma) << k;
  }
}

}  // namespace
}  // namespace hada
