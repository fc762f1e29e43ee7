#include "app/commands/measure.h"

#include <numbers>

#include <fmt/format.h>

#include "app/draw/spectrum_picture.h"
#include "app/files.h"
#include "app/measurement.h"
#include "app/telling.h"
#include "io/output.h"
#include "io/surface_file.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

void tell(const Measurement& m, const Terminal& terminal) {
  const bool is_height = m.quantity == "height";
  const auto unit = name_of(m.extent.unit);
  const std::string value_unit = is_height ? " " + std::string(unit) : "";
  terminal.say(fmt::format("{} of {} pixels, {:.4g} x {:.4g} {}", m.quantity, size_text(m.extent),
                           m.extent.width(), m.extent.height(), unit));
  terminal.say(fmt::format("  Sa {:.4g}{u}  Sq {:.4g}{u}  Ssk {:.3g}  Sku {:.3g}  Sdq {:.3g}",
                           m.roughness.Sa, m.roughness.Sq, m.roughness.Ssk, m.roughness.Sku,
                           m.roughness.Sdq, fmt::arg("u", value_unit)));
  terminal.say(fmt::format("  Sal {:.4g} {}  Str {:.3g}  Std {:.1f} deg", m.roughness.Sal, unit,
                           m.roughness.Str, m.roughness.Std / degree));
  std::string at;
  for (const int i : m.ring_peaks) {
    at += fmt::format("{}{:.3g}", at.empty() ? "" : ", ", m.rings.frequency[std::size_t(i)]);
  }
  terminal.say(fmt::format("  strongest rings at {} cycles/{}", at, unit));
  at.clear();
  for (const int i : m.sector_peaks) {
    at += fmt::format("{}{:.0f}", at.empty() ? "" : ", ", m.sectors.angle[std::size_t(i)] / degree);
  }
  terminal.say(fmt::format("  strongest directions of variation at {} deg", at));
}

}  // namespace

void measure_command(const MeasureArguments& arguments, const Terminal& terminal) {
  terminal.step("reading " + arguments.input.string());
  const Surface surface = read_surface(arguments.input, arguments.pitch_mm);
  terminal.step("measuring the spectrum");
  const Measurement measurement = measure(surface);
  const std::string text = measurement_text(measurement);
  if (arguments.out) {
    Output output(*arguments.out);
    put_text(output, "measure.json", text);
    put_picture(output, "spectrum.png",
                spectrum_picture(measurement.spectrum, spectrum_style(measurement.spectrum), 512));
    output.commit();
  }
  tell(measurement, terminal);
  if (arguments.out) terminal.say("wrote " + arguments.out->string());
  terminal.result(text);
}

}  // namespace hada
