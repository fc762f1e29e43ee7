#pragma once

#include <filesystem>
#include <string>

#include "sheet/fold_log.h"

namespace hada {

/// The log of folds in a file of kind fold_log/1.
/// throws  Error naming the file and the step
FoldLog read_fold_log(const std::filesystem::path& path);

/// The log in a text that came another way, and one of its steps; `where` names it in errors.
FoldLog fold_log_of(const std::string& text, const std::string& where);
FoldStep fold_step_of(const std::string& text, const std::string& where);

/// The text of such a file.
std::string fold_log_text(const FoldLog& log);

}  // namespace hada
