#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/extent.h"
#include "core/surface.h"
#include "measure/roughness.h"
#include "synth/gaussian_field.h"
#include "synth/wrinkle.h"

#ifdef HADA_HAS_GWYDDION
#include <libprocess/gwyprocess.h>
#endif

/// The same numbers as Gwyddion's, the reference among open tools for height fields.
namespace hada {
namespace {

#ifdef HADA_HAS_GWYDDION

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
using Field = std::unique_ptr<GwyDataField, Unref>;

const Extent extent{.rows = 200, .cols = 256, .pitch = 0.1, .unit = Unit::mm};

Grid<float> map() {
  const WrinkleComponent<> component{
      .amplitude_mm = 0.2, .long_mm = 0.8, .short_mm = 0.4, .angle_rad = 0.6};
  return gaussian_field([&](double fx, double fy) { return psd(component, fx, fy); }, extent, 5);
}

Field field_of(const Grid<float>& height) {
  Field field(gwy_data_field_new(height.cols(), height.rows(), extent.width(), extent.height(), 0));
  std::copy(height.begin(), height.end(), gwy_data_field_get_data(field.get()));
  return field;
}

// Gwyddion's autocorrelation where ours looks for lengths: along a direction, bilinear.
double length_in(const Field& acf, double right, double down) {
  const double* values = gwy_data_field_get_data_const(acf.get());
  const int cols = gwy_data_field_get_xres(acf.get()), rows = gwy_data_field_get_yres(acf.get());
  const auto at = [&](int row, int col) {
    return values[(rows / 2 + row) * cols + cols / 2 + col] / values[rows / 2 * cols + cols / 2];
  };
  double last = 1.0;
  for (double lag = 0.25;; lag += 0.25) {
    const int row = int(std::floor(lag * down)), col = int(std::floor(lag * right));
    const double v = lag * down - row, u = lag * right - col;
    const double value = (1 - v) * ((1 - u) * at(row, col) + u * at(row, col + 1)) +
                         v * ((1 - u) * at(row + 1, col) + u * at(row + 1, col + 1));
    if (value < 0.2) return lag - 0.25 * (0.2 - value) / (last - value);
    last = value;
  }
}

TEST(Roughness, AgreesWithGwyddion) {
  gwy_process_type_init();
  const auto height = map();
  const auto field = field_of(height);
  const Roughness found = roughness(height, full_mask(extent), extent.pitch);
  double mean, sa, sq, ssk, sku;
  gwy_data_field_get_stats(field.get(), &mean, &sa, &sq, &ssk, &sku);
  // Both are sums of doubles over the same floats.
  EXPECT_NEAR(found.Sa, sa, 1e-9);
  EXPECT_NEAR(found.Sq, sq, 1e-9);
  EXPECT_NEAR(found.Ssk, ssk, 1e-7);
  EXPECT_NEAR(found.Sku - 3.0, sku, 1e-7);  // theirs is the excess

  gwy_data_field_add(field.get(), -mean);
  const Field acf(gwy_data_field_new(2, 2, 1.0, 1.0, 0));
  gwy_data_field_2dacf(field.get(), acf.get());
  double shortest = HUGE_VAL, longest = 0.0;
  for (int i = 0; i < 180; ++i) {
    const double angle = i * std::acos(-1.0) / 180.0;
    const double length = length_in(acf, std::cos(angle), -std::sin(angle));
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  // The two differ in how pairs at the border are counted, by lag / side of a tenth, and transform
  // in floats against doubles.
  EXPECT_NEAR(found.Sal, shortest * extent.pitch, 0.01 * found.Sal);
  EXPECT_NEAR(found.Str, shortest / longest, 0.01 * found.Str);
}

#else

TEST(Roughness, AgreesWithGwyddion) {
  GTEST_SKIP() << "Gwyddion's library (libgwyddion20-dev) is not here to be compared with";
}

#endif

}  // namespace
}  // namespace hada
