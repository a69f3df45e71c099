// limit_data(): the data for the page of a limit analysis. Its numbers are those of mechanisms.json.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/decimal_point.h"
#include "report/bundle.h"
#include "report/model_inputs.h"
#include "report/translation.h"
#include "report/wall_arrays.h"
#include "wythe/parts/io.h"
#include "wythe/parts/provenance.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

// Pages are passed on, so of the compared folder only its own name is kept, also in notes.
void drop_compared_folder(report::Json& opinion) {
  report::Json& comparison = opinion["comparison"];
  if (!comparison.is_object()) return;
  const std::string with = comparison.value("with", "");
  std::filesystem::path path(with);
  if (!path.has_filename()) path = path.parent_path();  // "out/run/"
  const std::string name = path.filename().string();
  if (name.empty() || name == with) return;
  comparison["with"] = name;
  for (report::Json& note : opinion["notes_message"])
    if (note.is_object() && note["arguments"].contains("with")) note["arguments"]["with"] = name;
}

}  // namespace

std::string limit_data(const ModelSpec& spec, const Model& model,
                       const std::string& mechanisms_json) {
  using namespace report;
  Bundle bundle;
  bundle.header["kind"] = "limit";
  bundle.header["title"] = spec.name;
  bundle.header["note"] = spec.note;
  const DecimalPoint point;
  bundle.header["opinion"] = Json::parse(mechanisms_json);
  drop_compared_folder(bundle.header["opinion"]);
  translate_messages(bundle.header["opinion"]);
  bundle.header["inputs"] = model_inputs(spec, model);
  bundle.header["model_text"] = write_model(spec);
  const Provenance made = provenance();
  bundle.header["provenance"] = {{"version", made.version},
                                 {"commit", made.commit},
                                 {"compiler", made.compiler},
                                 {"flags", made.flags}};
  add_wall(bundle, model);
  add_fields(bundle, spec, model);
  return bundle.packed();
}

}  // namespace wythe
