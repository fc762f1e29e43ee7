#include "app/parameter_rows.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "app/telling.h"

namespace hada {
namespace {

std::map<std::string, double> sigma_by_path(const MaterialFile& file) {
  std::map<std::string, double> sigma;
  if (!file.sigma) return sigma;
  std::visit(
      [&](const auto& m) {
        visit_fields(
            m, [&](const std::string& path, const auto&, double value) { sigma[path] = value; });
      },
      *file.sigma);
  return sigma;
}

std::string in_the_unit(std::string unit, const MaterialFile& file) {
  const auto at = unit.find("mm");
  if (file.unit == Unit::px && at != std::string::npos) unit.replace(at, 2, "px");
  if (const auto power = unit.find("^4"); power != std::string::npos) {
    unit.replace(power, 2, "\u2074");
  }
  return unit;
}

}  // namespace

std::vector<ParameterRow> parameter_rows(const MaterialFile& file) {
  const auto sigma = sigma_by_path(file);
  std::vector<ParameterRow> rows;
  std::visit(
      [&](const auto& m) {
        visit_words(m, [&](const auto& word, const std::string& text) {
          rows.push_back({std::string(word.name), text, "", std::string(word.meaning)});
        });
        visit_fields(m, [&](const std::string& name, const auto& field, double value) {
          if (is_left_out(field, value)) return;
          const auto found = sigma.find(name);
          const bool on_bound =
              std::find(file.on_bound.begin(), file.on_bound.end(), name) != file.on_bound.end();
          std::string number = on_bound || found == sigma.end() ? fmt::format("{:.4g}", value)
                                                                : with_sigma(value, found->second);
          const auto interval =
              std::find_if(file.intervals.begin(), file.intervals.end(),
                           [&](const FieldInterval& one) { return one.path == name; });
          if (interval != file.intervals.end()) {
            number = fmt::format("{:.4g} (95 %: {:.3g} to {:.3g})", value, interval->low,
                                 interval->high);
          }
          rows.push_back({name, number, in_the_unit(std::string(field.unit), file),
                          std::string(field.meaning) + (on_bound ? " (on its bound)" : "")});
        });
      },
      file.material);
  return rows;
}

}  // namespace hada
