#include "app/report/forged_page.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "program.h"

namespace hada {
namespace {

int times(const std::string& text, const std::string& word) {
  int count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(ForgedPage, ShowsPictureSampleSpectraAndSequences) {
  Grid<float> noise(96, 128);
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 128; ++col) noise(row, col) = float(gaussian(9, row, col));
  }
  ForgedFit fit;
  fit.material.sequence = "CRRC";
  fit.posterior = {{{"CRRC", "RCCR"}, 0.625}, {{"CCCC"}, 0.3}, {{"RRRR"}, 0.0001}};
  fit.kinds = {0.3001, 0.0, 0.6999};
  fit.deviance = 1.25;
  fit.remarks = {"A remark & more."};
  fit.spectrum = grain_spectrum(noise);
  expected_cells(grain_model("CRRC", HammerKernel::both, fit.spectrum), {}, fit.spectrum,
                 fit.model);
  Surface surface;
  surface.extent = {96, 128};
  surface.mask = full_mask(surface.extent);
  for (float& value : noise) value = 0.5f + 0.1f * value;
  surface.albedo = Image(noise);
  const std::string page = forged_page("blade.png", surface, fit);
  EXPECT_NE(page.find("The folds of blade.png"), std::string::npos);
  EXPECT_GE(times(page, "data:image/png"), 4);  // picture, sample, two spectra
  EXPECT_NE(page.find("CRRC or RCCR"), std::string::npos);
  EXPECT_NE(page.find("62.5 %"), std::string::npos);
  EXPECT_NE(page.find("all others"), std::string::npos);  // 7.5 % that no row names
  EXPECT_EQ(page.find("RRRR"), std::string::npos);        // too improbable for a row of its own
  EXPECT_NE(page.find("70.0 %"), std::string::npos);      // mokume
  EXPECT_NE(page.find("1.2 times"), std::string::npos);
  EXPECT_NE(page.find("A remark &amp; more."), std::string::npos);
}

TEST(ForgedPage, IsOfForgedSteelAlone) {
  const Answer said = answer("fit wood nothing.png --report page.html");
  EXPECT_EQ(said.code, 2);
  EXPECT_NE(said.err.find("--report"), std::string::npos);
}

}  // namespace
}  // namespace hada
