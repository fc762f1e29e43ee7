#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

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
  EXPECT_EQ(ask("drag", ray)["vertices"].size(), 18u);
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

TEST_F(FoldRequests, SayWhatCannotBeDone) {
  EXPECT_THAT(post(studio_, "api/fold/hold", down_to(0.5, 0.5).dump()),
              HasSubstr("no crease to turn about"));
  EXPECT_THAT(post(studio_, "api/fold/hold", down_to(5.0, 0.5).dump()), HasSubstr("no paper"));
  EXPECT_THAT(post(studio_, "api/fold/drop", "{}"), HasSubstr("\"at\":0"));
}

TEST_F(FoldRequests, AreAnsweredWhileAHandMoves) {
  // The crane, unfolded into more creases: 150 faces.
  ask("open", {{"name", "folds/crane.json"}});
  Json state = ask("go", {{"at", 20}});
  for (const double x : {0.35, 0.42, 0.46, 0.55}) {
    state = ask("stroke", {{"does", "score"},
                           {"eye", {x, 0.5, 9.0}},
                           {"from", {x, -0.2, 0.0}},
                           {"to", {x, 0.9, 0.0}}});
  }
  const std::size_t faces = state["faces"].size();
  EXPECT_GE(faces, 150u);
  Json held;
  for (const double y : {0.6, 0.55, 0.65}) {
    const std::string answer = post(studio_, "api/fold/hold", down_to(0.58, y).dump());
    if (status_of(answer) == 200) held = Json::parse(body_of(answer));
  }
  ASSERT_FALSE(held.is_null());
  Connection hand(studio_.port());
  std::vector<double> aims, drags;
  const auto timed = [&](const std::string& verb, const Json& body, std::vector<double>& times) {
    const std::string text = post_text(studio_, "api/fold/" + verb, body.dump());
    const auto start = std::chrono::steady_clock::now();
    hand.say(text);
    const std::string answer = hand.hear();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
    EXPECT_EQ(status_of(answer), 200) << answer;
  };
  for (int i = 0; i < 40; ++i) {
    Json ray = {{"eye", {3.0, -3.0, 2.0}}, {"way", {-2.5 + 0.01 * i, 3.5, -1.9}}};
    timed("drag", ray, drags);
    Json aim = down_to(0.3 + 0.01 * i, 0.4);
    aim.update({{"edge_parts", 4}, {"corner_parts", 4}, {"reach", 0.02}});
    timed("aim", aim, aims);
  }
  for (auto* times : {&drags, &aims}) {
    std::nth_element(times->begin(), times->begin() + 20, times->end());
    RecordProperty(times == &drags ? "drag_ms" : "aim_ms", std::to_string((*times)[20]));
    std::printf("%s, %zu faces: %.2f ms median\n", times == &drags ? "drag" : "aim", faces,
                (*times)[20]);
    // The goal is 5 ms; other work on the machine may take three quarters of it.
    EXPECT_LT((*times)[20], 20.0);
  }
}

}  // namespace
}  // namespace hada
