# Script: writes OUTPUT, a C++ file that holds files of SOURCE as raw strings (src/report/assets.h, src/core/messages.h,
# src/io/model/starters.h).
set(source "// Written by cmake/embed.cmake.
#include \"core/messages.h\"
#include \"io/model/starters.h\"
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
embed(kMessagesJson src/core/messages.json)
embed(report::kViewerHtml src/report/assets/viewer.html)
embed(report::kTextsJson src/report/assets/texts.json)
embed(io::kPierModel examples/brick_pier/model.toml)
embed(io::kPierStudy examples/brick_pier/study.toml)
embed(io::kPortalModel examples/brick_portal/model.toml)
embed(io::kFacadeModel examples/brick_facade/model.toml)
embed(io::kArchModel examples/arch/model.toml)
embed(io::kBeforeModel examples/opening/before.toml)
embed(io::kAfterModel examples/opening/after.toml)
embed(io::kNetBefore examples/strengthening/before.toml)
embed(io::kNetAfter examples/strengthening/after.toml)
file(WRITE "${OUTPUT}" "${source}}  // namespace wythe\n")
