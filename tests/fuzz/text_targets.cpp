// Models, settings, studies, laws, paths, measured values, records.
#include <numeric>

#include "fuzz/model_texts.h"
#include "fuzz/targets.h"
#include "wythe/parts/io.h"

namespace wythe::fuzz {
namespace {

std::string beside() { return (scratch() / "model.toml").string(); }

void read_model_text(const std::string& bytes) {
  static_cast<void>(compile(parse_model(bytes, beside())));
}

void read_setting(const std::string& bytes) {
  static_cast<void>(parse_model(kWall, beside(), {bytes}));
}

void read_study_text(const std::string& bytes) {
  static const std::string kFiles =
      put("model.toml", kWall) + put("values.csv", "ft_MPa\n0.1\n0.2\n");
  const StudySpec study = parse_study(bytes, (scratch() / "study.toml").string());
  const auto samples = std::accumulate(study.batch.begin(), study.batch.end(), 0LL);
  if (samples <= 64) static_cast<void>(draw_samples(study));
}

void read_law_text(const std::string& bytes) {
  static_cast<void>(read_law(put("law.toml", bytes)));
}

void read_path(const std::string& bytes) {
  static_cast<void>(read_contact_path(put("path.csv", bytes)));
}

void parse_values(const std::string& bytes) {
  put("model.toml", kWall);
  put("measured.csv", bytes);
  static_cast<void>(parse_study(kMeasured, (scratch() / "study.toml").string()));
}

void parse_record(const std::string& name, const std::string& bytes) {
  put(name, bytes);
  static_cast<void>(compile(parse_model(
      kWall + "[[stage]]\nname = \"quake\"\nrecord = { file = \"" + name + "\", unit = \"g\" }\n",
      beside())));
}
void read_csv_record(const std::string& bytes) { parse_record("record.csv", bytes); }
void read_at2_record(const std::string& bytes) { parse_record("record.AT2", bytes); }

}  // namespace

std::vector<Target> text_targets() {
  return {{"model", read_model_text},      {"set", read_setting},
          {"study", read_study_text},      {"law", read_law_text},
          {"path_csv", read_path},         {"values_csv", parse_values},
          {"record_csv", read_csv_record}, {"record_at2", read_at2_record}};
}

}  // namespace wythe::fuzz
