#include "app/command_list.h"
#include "app/commands/calibrate.h"
#include "app/commands/classify.h"
#include "app/commands/compare.h"
#include "app/commands/integrate.h"
#include "app/commands/measure.h"
#include "app/commands/reconstruct.h"
#include "reconstruct/estimator.h"

namespace hada {
namespace {

void add_prior(CLI::App& command, PriorArguments& a) {
  CLI::Option* const prior = command.add_option(
      "--prior", a.file,
      "heights known from elsewhere (surface folder, or height map with NaN where nothing is "
      "known) of all that the pictures show: the long waves are theirs, instead of levelling");
  prior->excludes("--levelling");
  command
      .add_option(
          "--cutoff", a.cutoff,
          "of --prior: wavelength from which on waves are theirs, in mm, or in pixels without "
          "a pitch (default: a quarter of the shorter side)")
      ->check(positive())
      ->needs(prior)
      ->type_name("LENGTH");
}

}  // namespace

void add_measuring(Commands& commands) {
  commands.add("calibrate", "Read the lights off reference spheres",
               "hada calibrate photos/sphere -o lights.json", calibrate_command,
               [](CLI::App& command, CalibrateArguments& a) {
                 add_capture(command, a);
                 add_out(command, a,
                         "lights file to write: .json, or .lp for directions alone "
                         "(default: lights.json)");
                 command
                     .add_option("--sphere", a.boxes,
                                 "left, top, right and bottom of a box around a sphere, px; once "
                                 "for each sphere (default: all that are found)")
                     ->type_name("U0 V0 U1 V1");
               });
  commands.add("reconstruct", "Turn photographs into normals, albedo and height",
               "hada reconstruct photos/sheet --lights lights.json -o out/surface",
               reconstruct_command, [](CLI::App& command, ReconstructArguments& a) {
                 add_photographs(command, a);
                 command
                     .add_option("--levelling", a.levelling,
                                 "what to take off the height: offset, plane or quadratic "
                                 "(default: plane)")
                     ->check(CLI::IsMember({"offset", "plane", "quadratic"}));
                 add_prior(command, a.prior);
                 command.add_option(
                     "--estimator", a.estimator,
                     "how normals are found: adaptive (default) finds shadows, sheen "
                     "and the light between folds; least-squares is the plain method; "
                     "others: " +
                         estimator_names());
                 command.add_flag("--labels", a.labels,
                                  "also say what became of every sample: lit, shadow, highlight, "
                                  "saturated; a picture for each light");
                 add_out(command, a, "surface folder to write")->required();
               });
  commands.add(
      "integrate", "Turn a normal map of another program into a height",
      "hada integrate normals.png --mask mask.png --intrinsics K.txt -o out/surface",
      integrate_command, [](CLI::App& command, IntegrateArguments& a) {
        command
            .add_option("normals", a.normals,
                        "x, y, z: signed floats, or integers of 8 or 16 bits for -1 to 1")
            ->required();
        command.add_option("--mask", a.mask,
                           "picture that is brighter than half where pixels count");
        command.add_option("--intrinsics", a.intrinsics,
                           "text file with the matrix fx 0 cx, 0 fy cy, 0 0 1 of the camera, in "
                           "pixels (default: seen from straight above)");
        command.add_option("--weights", a.weights,
                           "picture: how much each pixel counts, 1 over its variance");
        command.add_option("--normal-sigma", a.normal_sigma,
                           "how well normals are known, for the sigma of the height: degrees, or "
                           "a map in radians");
        add_pitch(command, a);
        command.add_flag("--y-down", a.y_down, "the y of the normals points down (default: up)");
        command
            .add_option("--jumps", a.jumps,
                        "whether the height may jump: none, allowed or automatic (default)")
            ->check(CLI::IsMember({"none", "allowed", "automatic"}));
        command
            .add_option("--levelling", a.levelling,
                        "what to take off the height: offset (default), plane or quadratic")
            ->check(CLI::IsMember({"offset", "plane", "quadratic"}));
        add_prior(command, a.prior);
        command
            .add_option("--memory", a.memory,
                        "where maps lie meanwhile: ram, disk (nameless files in the folder "
                        "to write), or automatic (default): on the disk from 64 million pixels on")
            ->check(CLI::IsMember({"ram", "disk", "automatic"}));
        add_out(command, a, "surface folder to write")->required();
      });
  commands.add("measure", "Describe a surface: spectrum, rings, sectors, roughness",
               "hada measure out/surface -o out/measured", measure_command,
               [](CLI::App& command, MeasureArguments& a) {
                 add_surface(command, a);
                 add_out(command, a, "folder for measure.json and spectrum.png");
               });
  commands.add("classify", "Say which of several kinds of sheet a surface is like",
               "hada classify out/surface -o classified.json", classify_command,
               [](CLI::App& command, ClassifyArguments& a) {
                 add_surface(command, a);
                 command.add_option("--among", a.among,
                                    "folder with a wrinkle file for each kind (default: seven "
                                    "papers)");
                 add_out(command, a, "JSON file to write");
               });
  commands.add("compare", "Say how far two surfaces differ",
               "hada compare out/surface out/capture/truth -o out/compared", compare_command,
               [](CLI::App& command, CompareArguments& a) {
                 command.add_option("first", a.first, input_words)->required();
                 command.add_option("second", a.second, input_words)->required();
                 add_pitch(command, a);
                 add_out(command, a, "folder for compare.json and compare.html");
               });
}

}  // namespace hada
