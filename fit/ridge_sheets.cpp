#include "fit/ridge_sheets.h"

#include "core/parallel.h"
#include "synth/gaussian_field.h"
#include "synth/ridges.h"

namespace hada {
namespace {

constexpr Seed first_seed = 0x7269646765;

}  // namespace

Wrinkle<> with(Wrinkle<> wrinkle, const Ridges& ridges) {
  wrinkle.skew = ridges[0];
  wrinkle.tail = ridges[1];
  wrinkle.sharpness = ridges[2];
  return wrinkle;
}

RidgeSheets::RidgeSheets(const Wrinkle<>& wrinkle, const Extent& extent, int smoothings, int kept)
    : wrinkle_(wrinkle), extent_(extent), smoothings_(smoothings) {
  const auto count = std::size_t(kept);
  std::vector<Grid<float>> fields(count), floors(count);
  for_each_index(kept, [&](int k) {
    fields[std::size_t(k)] = field(k);
    floors[std::size_t(k)] = floor(k);
  });
  fields_ = std::move(fields);
  floors_ = std::move(floors);
}

Grid<float> RidgeSheets::field(int sheet) const {
  if (sheet < kept()) return fields_[std::size_t(sheet)];
  Wrinkle<> bare = with(wrinkle_, Ridges::Zero());
  bare.floor_mm4 = 0.0;
  return gaussian_field(spectrum_of(bare), extent_, first_seed + Seed(sheet));
}

Grid<float> RidgeSheets::floor(int sheet) const {
  if (sheet < kept()) return floors_[std::size_t(sheet)];
  if (wrinkle_.floor_mm4 == 0.0) return {};
  return gaussian_field([&](double, double) { return wrinkle_.floor_mm4; }, extent_,
                        mixed(first_seed, std::int64_t(sheet)));
}

RidgeValues RidgeSheets::values(int sheet, const Ridges& ridges) const {
  const auto made = with(wrinkle_, ridges);
  Grid<float> map = field(sheet);
  if (has_ridges(made)) map = with_ridges(map, made, extent_.pitch);
  const auto noise = floor(sheet);
  for (std::size_t at = 0; at < noise.size(); ++at) map[at] += noise[at];
  return ridge_values(map, full_mask(extent_), smoothings_);
}

RidgeSheets::Columns RidgeSheets::moments(int first, int count, const Ridges& ridges) const {
  Columns columns(ridge_moments, count);
  for_each_index(count, [&](int k) { columns.col(k) = moments_of(values(first + k, ridges)); });
  return columns;
}

RidgeMoments RidgeSheets::mean(const Ridges& ridges) const {
  return moments(0, kept(), ridges).rowwise().mean();
}

}  // namespace hada
