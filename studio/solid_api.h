#pragma once

#include <mutex>
#include <string>

#include "studio/http.h"

namespace hada {

/// What may be asked of materials that are worn or forged into something: "api/solid/..." of
/// docs/studio.md.
class SolidApi {
 public:
  /// throws  Error in one sentence if it cannot be done
  HttpResponse answer(const std::string& verb, const HttpRequest& request);

 private:
  std::mutex busy_;  // one is made at a time
};

}  // namespace hada
