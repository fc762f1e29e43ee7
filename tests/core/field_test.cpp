#include "core/field.h"

#include <array>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

template <class T = double>
struct Wave {
  T length_mm{2.0};
  T angle_rad{0.0};
  static constexpr auto fields() {
    return std::array{
        Field<Wave, T>{"length_mm", &Wave::length_mm, 0.5, 50.0, Scale::log, "mm",
                       "crest to crest"},
        Field<Wave, T>{"angle_rad", &Wave::angle_rad, 0.0, pi, Scale::half_turn, "rad",
                       "of crests"},
    };
  }
};

template <class T = double>
struct Sea {
  static constexpr std::string_view name = "sea";
  std::vector<Wave<T>> waves;
  T level_mm{0.0};
  T floor{0.0};
  std::vector<T> depths_mm{};
  std::string tide{"ebb"};
  static constexpr auto lists() {
    return std::tuple{NumberList<Sea, T>{"depths_mm", &Sea::depths_mm, 0, 3, 0.1, 9.0, Scale::log,
                                         "mm", "of the ground"}};
  }
  static constexpr auto words() {
    return std::array{Word<Sea>{"tide", &Sea::tide,
                                [](std::string_view text) { return !text.empty(); }, "a word",
                                "where the water goes"}};
  }
  static constexpr auto parts() {
    return std::tuple{PartList<Sea, Wave<T>>{"waves", &Sea::waves, 0, 4}};
  }
  static constexpr auto fields() {
    return std::array{
        Field<Sea, T>{"level_mm", &Sea::level_mm, -1.0, 1.0, Scale::linear, "mm", "mean height"},
        Field<Sea, T>{"floor", &Sea::floor, 0.0, 2.0, Scale::log, "", "least power"},
    };
  }
};

Sea<> some_sea(Seed seed) {
  Sea<> sea;
  const int count = int(5 * uniform(seed, 0));
  for (int i = 0; i < count; ++i) {
    sea.waves.push_back({0.5 + 49.5 * uniform(seed, i, 1), pi * uniform(seed, i, 2)});
  }
  sea.level_mm = 2.0 * uniform(seed, 1) - 1.0;
  sea.floor = 2.0 * uniform(seed, 2);
  for (int i = 0; i < count % 4; ++i) sea.depths_mm.push_back(0.1 + 8.9 * uniform(seed, i, 3));
  sea.tide = count % 2 ? "flood" : "slack";
  return sea;
}

TEST(VisitFields, NamesEveryNumberPartsThenListsThenFields) {
  const Sea<> sea{{{1.0, 0.1}, {2.0, 0.2}}, 0.5, 0.25, {3.0, 4.0}};
  std::vector<std::string> paths;
  std::vector<double> values;
  visit_fields(sea, [&](const std::string& path, const auto&, const double& value) {
    paths.push_back(path);
    values.push_back(value);
  });
  EXPECT_EQ(paths, (std::vector<std::string>{"waves[0].length_mm", "waves[0].angle_rad",
                                             "waves[1].length_mm", "waves[1].angle_rad",
                                             "depths_mm[0]", "depths_mm[1]", "level_mm", "floor"}));
  EXPECT_EQ(values, (std::vector<double>{1.0, 0.1, 2.0, 0.2, 3.0, 4.0, 0.5, 0.25}));
}

TEST(VisitWords, NamesEveryWord) {
  Sea<> sea;
  visit_words(sea, [](const auto& word, std::string& text) {
    EXPECT_EQ(word.name, "tide");
    EXPECT_EQ(text, "ebb");
    text = "flood";
  });
  EXPECT_EQ(sea.tide, "flood");
}

RC_GTEST_PROP(Pack, IsUndoneByUnpack, (std::uint64_t seed)) {
  const Sea<> sea = some_sea(seed);
  const auto packed = pack(sea);
  const Sea<> again = unpack<double>(sea, packed.data());
  RC_ASSERT(again.waves.size() == sea.waves.size());
  // exp(log x) of x within e^(+-4) loses at most 4 + 1 roundings of 2^-53.
  const auto close = [](double a, double b) { return std::abs(a - b) <= 1e-15 * (1.0 + 50.0); };
  for (std::size_t i = 0; i < sea.waves.size(); ++i) {
    RC_ASSERT(close(again.waves[i].length_mm, sea.waves[i].length_mm));
    RC_ASSERT(again.waves[i].angle_rad == sea.waves[i].angle_rad);
  }
  RC_ASSERT(again.depths_mm.size() == sea.depths_mm.size());
  for (std::size_t i = 0; i < sea.depths_mm.size(); ++i) {
    RC_ASSERT(close(again.depths_mm[i], sea.depths_mm[i]));
  }
  RC_ASSERT(again.tide == sea.tide);
  RC_ASSERT(again.level_mm == sea.level_mm);
  RC_ASSERT(close(again.floor, sea.floor));
}

RC_GTEST_PROP(Pack, LiesWithinTheBoundsOfTheSolver, (std::uint64_t seed)) {
  const Sea<> sea = some_sea(seed);
  const auto packed = pack(sea);
  const auto bounds = solver_bounds_of(sea);
  RC_ASSERT(bounds.size() == packed.size());
  for (std::size_t i = 0; i < packed.size(); ++i) {
    RC_ASSERT(bounds[i].low <= packed[i]);
    RC_ASSERT(packed[i] <= bounds[i].high);
  }
}

TEST(Pack, GivesZeroOnALogScaleAFinitePlace) {
  const auto packed = pack(Sea<>{});
  EXPECT_NEAR(packed.back(), std::log(2e-20), 1e-12);
}

TEST(HalfTurn, WrapsEveryAngleIntoItsRange) {
  EXPECT_EQ(half_turn(0.0), 0.0);
  EXPECT_EQ(half_turn(1.0), 1.0);
  EXPECT_EQ(half_turn(pi), 0.0);
  EXPECT_NEAR(half_turn(-0.25), pi - 0.25, 1e-15);
  EXPECT_NEAR(half_turn(7.0 * pi + 0.5), 0.5, 1e-14);
  EXPECT_LT(half_turn(-1e-300), pi);  // adding pi must not round to pi itself
}

TEST(Wrapped, TurnsOnlyDirections) {
  const Sea<> sea = wrapped(Sea<>{{{4.0, -0.5}}, -0.75, 1.5});
  EXPECT_NEAR(sea.waves[0].angle_rad, pi - 0.5, 1e-15);
  EXPECT_EQ(sea.waves[0].length_mm, 4.0);
  EXPECT_EQ(sea.level_mm, -0.75);
}

}  // namespace
}  // namespace hada
