#include <filesystem>

#include <gtest/gtest.h>

#include "app/fold_log_file.h"
#include "bench/accuracy.h"
#include "bench/fold_study.h"
#include "bench/rendered_creases.h"
#include "io/fold_file.h"
#include "sheet/fold_log.h"
#include "sheet/places.h"

namespace hada {
namespace {

TEST(CreasePatterns, FoldAsOthersFoldThem) {
  if (!std::filesystem::exists(data_folder() / "fold")) {
    GTEST_SKIP() << "the crease patterns are not in " << data_folder();
  }
  for (const auto& score : score_patterns(data_folder(), 1)) {
    EXPECT_EQ(score.states, score.states_published) << score.name;
    // Both sides agree among themselves to 5e-11; a hundredfold of that for chains of faces.
    EXPECT_LT(score.geometry_error, 1e-9) << score.name;
  }
}

TEST(CreasePatterns, ThatDoNotFoldAreRejectedWithAReason) {
  if (!std::filesystem::exists(data_folder() / "fold")) {
    GTEST_SKIP() << "the crease patterns are not in " << data_folder();
  }
  for (const auto& rejection : score_unfoldable(data_folder())) {
    EXPECT_FALSE(rejection.reason.empty()) << rejection.name;
  }
}

// The recorded snail ends where Furuta's published one lies: all distances between its corners.
TEST(RecordedSnail, EndsInThePublishedShape) {
  const auto folder = data_folder() / "fold";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "the crease patterns are not in " << data_folder();
  }
  const std::string name = "042_furutaoripa_katatsumuri_(snail)";
  const auto pattern = read_fold(folder / "crease_patterns" / (name + ".fold")).frames[0];
  const auto shape = read_fold(folder / "folded_states" / (name + ".folded.fold")).frames[0];
  const std::filesystem::path source = HADA_SOURCE_DIR;
  const auto states = replayed(read_fold_log(source / "data_synthetic" / "folds" / "snail.json"));
  const Sheet& sheet = states.back().sheet;
  std::vector<Eigen::Vector3d> mine;
  for (const auto& p : pattern.vertices) {
    const Eigen::Vector2d flat = p.head<2>();
    mine.push_back(folded_place(sheet, face_at(sheet, flat), flat));
  }
  ASSERT_EQ(mine.size(), shape.vertices.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      // The lines of the log are written to 12 digits and found through 30 folds.
      EXPECT_NEAR((mine[i] - mine[j]).norm(), (shape.vertices[i] - shape.vertices[j]).norm(), 1e-9);
    }
  }
}

TEST(RenderedSheet, ShowsItsCreasesInItsPictures) {
  const auto scene = data_folder() / "rendered" / "paper_creased";
  if (!std::filesystem::exists(scene)) GTEST_SKIP() << "the scene is not in " << scene;
  const RenderedCreases found = rendered_creases(scene);
  EXPECT_EQ(found.found, found.creases);
  EXPECT_LT(found.worst_deg, 0.03);  // twice what was reached
  EXPECT_LT(found.worst_line_px, 0.5);
  EXPECT_LT(found.worst_sigmas, 4.0);
}

}  // namespace
}  // namespace hada
