#include "app/command_list.h"
#include "app/commands/blade.h"

namespace hada {

void add_steel(Commands& commands) {
  commands.add(
      "blade", "Make a sword blade of forged steel as glTF",
      "hada blade data_synthetic/forged_ccr3.json --hamon 0.3 -o out/blade", blade_command,
      [](CLI::App& command, BladeArguments& a) {
        command.add_option("material", a.material, "material file of forged steel")->required();
        command.add_option("--length", a.shape.length_mm, "mm (default: 700)")
            ->check(CLI::Range(10.0, 5000.0));
        command.add_option("--width", a.shape.width_mm, "at the base, mm (default: 31)")
            ->check(CLI::Range(1.0, 500.0));
        command.add_option("--curvature", a.shape.curvature_mm, "sori, mm (default: 16)")
            ->check(CLI::Range(0.0, 500.0));
        command
            .add_option("--hamon", a.hamon.height,
                        "share of the width that is hardened (default: 0, none)")
            ->check(CLI::Range(0.0, 0.9));
        command
            .add_option("--ayasugi", a.ayasugi.wavelength,
                        "length of the waves of the grain, places (default: 0, none)")
            ->check(CLI::Range(0.0, 16384.0));
        command
            .add_option("--amplitude", a.ayasugi.amplitude, "of these waves, places (default: 40)")
            ->check(CLI::Range(0.0, 2048.0));
        command
            .add_option("--depth", a.ayasugi.depth,
                        "share of their amplitude that is filed off (default: 0)")
            ->check(CLI::Range(0.0, 1.0));
        command.add_flag("--twisted", a.ayasugi.twisted, "by a twist instead of filed grooves");
        command
            .add_option("--texture", a.texture_px,
                        "pixels of the pictures along the blade (default: 4096)")
            ->check(CLI::Range(64, 16384));
        command.add_option("--seed", a.seed, "of the steel (default: of the file, or 0)");
        add_out(command, a, "folder to write (default: blade)");
      });
}

}  // namespace hada
