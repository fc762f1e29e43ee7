#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/measurement.h"
#include "io/json.h"
#include "io/output.h"
#include "io/surface_file.h"
#include "synth/synthesize.h"
#include "tests/app/program.h"
#include "tests/studio/client.h"

namespace hada {
namespace {

using testing::HasSubstr;

const Wrinkle<> wrinkle{.components = {{0.2, 2.0, 1.0, 0.6}}};

class SpectrumRequests : public testing::Test {
 protected:
  SpectrumRequests() {
    surface_ = synthesize(wrinkle, {128, 128, 0.4, Unit::mm}, 3);
    Output output(scratch_ / "sheet");
    write_surface(output, "", surface_);
    output.commit();
  }
  Json asked(const std::string& verb, const Json& body) {
    return Json::parse(body_of(post(studio_, "api/spectrum/" + verb, body.dump())));
  }
  static Json file() {
    return {{"hada", "material/1"},
            {"material", "wrinkle"},
            {"parameters", json_of(wrinkle)},
            {"sigma", json_of(Wrinkle<>{.components = {{0.02, 0.2, 0.1, 0.05}}})}};
  }
  const TemporaryFolder scratch_;
  Surface surface_;
  RunningStudio studio_{scratch_.path()};
};

TEST_F(SpectrumRequests, AreMeasuredAsByTheCommandLine) {
  const Json told = asked("measure", {{"name", "sheet"}});
  const Json measured = Json::parse(measurement_text(measure(read_surface(scratch_ / "sheet"))));
  EXPECT_EQ(told["measure"], measured);
  EXPECT_THAT(told["picture"].get<std::string>(), HasSubstr("data:image/png"));
}

TEST_F(SpectrumRequests, TellHowAMaterialWouldLook) {
  const Json told = asked("model", {{"name", "sheet"}, {"file", file()}});
  // Half the power lies inside: 4 pi^2 l^2 f^2 = ln 2 along the long axis.
  const Json& ellipse = told["ellipses"][0];
  const double along = ellipse["axes"][0], across = ellipse["axes"][1];
  const auto peak = psd(wrinkle.components[0], 0.0, 0.0);
  const double c = std::cos(0.6), s = std::sin(0.6);
  EXPECT_NEAR(psd(wrinkle.components[0], along * c, along * s), 0.5 * peak, 1e-9 * peak);
  EXPECT_NEAR(psd(wrinkle.components[0], -across * s, across * c), 0.5 * peak, 1e-9 * peak);
  EXPECT_LT(ellipse["between"][0][0], along);
  EXPECT_GT(ellipse["between"][1][0], along);
  EXPECT_EQ(told["parameters"][0]["number"], "0.200 \u00b1 0.020");
  EXPECT_EQ(told["rings"].size(),
            asked("measure", {{"name", "sheet"}})["measure"]["rings"]["power"].size());
}

TEST_F(SpectrumRequests, KeepToTheFolderAndTheBounds) {
  for (const char* name : {"../sheet", "missing", ""}) {
    EXPECT_EQ(status_of(post(studio_, "api/spectrum/measure", Json{{"name", name}}.dump())), 422);
  }
  Json bad = file();
  bad["parameters"]["floor_mm4"] = -1;
  const std::string said =
      post(studio_, "api/spectrum/model", Json{{"name", "sheet"}, {"file", bad}}.dump());
  EXPECT_THAT(said, HasSubstr("floor_mm4"));
}

}  // namespace
}  // namespace hada
