#include "bench/paper_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <variant>

#include "app/draw/maps.h"
#include "app/draw/spectrum_picture.h"
#include "app/files.h"
#include "app/material_file.h"
#include "fit/classify.h"
#include "io/output.h"
#include "measure/spectrum.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr int side_px = 512;
constexpr double pitch_mm = 0.25;
constexpr double noise_mm = 0.003;
constexpr double spread = 0.08;
constexpr double turn_spread_rad = 0.05;
constexpr int tile_px = 240;
constexpr int gap_px = 8;

void put_tile(Image& page, const Image& tile, int row, int col) {
  for (std::size_t plane = 0; plane < page.planes.size(); ++plane) {
    const auto& from = tile.planes[tile.planes.size() == 1 ? 0 : plane];
    for (int r = 0; r < std::min(tile_px, from.rows()); ++r) {
      for (int c = 0; c < std::min(tile_px, from.cols()); ++c) {
        page.planes[plane](row * (tile_px + gap_px) + r, col * (tile_px + gap_px) + c) = from(r, c);
      }
    }
  }
}

}  // namespace

std::vector<Paper> shipped_papers() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(shipped_recipe("papers"))) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Paper> papers;
  for (const auto& path : paths) {
    papers.push_back({path.stem().string(), std::get<Wrinkle<>>(read_material(path).material)});
  }
  return papers;
}

Surface sheet_of(const Paper& paper, double turn_rad, unsigned seed) {
  Wrinkle<> own = paper.wrinkle;
  for (std::size_t k = 0; k < own.components.size(); ++k) {
    const auto differs = [&](int what) { return gaussian(700 + seed, int(k), what); };
    auto& component = own.components[k];
    component.amplitude_mm *= std::exp(spread * differs(0));
    const double longer = std::exp(spread * differs(1));
    component.long_mm *= longer;
    component.short_mm *= longer;
    component.angle_rad = half_turn(component.angle_rad + turn_rad + turn_spread_rad * differs(2));
  }
  const auto field = synthesize(own, {1536, 1536, 0.5 * pitch_mm, Unit::mm}, seed).height;
  Surface sheet;
  sheet.extent = {side_px, side_px, pitch_mm, Unit::mm};
  sheet.mask = full_mask(sheet.extent);
  sheet.height = Grid<float>(side_px, side_px);
  for (int row = 0; row < side_px; ++row) {
    for (int col = 0; col < side_px; ++col) {
      sheet.height(row, col) =
          field(200 + 2 * row, 300 + 2 * col) + float(noise_mm * gaussian(seed + 1000, row, col));
    }
  }
  return sheet;
}

std::vector<PaperScore> study_papers(int sheets_each) {
  const auto papers = shipped_papers();
  std::vector<Wrinkle<>> kinds;
  for (const Paper& paper : papers) kinds.push_back(paper.wrinkle);
  std::vector<PaperScore> scores;
  for (std::size_t k = 0; k < papers.size(); ++k) {
    PaperScore score{papers[k].name};
    for (int sheet = 0; sheet < sheets_each; ++sheet) {
      const unsigned seed = unsigned(100 * k + std::size_t(sheet));
      const double turn = std::numbers::pi * (uniform(seed, 5) - 0.5);
      const auto found = classify(sheet_of(papers[k], turn, seed), kinds);
      const auto best = std::max_element(found.begin(), found.end(), [](auto& a, auto& b) {
        return a.probability < b.probability;
      });
      score.named_right += (best - found.begin() == std::ptrdiff_t(k) ? 1.0 : 0.0) / sheets_each;
      score.mean_probability += found[k].probability / sheets_each;
    }
    scores.push_back(score);
  }
  return scores;
}

void write_papers_picture(const std::filesystem::path& path) {
  const auto papers = shipped_papers();
  const int cols = int(papers.size());
  Image page(Grid<float>(2 * tile_px + gap_px, cols * (tile_px + gap_px) - gap_px, 1.0f));
  page.planes.resize(3, page.planes[0]);
  std::vector<Surface> sheets;
  for (std::size_t k = 0; k < papers.size(); ++k) {
    sheets.push_back(synthesize(papers[k].wrinkle, {480, 480, pitch_mm, Unit::mm}, 11 + k));
  }
  // The roughest sheet sets the scale of all.
  ReliefStyle relief;
  SpectrumStyle style;
  for (const Surface& sheet : sheets) {
    const auto own = relief_style(sheet);
    if (own.height.high - own.height.low > relief.height.high - relief.height.low ||
        &sheet == &sheets[0]) {
      relief = own;
    }
  }
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    const auto spectrum = power_spectrum(sheets[k].height, sheets[k].mask, sheets[k].extent);
    const auto own = spectrum_style(spectrum);
    if (k == 0) style = own;
    style.highest_frequency = std::max(style.highest_frequency, own.highest_frequency);
  }
  style.highest_frequency = std::min(style.highest_frequency, 0.6);
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    const auto spectrum = power_spectrum(sheets[k].height, sheets[k].mask, sheets[k].extent);
    put_tile(page, shrunk(relief_picture(sheets[k], relief), tile_px), 0, int(k));
    put_tile(page, spectrum_picture(spectrum, style, tile_px), 1, int(k));
  }
  Output output(path.parent_path().empty() ? "." : path.parent_path());
  put_picture(output, path.filename().string(), page);
  output.commit();
}

}  // namespace hada
