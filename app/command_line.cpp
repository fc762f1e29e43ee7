#include "app/command_line.h"

#include "app/command_list.h"
#include "app/commands/contact.h"
#include "app/commands/demo.h"
#include "app/commands/figure.h"
#include "app/commands/fit.h"
#include "app/commands/materials.h"
#include "app/commands/photograph.h"
#include "app/commands/run.h"
#include "app/commands/synth.h"
#include "app/commands/validate.h"
#include "app/files.h"
#include "core/error.h"

// A command is an entry here: its words, its example, and the struct of arguments that its function
// takes.
namespace hada {
namespace {

void add_all_steps(Commands& commands) {
  commands.add("demo", "Make a virtual capture and walk the whole path", "hada demo -o out/demo",
               demo_command, [](CLI::App& command, DemoArguments& a) {
                 add_out(command, a, "folder to write (default: out/demo)");
                 command.add_option("--recipe", a.recipe, "recipe instead of the shipped one");
               });
  commands.add("run", "All steps from photographs to a new surface and a report",
               "hada run photos/sheet --material wrinkle -o out/sheet", run_command,
               [](CLI::App& command, RunArguments& a) {
                 add_capture(command, a);
                 command.add_option("--material", a.path.material,
                                    "what to fit (default: wrinkle); see hada materials");
                 command
                     .add_option("--components", a.path.components,
                                 "number of components; of a texture, of noise functions of both "
                                 "kinds (default: the data decide)")
                     ->check(CLI::Range(1, 8));
                 command.add_option("--seed", a.path.seed, "of the new surface (default: 1)");
                 add_lights(command, a);
                 add_pitch(command, a);
                 add_out(command, a, "folder to write (default: out)");
               });
}

void add_modelling(Commands& commands) {
  commands.add(
      "fit", "Find the parameters of a material that explain a surface",
      "hada fit wrinkle out/surface -o material.json", fit_command,
      [](CLI::App& command, FitArguments& a) {
        command.add_option("material", a.material, "its name; see hada materials")->required();
        add_surface(command, a);
        command
            .add_option("--components", a.components,
                        "number of components; of a texture, of noise functions of both kinds "
                        "(default: the data decide)")
            ->check(CLI::Range(1, 8));
        command
            .add_option("--lens-blur", a.lens_blur_px,
                        "of wrinkles: standard deviation of what the lens blurs, in pixels, where "
                        "it is known (default: 0)")
            ->type_name("PX")
            ->check(CLI::Range(0.0, 10.0));
        command.add_flag("--ridges", a.ridges,
                         "of wrinkles: find skew, tail and sharpness too, which the spectrum does "
                         "not know (takes seconds)");
        command.add_option("--face", a.face,
                           "of wood: picture of the tangential face, stem upright, same pitch");
        command
            .add_option(
                "--view", a.view,
                "of wood: whether the input is an end-grain or a face; of forged: block if a "
                "pixel is a place of the block and none is turned (default: automatic)")
            ->check(CLI::IsMember({"automatic", "end-grain", "face", "block"}));
        command.add_option("--pulled", a.pulled,
                           "of knit: photographs of one piece pulled between clamps, its middle "
                           "in theirs, same pitch");
        command
            .add_option("--stretch", a.stretches,
                        "of the piece in each of them: length over that at rest")
            ->check(CLI::Range(1.0, 10.0));
        command.add_option("--along", a.along, "its pull: wale (default) or course")
            ->check(CLI::IsMember({"wale", "course"}));
        command.add_option("--clamp", a.clamp, "its clamps: three-points (default) or uniform")
            ->check(CLI::IsMember({"uniform", "three-points"}));
        command.add_option("--courses", a.courses, "of the piece, those that are held included")
            ->check(CLI::Range(3, 2000));
        command.add_option("--wales", a.wales, "of the piece")->check(CLI::Range(3, 2000));
        command.add_option("--crossings", a.crossings,
                           "folder to write the crossings that were tracked into, with pictures");
        command.add_option("--report", a.report,
                           "of forged: page to write (HTML) with picture, new piece, spectrum and "
                           "the sequences with their probabilities");
        add_out(command, a, "material file to write (default: material.json)");
      });
  commands.add("figure", "Read gloss and dive of the fibres off a polished cut of wood",
               "hada figure photos/board --lights lights.json --trunk 90 -o out/figure",
               figure_command, [](CLI::App& command, FigureArguments& a) {
                 add_photographs(command, a);
                 command
                     .add_option("--trunk", a.trunk_deg,
                                 "direction up the trunk in the pictures, counter-clockwise from "
                                 "+x (default: 90, upward)")
                     ->type_name("DEG")
                     ->check(CLI::Range(-360.0, 360.0));
                 add_out(command, a, "folder to write")->required();
               });
  commands.add("synth", "Make more of a surface from its material file",
               "hada synth material.json --size 1024x768 --pitch 0.1 --seed 7 -o out/more",
               synth_command, [](CLI::App& command, SynthArguments& a) {
                 command.add_option("material", a.material, "material file")->required();
                 command
                     .add_option("--size", a.size_px,
                                 "width x height in pixels (default: as fitted, or 512x512)")
                     ->type_name("WxH");
                 add_pitch(command, a);
                 command.add_option("--seed", a.seed,
                                    "of the surface (default: of the file, or 1)");
                 command
                     .add_option("--at", a.at,
                                 "cut a window around this place out of a surface without end, "
                                 "instead of a surface that tiles")
                     ->type_name("X Y")
                     ->expected(2);
                 command.add_flag("--blender", a.blender,
                                  "also write wood.py: the stem of wood as nodes of Blender 3.4");
                 command.add_flag("--materialx", a.materialx,
                                  "also write wood.mtlx: the same as a MaterialX document");
                 add_out(command, a, "surface folder to write")->required();
               });
  commands.add("contact", "Put what material files describe side by side",
               "hada contact data_synthetic/forged_*.json -o out/contact.png", contact_command,
               [](CLI::App& command, ContactArguments& a) {
                 command.add_option("materials", a.materials, "material files")->required();
                 command.add_option("--columns", a.columns, "pictures in a row (default: 2)")
                     ->check(CLI::Range(1, 16));
                 command
                     .add_option("--width", a.width_px, "of one picture, px at most (default: 600)")
                     ->check(CLI::Range(16, 4096));
                 add_out(command, a, "PNG to write (default: contact.png)");
               });
  commands.add("materials", "List the materials and their parameters", "hada materials wrinkle",
               materials_command, [](CLI::App& command, MaterialsArguments& a) {
                 command.add_option("name", a.name, "only this one");
                 command.add_flag("--markdown", a.markdown, "as a page of documentation");
               });
}

void add_virtual(Commands& commands) {
  commands.add("photograph", "Photograph a virtual sheet",
               "hada photograph data_synthetic/sheet_and_spheres.json -o out/capture",
               photograph_command, [](CLI::App& command, PhotographArguments& a) {
                 command.add_option("recipe", a.recipe, "recipe file")->required();
                 add_out(command, a, "capture folder to write")->required();
               });
  commands.add("validate", "Ask what a rig can measure: errors and coverage over many seeds",
               "hada validate data_synthetic/sheet_and_spheres.json --seeds 8 -o out/validated",
               validate_command, [](CLI::App& command, ValidateArguments& a) {
                 command.add_option("recipe", a.recipe, "recipe file")->required();
                 command.add_option("--seeds", a.seeds, "number of virtual captures (default: 8)")
                     ->check(CLI::Range(1, 1000));
                 add_out(command, a, "folder for validate.json");
               });
}

// One line, however many the parser wrote.
std::string sentence(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace

Request parse_command_line(int count, const char* const* words, void (*more)(Commands&)) {
  Request request;
  Commands commands(request);
  add_all_steps(commands);
  add_measuring(commands);
  add_modelling(commands);
  add_virtual(commands);
  add_folding(commands);
  add_knitting(commands);
  add_wood(commands);
  add_steel(commands);
  if (more) more(commands);
  try {
    commands.app().parse(count, words);
  } catch (const CLI::CallForHelp&) {
    request.text = commands.app().help();
  } catch (const CLI::CallForVersion& call) {
    request.text = std::string(call.what()) + "\n";
  } catch (const CLI::ParseError& error) {
    std::string name;
    for (auto chosen = commands.app().get_subcommands(); !chosen.empty();
         chosen = chosen.front()->get_subcommands()) {
      name += " " + chosen.front()->get_name();
    }
    throw Error(sentence(error.what()) + "; see hada" + name + " --help");
  }
  return request;
}

}  // namespace hada
