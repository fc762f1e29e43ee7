#include "app/commands/fold.h"

#include <charconv>

#include <fmt/format.h>

#include "app/fold_input.h"
#include "app/sheet_mesh.h"
#include "core/error.h"
#include "io/fold_file.h"
#include "io/json.h"
#include "io/output.h"
#include "sheet/flat_check.h"
#include "sheet/flat_fold.h"
#include "sheet/layers.h"

namespace hada {
namespace {

// What keeps the paper from lying flat: the first flaw, or nothing.
std::string first_flaw(const std::vector<FlatFlaw>& flaws, const Layers& layers) {
  if (!flaws.empty()) return flaws[0].reason;
  return layers.possible ? "" : layers.reason;
}

struct Folded {
  Sheet sheet;
  std::string title;
  std::vector<FlatFlaw> flaws;
  FlatState state;
  Layers layers;  // empty where a vertex has a flaw
};

Folded fold_flat(const std::filesystem::path& path, const LayerOptions& options) {
  Folded folded;
  folded.sheet = read_sheet(path, &folded.title);
  folded.flaws = flat_flaws(folded.sheet);
  folded.state = flat_state(folded.sheet);
  if (folded.flaws.empty()) folded.layers = layer_orders(folded.sheet, folded.state, options);
  return folded;
}

Json result_of(const Folded& folded, const char* kind) {
  Json json = {{"hada", kind},
               {"vertices", folded.sheet.vertices()},
               {"edges", folded.sheet.edges()},
               {"faces", folded.sheet.faces()},
               {"flat_foldable", folded.layers.possible},
               {"reason", first_flaw(folded.flaws, folded.layers)}};
  json["flaws"] = Json::array();
  for (const FlatFlaw& flaw : folded.flaws) {
    json["flaws"].push_back({{"vertex", flaw.vertex}, {"reason", flaw.reason}});
  }
  return json;
}

void tell_size(const Folded& folded, const Terminal& terminal) {
  terminal.say(fmt::format("{} vertices, {} edges, {} faces", folded.sheet.vertices(),
                           folded.sheet.edges(), folded.sheet.faces()));
}

// The flat pattern and its folded form, in one file.
FoldFile document(const Folded& folded) {
  FoldFile file;
  file.title = folded.title;
  Sheet sheet = folded.sheet;
  for (std::size_t v = 0; v < sheet.folded.size(); ++v) {
    sheet.folded[v] << folded.state.vertices[v], 0.0;
  }
  file.frames.push_back(folded_frame(sheet));
  file.frames[0].face_orders = folded.layers.order;
  file.frames.push_back(flat_frame(sheet));
  return file;
}

void expect_possible(const Folded& folded, const std::filesystem::path& input) {
  const std::string flaw = first_flaw(folded.flaws, folded.layers);
  if (!flaw.empty()) throw Error(input.string() + ": does not fold flat: " + flaw);
}

FaceOrder chosen_from(const std::string& text) {
  FaceOrder order;
  order.order = 1;
  const char* end = text.data() + text.size();
  const auto [middle, first] = std::from_chars(text.data(), end, order.face);
  const bool good = first == std::errc{} && middle != end && *middle == '>';
  const auto [last, second] = good ? std::from_chars(middle + 1, end, order.other)
                                   : std::from_chars_result{end, std::errc::invalid_argument};
  if (second != std::errc{} || last != end) {
    throw Error("--above " + text + ": must be two faces, as in '3>7'");
  }
  return order;
}

}  // namespace

void fold_check_command(const FoldCheckArguments& arguments, const Terminal& terminal) {
  const Folded folded = fold_flat(arguments.input, {.count = false});
  tell_size(folded, terminal);
  for (const FlatFlaw& flaw : folded.flaws) terminal.say("  " + flaw.reason);
  if (folded.layers.possible) {
    terminal.say("folds flat: every vertex does, and the layers find an order");
  } else if (folded.flaws.empty()) {
    terminal.say("does not fold flat: " + folded.layers.reason);
  } else {
    terminal.say(fmt::format("does not fold flat: {} vertices fail", folded.flaws.size()));
  }
  terminal.result(result_of(folded, "fold_check/1").dump(1));
}

void fold_flat_command(const FoldFlatArguments& arguments, const Terminal& terminal) {
  const Folded folded = fold_flat(arguments.input, {.count = false});
  expect_possible(folded, arguments.input);
  write_text(arguments.out, fold_text(document(folded)));
  tell_size(folded, terminal);
  terminal.say(fmt::format("{} pairs of faces overlap; faces agree about vertices within {:.1e}",
                           folded.layers.overlapping_pairs, folded.state.gap));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(result_of(folded, "fold_flat/1").dump(1));
}

void fold_states_command(const FoldStatesArguments& arguments, const Terminal& terminal) {
  LayerOptions options;
  for (const std::string& text : arguments.chosen) options.chosen.push_back(chosen_from(text));
  const Folded folded = fold_flat(arguments.input, options);
  for (const FaceOrder& o : options.chosen) {
    if (std::min(o.face, o.other) < 0 || std::max(o.face, o.other) >= folded.sheet.faces()) {
      throw Error(fmt::format("--above {}>{}: the sheet has faces 0 to {}", o.face, o.other,
                              folded.sheet.faces() - 1));
    }
  }
  tell_size(folded, terminal);
  const std::string states = folded.layers.states();
  terminal.say(fmt::format("{} pairs of faces overlap, {} parts can be ordered independently",
                           folded.layers.overlapping_pairs, folded.layers.part_states.size()));
  terminal.say(states + (states == "1" ? " state" : " states"));
  const std::string flaw = first_flaw(folded.flaws, folded.layers);
  if (!flaw.empty()) terminal.say("because " + flaw);
  if (arguments.out) {
    expect_possible(folded, arguments.input);
    write_text(*arguments.out, fold_text(document(folded)));
    terminal.say("wrote " + arguments.out->string());
  }
  Json json = result_of(folded, "fold_states/1");
  json["overlapping_pairs"] = folded.layers.overlapping_pairs;
  constexpr std::size_t exact_digits = 15;  // of a number in JSON; more are told as text
  json["states"] = states.size() <= exact_digits ? Json(std::stoll(states)) : Json(states);
  json["part_states"] = folded.layers.part_states;
  terminal.result(json.dump(1));
}

void fold_convert_command(const FoldConvertArguments& arguments, const Terminal& terminal) {
  FoldFile file = read_crease_pattern(arguments.input);
  for (FoldFrame& frame : file.frames) {
    if (!frame.faces.empty() || frame.edges.empty()) continue;
    const FoldFrame with_faces = flat_frame(sheet_of(frame, arguments.input.string()));
    frame = with_faces;
  }
  if (arguments.out.extension() == ".fold") {
    write_text(arguments.out, fold_text(file));
  } else {
    const double thickness = arguments.thickness.value_or(paper_thickness(file.frames[0]));
    write_mesh(arguments.out, mesh_of(file.frames[0], thickness));
  }
  const FoldFrame& key = file.frames[0];
  terminal.say(fmt::format("{} vertices, {} edges, {} faces, {} frames", key.vertices.size(),
                           key.edges.size(), key.faces.size(), file.frames.size()));
  terminal.say("wrote " + arguments.out.string());
  terminal.result(Json{{"hada", "fold_convert/1"},
                       {"vertices", key.vertices.size()},
                       {"edges", key.edges.size()},
                       {"faces", key.faces.size()},
                       {"frames", file.frames.size()}}
                      .dump(1));
}

}  // namespace hada
