#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/terminal.h"

namespace hada {

struct FoldCheckArguments {
  std::filesystem::path input;
};

/// Says which vertices of a crease pattern cannot be folded flat, and whether its layers block each
/// other.
void fold_check_command(const FoldCheckArguments& arguments, const Terminal& terminal);

struct FoldFlatArguments {
  std::filesystem::path input;
  std::filesystem::path out = "flat.fold";
};

/// Writes where a crease pattern lies once it is folded flat, with one order of its layers.
void fold_flat_command(const FoldFlatArguments& arguments, const Terminal& terminal);

struct FoldStatesArguments {
  std::filesystem::path input;
  std::optional<std::filesystem::path> out;
  std::vector<std::string> chosen;  // "3>7": face 3 lies above face 7
};

/// Counts the layer orders of a crease pattern.
void fold_states_command(const FoldStatesArguments& arguments, const Terminal& terminal);

struct FoldConvertArguments {
  std::filesystem::path input;
  std::filesystem::path out;
  std::optional<double> thickness;
};

/// Writes a crease pattern or a folded form of any known format as another.
void fold_convert_command(const FoldConvertArguments& arguments, const Terminal& terminal);

}  // namespace hada
