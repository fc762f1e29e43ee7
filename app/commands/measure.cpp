#include "app/commands/measure.h"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "app/draw/spectrum_picture.h"
#include "app/files.h"
#include "app/measurement.h"
#include "app/telling.h"
#include "io/output.h"
#include "io/surface_file.h"
#include "measure/plane_share.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::string decay_text(const Decay& decay, const Extent& extent) {
  const auto unit = name_of(extent.unit);
  // A corner that lies among the first few waves is not seen.
  const bool flat = decay.corner > 2.0 * decay.corner_sigma;
  std::string text = flat
                         ? fmt::format("  spectrum flat up to {} cycles/{}, then falling as f^-{}",
                                       with_sigma(decay.corner, decay.corner_sigma), unit,
                                       with_sigma(decay.slope, decay.slope_sigma))
                         : "  spectrum falling as f^-" + with_sigma(decay.slope, decay.slope_sigma);
  if (const auto hurst = decay.hurst()) {
    text += fmt::format(" (Hurst exponent {})", with_sigma(*hurst, 0.5 * decay.slope_sigma));
  }
  // A floor of which nothing is known does not rise above its own sigma.
  if (decay.floor > 2.0 * decay.floor_sigma) {
    text += fmt::format(", down to white noise of {:.3g} {} rms",
                        std::sqrt(decay.floor) / extent.pitch, unit);
  }
  return text;
}

void tell(const Measurement& m, const Terminal& terminal) {
  const bool is_height = m.quantity == "height";
  const auto unit = name_of(m.extent.unit);
  terminal.say(fmt::format("{} of {} pixels, {:.4g} x {:.4g} {}", m.quantity, size_text(m.extent),
                           m.extent.width(), m.extent.height(), unit));
  for (const RoughnessField& field : roughness_fields) {
    const double value = m.roughness.value.*(field.value), sigma = m.roughness.sigma.*(field.value);
    terminal.say(fmt::format("  {:<4} {:<20} {:<9} {}", field.name, with_sigma(value, sigma),
                             is_height || field.name == "Sal" ? unit_of(field, m.extent.unit) : "",
                             field.meaning));
  }
  for (const Band& band : m.bands) {
    terminal.say(fmt::format(
        "  waves of {} {}, rms {}, {}", with_sigma(band.wavelength, band.wavelength_sigma), unit,
        with_sigma(band.rms, band.rms_sigma),
        band.anisotropy < 0.3
            ? std::string("in all directions")
            : "varying along " +
                  with_sigma(band.direction / degree, band.direction_sigma / degree) + " deg"));
  }
  if (m.decay) terminal.say(decay_text(*m.decay, m.extent));
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
  const Surface surface =
      read_surface(arguments.input, arguments.pitch_mm, SurfaceMaps::height_alone);
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
  if (surface.has_height() && plane_share(surface.height, surface.mask) > much_plane) {
    terminal.say(
        "note: most of the height is a plane: these numbers tell of its tilt; take it off");
  }
  if (arguments.out) terminal.say("wrote " + arguments.out->string());
  terminal.result(text);
}

}  // namespace hada
