#include "app/commands/reconstruct.h"

#include "app/lit_capture.h"
#include "app/reconstruction_files.h"
#include "app/telling.h"
#include "core/error.h"
#include "reconstruct/reconstruct.h"

namespace hada {
namespace {

Levelling levelling_named(const std::string& name) {
  for (const auto levelling : {Levelling::offset, Levelling::plane, Levelling::quadratic}) {
    if (name_of(levelling) == name) return levelling;
  }
  throw Error("--levelling " + name + ": choose from: offset, plane, quadratic");
}

Estimator chosen_estimator(const std::string& name) {
  if (const auto estimator = estimator_named(name)) return *estimator;
  throw Error("--estimator " + name + ": choose from: " + estimator_names());
}

}  // namespace

void reconstruct_command(const ReconstructArguments& arguments, const Terminal& terminal) {
  Output output(arguments.out);
  Photographs photographs = load_folder(arguments.capture, terminal, arguments.pitch_mm);
  const LitCapture lit = lit_capture(std::move(photographs), arguments.lights, terminal);
  terminal.step("reconstructing normals and height");
  ReconstructOptions options{.levelling = levelling_named(arguments.levelling),
                             .estimator = chosen_estimator(arguments.estimator),
                             .labels = arguments.labels};
  if (arguments.prior.file) {
    const Extent frame = lit.stack.extent();
    options.prior = read_prior(arguments.prior, frame, {0, 0, frame.rows, frame.cols});
  }
  const Reconstruction result = reconstruct(lit.stack, options);

  put_reconstruction(output, "", result, lit);
  output.commit();

  terminal.say(told(lit));
  terminal.say(told(result));
  if (arguments.labels) terminal.say(told_of_labels(result));
  if (options.prior) terminal.say(told_of_prior(arguments.prior, result.surface));
  for (const auto& remark : lit.remarks) terminal.say("note: " + remark);
  for (const auto& remark : result.remarks) terminal.say("note: " + remark);
  terminal.say("wrote " + arguments.out.string());
  terminal.result(surface_notes(result, lit));
}

}  // namespace hada
