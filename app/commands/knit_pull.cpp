#include <algorithm>

#include <fmt/format.h>

#include "app/commands/knit.h"
#include "app/draw/net_picture.h"
#include "app/files.h"
#include "app/knit_files.h"
#include "core/error.h"
#include "io/json.h"
#include "io/output.h"
#include "mechanics/knit_motion.h"
#include "mechanics/knit_rest.h"

namespace hada {
namespace {

KnitCrossings knit_of(const KnitPullArguments& arguments) {
  KnitCrossings crossings;
  double ratio = 10.0;
  if (arguments.material) {
    const Knit<> knit = read_knit(*arguments.material);
    crossings.repeat = repeat_of(knit);
    crossings.net.wale_length = knit.wale_mm, crossings.net.course_length = knit.course_mm;
    crossings.net.continuity = knit.yarn_coefficient;
    ratio = knit.stiffness_ratio;
  }
  crossings.net.courses = arguments.courses, crossings.net.wales = arguments.wales;
  crossings.net.stiffness = stiffness_of_courses(arguments.courses, ratio, crossings.repeat);
  crossings.clamp = clamp_named(arguments.clamp);
  return crossings;
}

}  // namespace

void knit_pull_command(const KnitPullArguments& arguments, const Terminal& terminal) {
  KnitCrossings crossings = knit_of(arguments);
  const KnitPull pull = pull_named(arguments.along);
  std::vector<Places> pictured;
  Json json = {{"hada", "knit_pull/1"}, {"states", Json::array()}};
  KnitNet held;
  for (std::size_t s = 0; s < arguments.stretches.size(); ++s) {
    const double stretch = arguments.stretches[s];
    terminal.step(fmt::format("pulling to {:g}", stretch));
    const auto knit = pulled(crossings.net, pull, crossings.clamp, stretch);
    held = knit.net;
    Places places;
    int steps = 0;
    if (arguments.as_the_paper) {
      const auto motion = knit_motion(knit.net, knit.start);
      places = motion.places, steps = int(motion.motion.size());
      if (!motion.settled) {
        throw Error(
            fmt::format("the knit still moves after {} of the paper's steps: leave out "
                        "--as-the-paper, or take fewer stitches",
                        steps));
      }
      // On the way, as figure 8 of the paper shows it.
      for (const int on_the_way : {0, 10, 30}) {
        pictured.push_back(knit_motion(knit.net, knit.start, {.most_steps = on_the_way}).places);
      }
    } else {
      const auto rest = knit_at_rest(knit.net, knit.start);
      if (!rest.settled) {
        throw Error(
            fmt::format("a knit of {} x {} pulled to {:g} by {} clamps does not come to rest: "
                        "take fewer stitches or uniform clamps",
                        arguments.courses, arguments.wales, stretch, arguments.clamp));
      }
      places = rest.places, steps = rest.steps;
    }
    pictured.push_back(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (int axis = 0; axis < 2 && arguments.noise > 0.0; ++axis) {
        places[i][axis] += arguments.noise * crossings.net.wale_length *
                           gaussian(arguments.seed, std::int64_t(s), std::int64_t(i), axis);
      }
    }
    crossings.states.push_back({pull, stretch, places});
    json["states"].push_back({{"stretch", stretch}, {"steps", steps}});
    terminal.say(fmt::format(
        "{} x {} stitches pulled to {:g} along the {}s: {} after {} steps", arguments.courses,
        arguments.wales, stretch, arguments.along,
        arguments.as_the_paper ? "moving by less than 0.001 wale a step" : "at rest", steps));
  }
  Output output(arguments.out);
  put_text(output, "crossings.json", crossings_text(crossings));
  put_picture(output, "pulled.png", net_picture(held, pictured));
  output.commit();
  terminal.say("wrote " + (arguments.out / "crossings.json").string());
  terminal.result(json.dump(1));
}

}  // namespace hada
