#pragma once

#include <string>

namespace hada {

/// How the program speaks to the person who started it.
class Terminal {
 public:
  struct Manner {
    bool quiet = false;  // only errors, and JSON that was asked for
    bool json = false;   // the result as JSON on standard output, and nothing else
  };

  explicit Terminal(Manner manner) : manner_(manner) {}
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// One line of the result for a person: silent where quiet or JSON was asked for.
  void say(const std::string& line) const;

  /// The result for a program: silent unless JSON was asked for.
  void result(const std::string& json) const;

  /// What is being done now, on one line that the next step replaces. Only on a terminal.
  void step(const std::string& doing) const;

 private:
  void clear_step() const;
  Manner manner_;
  mutable bool step_shown_ = false;
};

}  // namespace hada
