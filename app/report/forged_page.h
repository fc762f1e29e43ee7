#pragma once

#include <string>

#include "fit/forged.h"

namespace hada {

/// How a picture of forged steel is explained: the picture and a new piece of the same steel, the
/// spectrum measured and fitted, and the sequences of folds with their probabilities. One page of
/// HTML that needs nothing else.
///
/// name  of the picture
std::string forged_page(const std::string& name, const Surface& surface, const ForgedFit& fit);

}  // namespace hada
