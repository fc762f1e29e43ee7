#include "app/commands/compare.h"

#include <numbers>

#include <fmt/format.h>

#include "app/comparison.h"
#include "app/files.h"
#include "app/report/compare_page.h"
#include "app/telling.h"
#include "io/output.h"
#include "io/surface_file.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

void tell(const Comparison& c, const Terminal& terminal) {
  const auto unit = name_of(c.first.extent.unit);
  const bool is_height = c.first.quantity == "height";
  if (!c.overlap) {
    terminal.say("the surfaces do not lie over each other: only their statistics are compared");
  } else {
    const Overlap& o = *c.overlap;
    terminal.say(fmt::format("{} differs by {:.4g}{} rms ({:.2f} % of its spread) on {} pixels",
                             c.first.quantity, o.height_rmse,
                             is_height ? " " + std::string(unit) : "",
                             100.0 * o.height_rmse / o.height_std, o.pixels));
    if (o.has_normals) {
      terminal.say(fmt::format("normals differ by {:.3f} deg mean, {:.3f} deg median",
                               o.normal_mean / degree, o.normal_median / degree));
    }
  }
  terminal.say(
      fmt::format("ring spectra differ by {:.2f} dB; two surfaces of one kind by {:.2f} dB",
                  c.spectral_distance_db, c.spectral_floor_db));
  for (const RoughnessField& field : roughness_fields) {
    const auto of = [&](const Measurement& m) {
      return with_sigma(m.roughness.value.*(field.value), m.roughness.sigma.*(field.value));
    };
    terminal.say(fmt::format("  {:<4} {:<20} {}", field.name, of(c.first), of(c.second)));
  }
}

}  // namespace

void compare_command(const CompareArguments& arguments, const Terminal& terminal) {
  terminal.step("reading the surfaces");
  const Surface first = read_surface(arguments.first, arguments.pitch_mm);
  const Surface second = read_surface(arguments.second, arguments.pitch_mm);
  terminal.step("comparing");
  const Comparison comparison = compare(first, second);
  const std::string text = comparison_text(comparison);
  if (arguments.out) {
    Output output(*arguments.out);
    put_text(output, "compare.json", text);
    put_text(output, "compare.html", compare_page(first, second, comparison));
    output.commit();
  }
  tell(comparison, terminal);
  if (arguments.out) terminal.say("open " + (*arguments.out / "compare.html").string());
  terminal.result(text);
}

}  // namespace hada
