// limit_data(): what the page of a limit analysis shows. Its numbers are those of mechanisms.json.
#include <nlohmann/json.hpp>

#include "report/bundle.h"
#include "report/model_inputs.h"
#include "report/wall_arrays.h"
#include "wythe/io.h"
#include "wythe/provenance.h"
#include "wythe/report.h"

namespace wythe {

std::string limit_data(const ModelSpec& spec, const Model& model,
                       const std::string& mechanisms_json) {
  using namespace report;
  Bundle bundle;
  bundle.header["kind"] = "limit";
  bundle.header["title"] = spec.name;
  bundle.header["note"] = spec.note;
  bundle.header["opinion"] = Json::parse(mechanisms_json);
  bundle.header["inputs"] = model_inputs(spec, model);
  bundle.header["model_text"] = write_model(spec);
  const Provenance made = provenance();
  bundle.header["provenance"] = {{"version", made.version},
                                 {"commit", made.commit},
                                 {"compiler", made.compiler},
                                 {"flags", made.flags}};
  add_wall(bundle, model);
  return bundle.packed();
}

}  // namespace wythe
