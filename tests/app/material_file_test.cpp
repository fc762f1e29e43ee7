#include "app/material_file.h"

#include <gtest/gtest.h>

#include "app/parameter_rows.h"
#include "app/part_order.h"
#include "core/error.h"
#include "program.h"

namespace hada {
namespace {

MaterialFile fitted() {
  MaterialFile file;
  file.material = Wrinkle<>{.components = {{0.2, 5.0, 2.0, 0.7}, {0.1, 3.0, 1.0, 2.9}}};
  file.sigma = Wrinkle<>{.components = {{0.01, 0.2, 0.1, 0.02}, {0.0, 0.0, 0.0, 0.0}}};
  file.intervals = {{"components[1].long_mm", 2.0, 7.5}};
  file.goodness_p = 0.4;
  file.starts = 8;
  file.agreeing = 5;
  file.seed = 11;
  file.remarks = {"A remark."};
  file.input = MaterialFile::Input{"sheet", "00ff", {48, 64, 0.2, Unit::mm}};
  return file;
}

TEST(MaterialFile, ReadsWhatItWrote) {
  const TemporaryFolder scratch;
  put(scratch / "m.json", material_text(fitted()));
  const MaterialFile read = read_material(scratch / "m.json");
  EXPECT_EQ(values_of(read.material), values_of(fitted().material));
  EXPECT_EQ(read.seed, Seed(11));
  EXPECT_EQ(read.input->extent, (Extent{48, 64, 0.2, Unit::mm}));
  ASSERT_TRUE(read.sigma);
  EXPECT_EQ(values_of(*read.sigma), values_of(*fitted().sigma));
  EXPECT_EQ(material_text(read), material_text(fitted()));
  ASSERT_EQ(read.intervals.size(), 1u);
  EXPECT_EQ(read.intervals[0].high, 7.5);
  EXPECT_EQ(parameter_rows(read)[5].number, "3 (95 %: 2 to 7.5)");
}

TEST(MaterialFile, NamesWhatComesBackOnlyWhereThereIsSome) {
  MaterialFile file = fitted();
  EXPECT_EQ(material_text(file).find("repeated"), std::string::npos);
  auto& wrinkle = std::get<Wrinkle<>>(file.material);
  wrinkle.repeated = {{0.1, 0.4, 0.2, 0.3, 1.5, 0.9, 2.0}};
  std::get<Wrinkle<>>(*file.sigma).repeated = {{0.01, 0.02, 0.03, 0.0, 0.05, 0.06, 0.07}};
  const MaterialFile read = material_of(material_text(file), "m.json");
  EXPECT_EQ(values_of(read.material), values_of(file.material));
  EXPECT_EQ(values_of(*read.sigma), values_of(*file.sigma));
  EXPECT_EQ(std::get<Wrinkle<>>(read.material).repeated.front().period_mm, 1.5);
  wrinkle.woven = {{.other_period_mm = 2.5}};
  std::get<Wrinkle<>>(*file.sigma).woven = {{}};
  EXPECT_EQ(std::get<Wrinkle<>>(material_of(material_text(file), "m.json").material)
                .woven.front()
                .other_period_mm,
            2.5);
}

TEST(MaterialFile, IsPaintedOnlyWhereAPictureWasFitted) {
  MaterialFile file = fitted();
  EXPECT_EQ(material_text(file).find("mean_albedo"), std::string::npos);
  file.mean_albedo = {0.5, 0.25, 0.125};
  EXPECT_EQ(material_of(material_text(file), "m.json").mean_albedo, file.mean_albedo);
  MaterialFile wood;
  wood.material = Wood<>();
  wood.mean_albedo = {0.5};
  EXPECT_THROW(material_of(material_text(wood), "m.json"), Error);
}

TEST(MaterialFile, TakesNoDamagedRecordOfAFit) {
  const std::string whole = material_text(fitted());
  for (const auto& [part, damaged] : {std::pair{"\"A remark.\"", "7"},
                                      {"\"starts\": 8", "\"starts\": []"},
                                      {"7.5", "1.5"},
                                      {"7.5", "\"far\""}}) {
    std::string text = whole;
    ASSERT_NE(text.find(part), std::string::npos) << part;
    text.replace(text.find(part), std::string(part).size(), damaged);
    EXPECT_THROW(material_of(text, "m.json"), Error) << part;
  }
}

TEST(MaterialFile, NeedsNothingButTheMaterial) {
  const TemporaryFolder scratch;
  put(scratch / "m.json", R"({"hada": "material/1", "material": "wrinkle", "parameters":
    {"components": [{"amplitude_mm": 0.1, "long_mm": 3, "short_mm": 1, "angle_rad": 0.5}],
     "floor_mm4": 0}})");
  EXPECT_EQ(name_of(read_material(scratch / "m.json").material), "wrinkle");
}

TEST(MaterialFile, NamesAnUnknownMaterialAndWhatThereIs) {
  EXPECT_THROW(material_named("straw"), Error);
  EXPECT_NE(material_names().find("wrinkle"), std::string::npos);
}

TEST(MaterialFile, HashChangesWithEveryValue) {
  Grid<float> values(2, 2, 0.0f);
  const std::string before = hash_of(values);
  values(1, 1) = 1e-30f;
  EXPECT_NE(hash_of(values), before);
  // FNV-1a of nothing is its offset basis.
  EXPECT_EQ(hash_of(Grid<float>()), "cbf29ce484222325");
}

}  // namespace
}  // namespace hada
