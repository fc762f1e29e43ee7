#include <algorithm>

#include <fmt/format.h>

#include "app/commands/knit.h"
#include "app/draw/worn_picture.h"
#include "app/files.h"
#include "app/knit_files.h"
#include "app/worn_mesh.h"
#include "core/error.h"
#include "core/quantile.h"
#include "io/json.h"
#include "io/mesh_file.h"
#include "io/output.h"
#include "mechanics/wear_stocking.h"
#include "mechanics/worn_maps.h"
#include "synth/leg.h"

namespace hada {
namespace {

Json range_of_values(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {{"least", *low}, {"median", median(values)}, {"largest", *high}};
}

std::string points_csv(const WornKnit& knit, const std::vector<double>& density,
                       const std::vector<double>& pressure, const std::vector<double>& light,
                       const std::string& pressure_unit) {
  std::string text =
      "course,wale,x_mm,y_mm,z_mm,stitches_per_mm2,pressure_" + pressure_unit + ",transmittance\n";
  for (std::size_t i = 0; i < knit.places.size(); ++i) {
    const auto& p = knit.places[i];
    text +=
        fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", course_of(knit, int(i)),
                    wale_of(knit, int(i)), p.x(), p.y(), p.z(), density[i], pressure[i], light[i]);
  }
  return text;
}

}  // namespace

void knit_wear_command(const KnitWearArguments& arguments, const Terminal& terminal) {
  WearOptions options = arguments.options;
  options.axis = int(arguments.axis[0] - 'x');
  if (arguments.material) {
    const Knit<> knit = read_knit(*arguments.material);
    options.ratio = knit.stiffness_ratio, options.continuity = knit.yarn_coefficient;
    options.repeat = repeat_of(knit);
  }
  terminal.step("reading the body");
  const bool stocking = arguments.shell == "stocking";
  if (stocking && arguments.loops) {
    throw Error("--loops draws the loops of a tube: leave it out, or take --shell tube");
  }
  if (stocking && options.from_mm) {
    throw Error("--from is where a tube begins: a stocking is closed there, leave it out");
  }
  const LegShape leg{.foot_mm = stocking ? 230.0 : 0.0};
  const Body body(arguments.body ? read_mesh(*arguments.body) : leg_mesh(leg));
  terminal.step("drawing the knit over it");
  WornKnit knit;
  try {
    knit = stocking ? worn_stocking(body, options) : worn(body, options);
  } catch (const Error& error) {
    throw Error((arguments.body ? arguments.body->string() : "the leg") + ": " + error.what());
  }
  const TautYarns yarns = taut_yarns(body, knit);
  const double radius =
      arguments.yarn_radius_mm > 0.0 ? arguments.yarn_radius_mm : 0.1 * median(knit.wale_mm);
  const auto density = densities(knit), light = transmittances(knit, radius);
  auto pressure = pressures(knit, int(options.repeat.size()));
  const std::string unit = arguments.nylon_N_per_mm ? "kPa" : "k/mm";
  for (double& value : pressure) value *= 1e3 * arguments.nylon_N_per_mm.value_or(1e-3);

  terminal.step("drawing pictures");
  const WornView view{.turn_deg = arguments.turn_deg,
                      .rows = arguments.picture_rows,
                      .axis = options.axis,
                      .yarn_radius_mm = radius};
  WornView near = view;
  near.height_mm = 24.0 * median(knit.course_mm);
  near.middle_mm = knit.places[knit.places.size() / 2][options.axis];
  Output output(arguments.out);
  put_picture(output, "worn.png", worn_picture(body, knit, yarns, view));
  put_picture(output, "near.png", worn_picture(body, knit, yarns, near));
  put_picture(output, "density.png", worn_map(body, knit, density, "/mm^2", view));
  put_picture(output, "pressure.png", worn_map(body, knit, pressure, unit, view));
  put_picture(output, "transmittance.png", worn_map(body, knit, light, "", view));
  if (arguments.loops) {
    // Where stitches are narrowest loops come nearest to each other.
    const double narrowest = *std::min_element(knit.wale_mm.begin(), knit.wale_mm.end());
    write_mesh(output, "loops.glb", loop_mesh(knit, std::min(radius, thickest_loop * narrowest)));
  }
  write_mesh(output, "yarns.glb", yarn_mesh(knit, yarns, radius));
  put_text(
      output, "points.csv",
      points_csv(knit, density, pressure, light, arguments.nylon_N_per_mm ? "kPa" : "k_per_mm"));
  // The tip of a stocking, its last point, is no course.
  const int courses = course_of(knit, int(knit.places.size()) - 1) + (stocking ? 0 : 1);
  const Json json = {{"hada", "knit_worn/1"},
                     {"shell", arguments.shell},
                     {"courses", courses},
                     {"wales", options.wales},
                     {"stitches", knit.places.size()},
                     {"steps", knit.steps},
                     {"settled", knit.settled},
                     {"sliding", knit.sliding},
                     {"slack", knit.slack},
                     {"lifting", knit.lifting},
                     {"inserted", yarns.inserted},
                     {"penetrating", penetrating(body, knit, yarns.lines, 1e-6)},
                     {"yarn_radius_mm", radius},
                     {"stitches_per_mm2", range_of_values(density)},
                     {"pressure_" + unit, range_of_values(pressure)},
                     {"transmittance", range_of_values(light)}};
  put_text(output, "worn.json", json.dump(1) + "\n");
  output.commit();
  terminal.say(
      fmt::format("{} courses of {} wales, {} stitches, {} steps{}; {} points inserted, {} yarns "
                  "inside the body",
                  courses, options.wales, knit.places.size(), knit.steps,
                  knit.settled ? "" : " without coming to rest", yarns.inserted,
                  json["penetrating"].get<int>()));
  if (knit.slack > 0) {
    terminal.say(
        fmt::format("{} springs are slack: a smaller --length keeps them taut", knit.slack));
  }
  if (knit.lifting > 0) {
    terminal.say(fmt::format("{} points would lift off hollows of the body", knit.lifting));
  }
  terminal.say("wrote " + arguments.out.string());
  terminal.result(json.dump(1));
}

}  // namespace hada
