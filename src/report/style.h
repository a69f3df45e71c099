// The style sheets: colours for light and dark, safe for colour-blind readers (Okabe and Ito 2008).
#pragma once

#include <string>

namespace wythe::report {

[[nodiscard]] std::string picture_style();  // of the SVG pictures, also inside a lone SVG
[[nodiscard]] std::string page_style();     // of report.html, without the pictures'

}  // namespace wythe::report
