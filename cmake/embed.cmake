# Script: writes OUTPUT, a C++ file that holds the files of ASSETS as raw strings (src/report/assets.h).
set(source "// Written by cmake/embed.cmake.
#include \"report/assets.h\"

namespace wythe::report {
")
function(embed name file)
  file(READ "${ASSETS}/${file}" text)
  string(FIND "${text}" ")wythe_asset\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${file} holds the end mark of a raw string")
  endif()
  set(source "${source}const std::string_view ${name} = R\"wythe_asset(${text})wythe_asset\";\n" PARENT_SCOPE)
endfunction()
embed(kViewerHtml viewer.html)
embed(kTextsJson texts.json)
file(WRITE "${OUTPUT}" "${source}}  // namespace wythe::report\n")
