#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/material_file.h"
#include "io/json.h"
#include "studio/surface_bytes.h"
#include "synth/synthesize.h"
#include "tests/app/program.h"
#include "tests/studio/client.h"

namespace hada {
namespace {

using testing::HasSubstr;

class MaterialRequests : public testing::Test {
 protected:
  Json tables() { return Json::parse(body_of(get(studio_, "api/material/tables")))["materials"]; }
  static Json wanted(const Json& table, int size) {
    return {
        {"file",
         {{"hada", "material/1"}, {"material", table["name"]}, {"parameters", table["defaults"]}}},
        {"size_px", size},
        {"pitch", 0.1},
        {"seed", 1}};
  }
  RunningStudio studio_{HADA_SOURCE_DIR};
};

TEST_F(MaterialRequests, MakeEveryMaterialFromItsTable) {
  for (const Json& table : tables()) {
    const std::string answer = post(studio_, "api/material/preview", wanted(table, 64).dump());
    ASSERT_EQ(status_of(answer), 200) << table["name"] << answer;
    EXPECT_THAT(body_of(answer).substr(0, 4), "HADA");
    const Json file = {{"file", wanted(table, 64)["file"]}};
    const Json saved = Json::parse(body_of(post(studio_, "api/material/file", file.dump())));
    const MaterialFile read = material_of(saved["text"].get<std::string>(), "saved");
    EXPECT_EQ(name_of(read.material), table["name"].get<std::string>());
  }
}

TEST_F(MaterialRequests, KeepToTheBounds) {
  const Json table = tables()[0];
  Json request = wanted(table, 64);
  request["size_px"] = 100000;
  EXPECT_THAT(post(studio_, "api/material/preview", request.dump()), HasSubstr("size_px"));
  request = wanted(table, 64);
  request["pitch"] = -1;
  EXPECT_THAT(post(studio_, "api/material/preview", request.dump()), HasSubstr("pitch"));
  request = wanted(table, 64);
  request["file"]["parameters"]["floor_mm4"] = 1e9;
  EXPECT_THAT(post(studio_, "api/material/preview", request.dump()), HasSubstr("must lie between"));
  request["file"] = "text";
  EXPECT_EQ(status_of(post(studio_, "api/material/preview", request.dump())), 422);
}

TEST_F(MaterialRequests, PaintWhatWasFittedToAPicture) {
  Json request = wanted(tables()[0], 64);
  const std::string raised = body_of(post(studio_, "api/material/preview", request.dump()));
  request["file"]["mean_albedo"] = {0.5, 0.4, 0.3};
  const std::string painted = body_of(post(studio_, "api/material/preview", request.dump()));
  // Of the flags in the head: 1 normals, 2 albedo, 4 height.
  EXPECT_EQ(raised[12] & 7, 7);
  EXPECT_EQ(painted[12] & 7, 2);
  request["map"] = "height";
  EXPECT_THAT(post(studio_, "api/material/map", request.dump()), HasSubstr("albedo alone"));
}

TEST_F(MaterialRequests, AnswerWhileASliderMoves) {
  for (const Json& table : tables()) {
    Json request = wanted(table, 512);
    double best = 1e9;
    for (int i = 0; i < 4; ++i) {
      // Every answer is a new one: the slider of the last field has moved.
      auto& value = request["file"]["parameters"][table["fields"].back()["name"]];
      value = (value.is_null() ? 0.0 : value.get<double>()) + 1e-4;  // what is left out is 0
      const std::string text = post_text(studio_, "api/material/preview", request.dump());
      const auto start = std::chrono::steady_clock::now();
      EXPECT_EQ(status_of(answer_to(studio_, text)), 200);
      best = std::min(
          best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                    .count());
    }
    std::printf("%s 512 x 512: %.0f ms\n", table["name"].get<std::string>().c_str(), best);
  }
}

TEST_F(MaterialRequests, EtchTheSameSteelAsTheCommandLine) {
  Forged<> steel;
  const Extent extent{32, 32, 0.1, Unit::mm};
  for (const double levels : {70.0, 90.0}) {
    for (const char* sequence : {"CRCR", "RC"}) {
      steel.levels = levels;
      steel.sequence = sequence;
      Json request = {
          {"file",
           {{"hada", "material/1"}, {"material", "forged"}, {"parameters", json_of(steel)}}},
          {"size_px", 32},
          {"pitch", 0.1},
          {"seed", 3}};
      EXPECT_EQ(body_of(post(studio_, "api/material/preview", request.dump())),
                surface_bytes(synthesize(steel, extent, 3)))
          << levels << sequence;
    }
  }
}

}  // namespace
}  // namespace hada
