#pragma once

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/command_line.h"
#include "app/files.h"

/// The only header that includes CLI11; included by the sources that declare commands.
namespace hada {

/// Accepts finite numbers greater than 0.
inline CLI::Validator positive() {
  return CLI::Validator(
      [](std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        return *end == '\0' && value > 0.0 && std::isfinite(value)
                   ? std::string()
                   : text + " is not a number greater than 0";
      },
      "");
}

/// The commands of the program while they are declared.
class Commands {
 public:
  explicit Commands(Request& request) : request_(request) {
    app_.set_version_flag("--version", "hada " + version());
    app_.footer("Example:\n  hada demo -o out/demo");
    app_.require_subcommand(1);
    add_common(app_);
  }

  CLI::App& app() { return app_; }

  // A command that runs `work` with its `Arguments`; `declare` says which words fill them.
  template <class Arguments, class Declare>
  void add(const std::string& name, const std::string& summary, const std::string& example,
           void (*work)(const Arguments&, const Terminal&), const Declare& declare) {
    add_to(app_, name, summary, example, work, declare);
  }

  // A command that only holds others.
  CLI::App& group(const std::string& name, const std::string& summary, const std::string& example) {
    CLI::App& command = *app_.add_subcommand(name, summary);
    command.footer("Example:\n  " + example);
    command.require_subcommand(1);
    return command;
  }

  // The same within a group.
  template <class Arguments, class Declare>
  void add_to(CLI::App& parent, const std::string& name, const std::string& summary,
              const std::string& example, void (*work)(const Arguments&, const Terminal&),
              const Declare& declare) {
    CLI::App& command = *parent.add_subcommand(name, summary);
    command.footer("Example:\n  " + example);
    const auto arguments = std::make_shared<Arguments>();
    declare(command, *arguments);
    add_common(command);
    command.callback([this, work, arguments] {
      request_.work = [work, arguments](const Terminal& terminal) { work(*arguments, terminal); };
    });
  }

 private:
  void add_common(CLI::App& command) {
    command.add_option("--threads", request_.threads, "use N threads (default: all cores)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command.add_flag("--quiet", request_.manner.quiet, "print errors only");
    command.add_flag("--json", request_.manner.json, "print the result as JSON");
  }

  Request& request_;
  CLI::App app_{
      "hada measures a real surface, finds the material that explains it, and makes more "
      "of it.",
      "hada"};
};

template <class Arguments>
CLI::Option* add_out(CLI::App& command, Arguments& a, const std::string& words) {
  return command.add_option("-o,--out", a.out, words);
}

inline constexpr const char* input_words = "surface folder, height map or picture";

template <class Arguments>
void add_capture(CLI::App& command, Arguments& a) {
  command.add_option("capture", a.capture, "folder of pictures, one light each")->required();
}

template <class Arguments>
void add_pitch(CLI::App& command, Arguments& a) {
  command.add_option("--pitch", a.pitch_mm, "distance between pixels, mm")
      ->check(positive())
      ->type_name("MM");
}

template <class Arguments>
void add_lights(CLI::App& command, Arguments& a) {
  command.add_option("--lights", a.lights,
                     "lights file (.json or .lp) to use instead of the spheres");
}

/// Photographs, and what may be known of them.
template <class Arguments>
void add_photographs(CLI::App& command, Arguments& a) {
  add_capture(command, a);
  add_lights(command, a);
  add_pitch(command, a);
}

/// A surface, and its pitch.
template <class Arguments>
void add_surface(CLI::App& command, Arguments& a) {
  command.add_option("input", a.input, input_words)->required();
  add_pitch(command, a);
}

/// Declares the commands from photographs to numbers: calibrate, reconstruct, integrate, measure,
/// classify, compare.
void add_measuring(Commands& commands);

/// Declares `hada fold` and what it can do.
void add_folding(Commands& commands);

/// Declares `hada knit` and what it can do.
void add_knitting(Commands& commands);

/// Declares `hada block`.
void add_wood(Commands& commands);

/// Declares `hada blade`.
void add_steel(Commands& commands);

}  // namespace hada
