// The starters: files of examples/ within the program.
#include "io/model/starters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "core/files.h"
#include "wythe/parts/error.h"
#include "wythe/parts/starter.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;

struct StarterFile {
  const char* kind;
  const char* name;
  const std::string_view& text;
};
// For each kind, the file to run comes first, then the files that it needs.
constexpr std::array kFiles = {StarterFile{"pier", "model.toml", io::kPierModel},
                               StarterFile{"portal", "model.toml", io::kPortalModel},
                               StarterFile{"facade", "model.toml", io::kFacadeModel},
                               StarterFile{"arch", "model.toml", io::kArchModel},
                               StarterFile{"opening", "before.toml", io::kBeforeModel},
                               StarterFile{"opening", "after.toml", io::kAfterModel},
                               StarterFile{"strengthening", "before.toml", io::kNetBefore},
                               StarterFile{"strengthening", "after.toml", io::kNetAfter},
                               StarterFile{"study", "study.toml", io::kPierStudy},
                               StarterFile{"study", "model.toml", io::kPierModel}};

void refuse_present(const fs::path& file) {
  std::error_code error;
  if (fs::symlink_status(file, error).type() == fs::file_type::not_found) return;
  throw InputError({{.file = file.string(),
                     .problem = "is there already; a starter replaces nothing",
                     .cure = "name a new folder, or remove the file"}});
}

}  // namespace

std::vector<std::string> starter_kinds() {
  std::vector<std::string> kinds;
  for (const StarterFile& file : kFiles)
    if (kinds.empty() || kinds.back() != file.kind) kinds.emplace_back(file.kind);
  return kinds;
}

std::vector<std::string> write_starter(const std::string& kind, const std::string& folder) {
  const std::vector<std::string> kinds = starter_kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw InputError({{.value = kind,
                       .problem = "is no starter",
                       .cure = fmt::format("write one of: {}", fmt::join(kinds, ", "))}});
  for (const StarterFile& file : kFiles)
    if (file.kind == kind) refuse_present(fs::path(folder) / file.name);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(fmt::format("{}: cannot be made: {}", folder, error.message()));
  std::vector<std::string> written;
  for (const StarterFile& file : kFiles) {
    if (file.kind != kind) continue;
    written.push_back((fs::path(folder) / file.name).string());
    write_file(written.back(), file.text);
  }
  return written;
}

}  // namespace wythe
