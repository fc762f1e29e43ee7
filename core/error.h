#pragma once

#include <stdexcept>
#include <string>

namespace hada {

/// The work cannot go on. The text is one sentence for a person: what, where, and what to do.
///
/// Thrown by any room, caught once, in `main`, which prints it and exits with code 2. Work that
/// went on but went badly is not an Error: it is data in the result.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace hada
