// Files of src/report/assets as they are in the program (cmake/embed.cmake).
#pragma once

#include <string_view>

namespace wythe::report {

extern const std::string_view kViewerHtml;  // what `make web` builds
extern const std::string_view kTextsJson;

}  // namespace wythe::report
