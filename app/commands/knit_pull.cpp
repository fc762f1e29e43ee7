#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/commands/knit.h"
#include "app/draw/motion_picture.h"
#include "app/draw/net_picture.h"
#include "app/files.h"
#include "app/knit_files.h"
#include "core/error.h"
#include "core/srgb.h"
#include "io/json.h"
#include "io/output.h"
#include "mechanics/knit_motion.h"
#include "mechanics/knit_rest.h"
#include "synth/knit_photograph.h"

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

// The yarn of made photographs: that of the material, else blue nylon and yellow support yarn.
Knit<> photographed_knit(const KnitPullArguments& arguments, const KnitCrossings& crossings) {
  Knit<> knit;
  if (arguments.material) {
    knit = read_knit(*arguments.material);
  } else {
    knit.yarn_radius_mm = 0.15 * crossings.net.wale_length;
    knit.loop_depth_mm = 0.8 * knit.yarn_radius_mm;
    knit.yarns = {{0.15, 0.25, 0.4}, {0.7, 0.6, 0.3}};
    knit.colour_repeat = {0.0, 1.0};
  }
  knit.wale_mm = crossings.net.wale_length, knit.course_mm = crossings.net.course_length;
  return knit;
}

void put_photograph(Output& output, const std::string& name, const Knit<>& knit,
                    const BentKnit& bent, const Extent& extent, Seed seed) {
  Image picture = knit_photograph(knit, bent, extent, seed);
  for (auto& plane : picture.planes) {
    for (float& value : plane) value = srgb_from_linear(value);
  }
  put_picture(output, name, picture);
}

// `rest.png`, filled by the knit, and `photograph_1.png`, ... of the piece as it is pulled.
void put_photographs(Output& output, const KnitPullArguments& arguments,
                     const KnitCrossings& crossings, const std::vector<Places>& pulled_to) {
  constexpr int rest_stitches = 28, seen_stitches = 24;
  const double pitch = *arguments.photograph_pitch;
  const Knit<> knit = photographed_knit(arguments, crossings);
  const auto picture_of = [&](double width, double height) {
    const Extent extent{int(std::ceil(height / pitch)), int(std::ceil(width / pitch)), pitch,
                        Unit::mm};
    if (std::max(extent.rows, extent.cols) > 8192) {
      throw Error("--photographs: pictures would be wider than 8192 pixels; give a larger pitch");
    }
    return extent;
  };
  KnitNet flat = crossings.net;
  flat.courses = flat.wales = rest_stitches;
  const auto rest = pulled(flat, KnitPull::wale, KnitClamp::uniform, 1.0);
  put_photograph(output, "rest.png", knit, {rest_stitches, rest_stitches, rest.start},
                 picture_of(seen_stitches * knit.wale_mm, seen_stitches * knit.course_mm),
                 arguments.seed);
  for (std::size_t s = 0; s < pulled_to.size(); ++s) {
    Eigen::Vector3d reach = Eigen::Vector3d::Zero();
    for (const auto& p : pulled_to[s]) reach = reach.cwiseMax(p.cwiseAbs());
    put_photograph(
        output, fmt::format("photograph_{}.png", s + 1), knit,
        {crossings.net.courses, crossings.net.wales, pulled_to[s]},
        picture_of(2.0 * reach.x() + 4.0 * knit.wale_mm, 2.0 * reach.y() + 4.0 * knit.course_mm),
        arguments.seed + 10 * (s + 1));
  }
}

}  // namespace

void knit_pull_command(const KnitPullArguments& arguments, const Terminal& terminal) {
  KnitCrossings crossings = knit_of(arguments);
  const KnitPull pull = pull_named(arguments.along);
  std::vector<Places> pictured, at_rest;
  std::vector<double> motion_of_steps;
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
      motion_of_steps = motion.motion;
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
    at_rest.push_back(places);
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
  if (!motion_of_steps.empty()) {
    put_picture(output, "motion.png", motion_picture(motion_of_steps, KnitMotionOptions().still));
  }
  if (arguments.photograph_pitch) put_photographs(output, arguments, crossings, at_rest);
  output.commit();
  terminal.say("wrote " + (arguments.out / "crossings.json").string());
  terminal.result(json.dump(1));
}

}  // namespace hada
