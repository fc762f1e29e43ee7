#include "app/surface_notes.h"

#include <cmath>

#include "app/files.h"
#include "io/json.h"

namespace hada {

std::string surface_notes(const Reconstruction& r) {
  Json notes = {{"estimator", std::string(name_of(r.estimator))}};
  const auto note = [&](const char* key, double value) {
    if (std::isfinite(value)) notes[key] = value;
  };
  note("noise", r.noise);
  note("relighting_error", r.relighting_error);
  note("left_out_error", r.left_out_error);
  note("condition", r.condition);
  if (!r.remarks.empty()) notes["remarks"] = r.remarks;
  notes["version"] = version();
  return notes.dump(1);
}

}  // namespace hada
