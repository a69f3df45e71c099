// Files of examples/, embedded in the program (cmake/embed.cmake).
#pragma once

#include <string_view>

namespace wythe::io {

extern const std::string_view kPierModel, kPierStudy, kPortalModel, kFacadeModel, kArchModel,
    kBeforeModel, kAfterModel, kNetBefore, kNetAfter;

}  // namespace wythe::io
