#include "app/commands/figure.h"

#include <numbers>

#include <fmt/format.h>

#include "app/draw/maps.h"
#include "app/files.h"
#include "app/lit_capture.h"
#include "app/telling.h"
#include "fit/figure.h"
#include "io/image_file.h"
#include "io/json.h"

namespace hada {

void figure_command(const FigureArguments& arguments, const Terminal& terminal) {
  constexpr double degree = std::numbers::pi / 180.0;
  Output output(arguments.out);
  Photographs photographs = load_folder(arguments.capture, terminal, arguments.pitch_mm);
  LitCapture lit = lit_capture(std::move(photographs), arguments.lights, terminal);
  if (!lit.lights.strengths_measured) {
    // To balance them on the sample would take its gloss for that of the lamps.
    for (Light& light : lit.stack.lights) light.strength = Eigen::Vector3d::Ones();
    lit.remarks.push_back(
        "How strong each light is was not given: all are taken as equal. A matte sphere in the "
        "pictures would tell.");
  }
  terminal.step("reading the figure");
  const Figure figure = figure_of(lit.stack, {.trunk_rad = arguments.trunk_deg * degree});

  const Json json = {{"hada", "figure/1"},
                     {"figure_specular", figure.specular},
                     {"figure_specular_sigma", figure.specular_sigma},
                     {"figure_sharpness", figure.sharpness},
                     {"figure_sharpness_sigma", figure.sharpness_sigma},
                     {"residual", figure.residual},
                     {"trunk_deg", arguments.trunk_deg},
                     {"pictures", lit.stack.images.size()},
                     {"lights", lit.source}};
  put_text(output, "figure.json", json.dump(1) + "\n");
  write_exr(output.file("diffuse.exr"), Image(figure.diffuse));
  write_exr(output.file("dive_rad.exr"), Image(figure.dive_rad));
  write_exr(output.file("dive_sigma_rad.exr"), Image(figure.dive_sigma));
  put_picture(output, "dive.png",
              scalar_picture(figure.dive_rad, figure.mask, range_of(figure.dive_rad, figure.mask)));
  output.commit();

  terminal.say(told(lit));
  for (const auto& remark : lit.remarks) terminal.say("note: " + remark);
  terminal.say(fmt::format("gloss {} of sharpness {}; the pictures are explained but for {:.2g}",
                           with_sigma(figure.specular, figure.specular_sigma),
                           with_sigma(figure.sharpness, figure.sharpness_sigma), figure.residual));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(json.dump(1));
}

}  // namespace hada
