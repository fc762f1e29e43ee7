#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/fold_log_file.h"
#include "io/json.h"
#include "sheet/fold_log.h"
#include "tests/app/program.h"
#include "tests/studio/client.h"

namespace hada {
namespace {

using testing::HasSubstr;

Json said(const std::string& answer) {
  EXPECT_EQ(status_of(answer), 200) << answer;
  return Json::parse(body_of(answer));
}

// A ray that looks straight down on a place.
Json down_to(double x, double y) {
  return {{"eye", {x, y, 3.0}}, {"way", {0.0, 0.0, -1.0}}};
}

class FoldRequests : public testing::Test {
 protected:
  Json ask(const std::string& verb, const Json& body) {
    return said(post(studio_, "api/fold/" + verb, body.dump()));
  }
  Json aim_at(double x, double y, const Json& more = Json::object()) {
    Json body = down_to(x, y);
    body["edge_parts"] = 2;
    body["corner_parts"] = 4;
    body["reach"] = 0.03;
    body.update(more);
    return ask("aim", body);
  }

  RunningStudio studio_{std::filesystem::path(HADA_SOURCE_DIR) / "data_synthetic"};
};

TEST_F(FoldRequests, DrawFoldTurnUndoAndExport) {
  const Json from = aim_at(0.51, 0.01);
  EXPECT_EQ(from["by"], "division");
  const Json to = aim_at(0.52, 0.99, {{"start", from["place"]}});
  EXPECT_EQ(to["place"], Json({0.5, 1.0, 0.0}));
  const Json stroke = {
      {"does", "score"}, {"eye", {0.5, 0.5, 3.0}}, {"from", from["place"]}, {"to", to["place"]}};
  EXPECT_EQ(ask("stroke", stroke)["faces"].size(), 2u);
  const Json grip = ask("hold", down_to(0.9, 0.4));
  EXPECT_EQ(grip["axis"][0][0], 0.5);
  // Looking along the axis the pointer goes round it freely.
  Json ray = {{"eye", {0.5, -3.0, 0.4}}, {"way", {0.0, 1.0, 0.0}}, {"whole", 15}};
  const Json dragged = ask("drag", ray);
  EXPECT_EQ(dragged["vertices"].size(), 18u);
  EXPECT_EQ(dragged["met"], false);
  const Json after = ask("drop", Json::object());
  EXPECT_EQ(after["at"], 2);
  EXPECT_EQ(after["log"][1]["do"], "swing");
  EXPECT_LT(after["strain"]["most"].get<double>(), 1e-9);
  EXPECT_EQ(ask("go", {{"at", 1}})["at"], 1);
  EXPECT_EQ(ask("go", {{"at", 2}})["vertices"], after["vertices"]);
  const std::string log = body_of(get(studio_, "api/fold/export?as=log"));
  EXPECT_EQ(replayed(fold_log_of(log, "log")).back().sheet.faces(), 2);
  for (const char* format : {"fold", "frames", "glb", "obj", "stl"}) {
    const std::string file = get(studio_, std::string("api/fold/export?as=") + format);
    EXPECT_EQ(status_of(file), 200) << format;
    EXPECT_GT(body_of(file).size(), 80u) << format;
  }
}

TEST_F(FoldRequests, ChooseHiddenFacesOnTheFlatSheetAndDrawOnThem) {
  const auto fold = [](Json from, Json to, Json faces) {
    return Json{{"do", "through"}, {"from", from}, {"to", to}, {"faces", faces}};
  };
  // The right half comes to lie on the left one.
  ask("do", fold({0.5, 1.1}, {0.5, -0.1}, Json::array()));
  EXPECT_EQ(ask("choose", {{"place", {0.9, 0.5}}})["chosen"].size(), 1u);
  EXPECT_EQ(ask("choose", {{"place", {0.8, 0.4}}})["chosen"].size(), 0u);
  ask("choose", {{"place", {0.9, 0.5}}});
  EXPECT_EQ(ask("choose", {{"place", {0.1, 0.5}}})["chosen"].size(), 2u);
  EXPECT_EQ(ask("choose", {{"none", true}})["chosen"].size(), 0u);
  const Json state = ask("choose", {{"place", {0.1, 0.5}}});
  EXPECT_EQ(state["flat_vertices"].size(), 6u);
  EXPECT_EQ(state["chosen_places"], Json({{0.1, 0.5}}));
  // The corner of the upper layer is folded in; that of the one below stays.
  const Json folded = ask("do", fold({0.0, 0.7}, {0.2, 1.1}, {{0.9, 0.5}}));
  EXPECT_EQ(folded["chosen"].size(), 0u) << "what was chosen is cut";
  const int hidden = ask("choose", {{"place", {0.1, 0.5}}})["chosen"][0].get<int>();
  EXPECT_EQ(aim_at(0.01, 0.99, {{"chosen", true}})["by"], "vertex");
  EXPECT_EQ(aim_at(0.01, 0.99, {{"chosen", true}})["face"], hidden);
  EXPECT_THAT(post(studio_, "api/fold/choose", R"({"place": [2, 0.5]})"),
              HasSubstr("beside the sheet"));
}

TEST_F(FoldRequests, SayWhatCannotBeDone) {
  EXPECT_THAT(post(studio_, "api/fold/hold", down_to(0.5, 0.5).dump()),
              HasSubstr("no crease to turn about"));
  EXPECT_THAT(post(studio_, "api/fold/hold", down_to(5.0, 0.5).dump()), HasSubstr("no paper"));
  EXPECT_THAT(post(studio_, "api/fold/drop", "{}"), HasSubstr("\"at\":0"));
}

}  // namespace
}  // namespace hada
