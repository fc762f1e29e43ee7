#include "studio/job.h"

#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/json.h"
#include "tests/app/program.h"
#include "tests/studio/client.h"

namespace hada {
namespace {

using testing::HasSubstr;

JobState ended(const Job& job) {
  JobState state = job.state();
  for (int i = 0; i < 60 && state.state == "running"; ++i) state = job.wait(state.changes);
  return state;
}

TEST(Job, TellsWhatAProcessSaysAndHowItEnds) {
  Job job;
  EXPECT_EQ(job.state().state, "none");
  job.start("two lines", {"/bin/sh", "-c", "echo one; echo two >&2"});
  const JobState state = ended(job);
  EXPECT_EQ(state.state, "done");
  EXPECT_EQ(state.lines, (std::vector<std::string>{"one", "two"}));
  job.start("failure", {"/bin/sh", "-c", "exit 2"});
  EXPECT_EQ(ended(job).state, "failed");
  EXPECT_EQ(job.state().number, 2);
}

TEST(Job, IsOneAtATimeAndCanBeCancelled) {
  Job job;
  job.start("sleep", {"/bin/sleep", "30"});
  try {
    job.start("another", {"/bin/true"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("wait for it, or cancel it"));
  }
  const auto start = std::chrono::steady_clock::now();
  job.cancel();
  EXPECT_EQ(ended(job).state, "cancelled");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(JobRequests, CalibrateReconstructAndLeaveNothingWhenCancelled) {
  const TemporaryFolder scratch;
  ASSERT_EQ(make_capture(scratch / "photos").code, 0);
  const RunningStudio studio(scratch.path());
  const auto state = [&] { return Json::parse(body_of(get(studio, "api/job/state"))); };
  const auto wait = [&] {
    for (int i = 0; i < 300 && state()["state"] == "running"; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return state();
  };
  EXPECT_THAT(body_of(get(studio, "api/capture/list")), HasSubstr("\"name\":\"photos\""));
  EXPECT_EQ(status_of(post(studio, "api/job/calibrate", R"({"capture": "photos"})")), 200);
  EXPECT_EQ(wait()["state"], "done") << state();
  EXPECT_THAT(body_of(get(studio, "api/job/lights")), HasSubstr("lights/1"));
  const std::string off = R"({"capture": "photos", "boxes": [[0, 0, 20, 20]]})";
  EXPECT_EQ(status_of(post(studio, "api/job/calibrate", off)), 200);
  EXPECT_EQ(wait()["state"], "failed") << state();
  EXPECT_THAT(state()["lines"].back().get<std::string>(), HasSubstr("holds no sphere"));
  for (const char* boxes : {"[[0, 0, 20]]", "7", "[[0, 0, 20, \"--help\"]]", "[[0, 0, 20, -1]]"}) {
    const std::string body = R"({"capture": "photos", "boxes": )" + std::string(boxes) + "}";
    EXPECT_EQ(status_of(post(studio, "api/job/calibrate", body)), 422) << boxes;
  }
  const std::string reconstruct = R"({"capture": "photos", "out": "sheet"})";
  EXPECT_EQ(status_of(post(studio, "api/job/reconstruct", reconstruct)), 200);
  EXPECT_EQ(status_of(post(studio, "api/job/calibrate", R"({"capture": "photos"})")), 409);
  EXPECT_EQ(status_of(post(studio, "api/job/cancel", "{}")), 200);
  EXPECT_EQ(wait()["state"], "cancelled") << state();
  EXPECT_FALSE(std::filesystem::exists(scratch / "sheet"));
  EXPECT_EQ(status_of(post(studio, "api/job/reconstruct", reconstruct)), 200);
  EXPECT_EQ(wait()["state"], "done") << state();
  EXPECT_TRUE(std::filesystem::exists(scratch / "sheet/surface.json"));
  // Nothing is written over, nor beside the folder, nor read beyond it.
  for (const char* body :
       {R"({"capture": "photos", "out": "sheet"})", R"({"capture": "photos", "out": "../x"})",
        R"({"capture": "photos", "out": "-x"})", R"({"capture": "../photos", "out": "x"})",
        R"({"capture": "photos", "out": ""})"}) {
    EXPECT_EQ(status_of(post(studio, "api/job/reconstruct", body)), 422) << body;
  }
  // What happens is told as it happens.
  Connection events(studio.port());
  events.say(get_text(studio, "api/job/events"));
  EXPECT_THAT(events.hear(), HasSubstr("text/event-stream"));
}

}  // namespace
}  // namespace hada
