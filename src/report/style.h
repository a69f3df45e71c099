// Style of the SVG pictures: colours for light and dark, safe for colour-blind readers (Okabe and Ito 2008).
#pragma once

#include <string>

namespace wythe::report {

[[nodiscard]] std::string picture_style();

}  // namespace wythe::report
