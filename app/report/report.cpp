#include "app/report/report.h"

#include <fmt/format.h>

#include "app/files.h"
#include "app/part_order.h"
#include "app/report/html.h"
#include "app/report/sections.h"
#include "app/telling.h"

namespace hada {
namespace {

std::string capitalized(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') sentence[0] += 'A' - 'a';
  return sentence + ".";
}

// The letter in one paragraph, for who reads no further.
std::string summary(const WholePath& path) {
  std::string text =
      fmt::format("{} photographs of {} pixels were measured. ", path.lit.stack.images.size(),
                  size_text(path.lit.photographs.camera.extent));
  text += capitalized(told(path.lit)) + " " + capitalized(told(path.reconstruction));
  const int parts = int(part_count(path.material.material));
  text += fmt::format(" Its relief is explained as {}", name_of(path.material.material));
  if (parts > 0) text += fmt::format(" with {} component{}", parts, parts == 1 ? "" : "s");
  text += "; the parameters, how sure they are and a new piece of the surface follow.";
  if (path.truth) text += " " + capitalized(told(*path.truth));
  return "<p class=\"lead\">" + escaped(text) + "</p>\n";
}

std::string footer(const WholePath& path) {
  return fmt::format(
      "<footer>hada {}. Input values {}; new surface from seed {}. Frame: x right, y up, z towards "
      "the camera.</footer>\n",
      version(), path.material.input ? path.material.input->hash : "unknown",
      path.material.seed.value_or(0));
}

}  // namespace

std::string report_html(const WholePath& path) {
  return page("The surface of " + path.name, summary(path) + pictures_section(path) +
                                                 lights_section(path) + surface_section(path) +
                                                 spectrum_section(path) + material_section(path) +
                                                 synthesis_section(path) + truth_section(path) +
                                                 advice_section(path) + footer(path));
}

}  // namespace hada
