// Whether a file is a model or a study, by tables that only one of them has; the wrong one is refused with the right command.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/text/toml_reader.h"
#include "wythe/parts/error.h"

namespace wythe::io {

std::string beside(const std::string& file, const std::string& other) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  return (folder / other).string();
}

// Tables that no model has.
bool has_study(const toml::table& root) {
  const auto has = [&](const char* part) { return root.contains(part); };
  constexpr const char* kNoModelHas[] = {"study",   "variable",    "dependent",  "correlation",
                                         "shaking", "limit_state", "record_text"};
  return std::any_of(std::begin(kNoModelHas), std::end(kNoModelHas), has);
}

namespace {

// Tables that no study has.
bool has_model(const toml::table& root) {
  const auto has = [&](const char* part) { return root.contains(part); };
  constexpr const char* kNoStudyHas[] = {"wall",    "stage",     "material",
                                         "masonry", "plan_wall", "slab"};
  return std::any_of(std::begin(kNoStudyHas), std::end(kNoStudyHas), has);
}

}  // namespace

void refuse_study(const toml::table& root, const std::string& file) {
  if (!has_study(root) || has_model(root)) return;
  const auto base = root["study"]["model"].value<std::string>();
  throw InputError(
      {{.file = file,
        .problem = "is a study, and a model is asked for",
        .cure = fmt::format("name its model{}; a study runs by wythe campaign STUDY.toml "
                            "--out DIR",
                            base ? ", " + beside(file, *base) : "")}});
}

void refuse_model(const toml::table& root, const std::string& file) {
  if (has_study(root) || !has_model(root)) return;
  throw InputError({{.file = file,
                     .problem = "is a model, and a study is asked for",
                     .cure = "one wall runs by wythe run MODEL.toml --out DIR; wythe new study DIR "
                             "writes a study to start from"}});
}

}  // namespace wythe::io
