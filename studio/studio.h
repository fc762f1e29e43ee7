#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/terminal.h"

namespace hada {

class Commands;

struct StudioArguments {
  std::filesystem::path folder = ".";
  int port = 0;  // 0: any that is free
  bool no_browser = false;
  std::string program = "/proc/self/exe";  // that does heavy work: this one
};

/// The page and what it asks for, on this machine alone.
class Studio {
 public:
  /// throws  Error if the folder is missing or the port is taken
  explicit Studio(const StudioArguments& arguments);
  ~Studio();
  /// Where the page is: "http://127.0.0.1:8765/token/".
  std::string address() const;
  /// Answers until `stop` is called.
  void serve();
  void stop();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Opens the studio on a folder until it is interrupted.
void studio_command(const StudioArguments& arguments, const Terminal& terminal);

/// Declares `hada studio`.
void add_studio(Commands& commands);

}  // namespace hada
