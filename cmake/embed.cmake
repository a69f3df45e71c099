# Script: writes OUTPUT, a C++ file that holds files of SOURCE as raw strings (src/report/assets.h, src/core/messages.h).
set(source "// Written by cmake/embed.cmake.
#include \"core/messages.h\"
#include \"report/assets.h\"

namespace wythe {
")
function(embed name file)
  file(READ "${SOURCE}/${file}" text)
  string(FIND "${text}" ")wythe_asset\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${file} holds the end mark of a raw string")
  endif()
  set(source "${source}const std::string_view ${name} = R\"wythe_asset(${text})wythe_asset\";\n" PARENT_SCOPE)
endfunction()
embed(kMessagesJson core/messages.json)
embed(report::kViewerHtml report/assets/viewer.html)
embed(report::kTextsJson report/assets/texts.json)
file(WRITE "${OUTPUT}" "${source}}  // namespace wythe\n")
