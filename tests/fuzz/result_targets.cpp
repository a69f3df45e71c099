// Data of a report, checkpoints, stores.
#include <zlib.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "core/hash.h"
#include "fuzz/model_texts.h"
#include "fuzz/targets.h"
#include "scenes/changed_store.h"
#include "scenes/places.h"
#include "wythe/parts/checkpoint.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/report.h"
#include "wythe/parts/statistics.h"

namespace wythe::fuzz {
namespace {

namespace fs = std::filesystem;

// Packed data as they are; any other text as the header of data without arrays.
void read_report(const std::string& bytes) {
  if (bytes.starts_with("\x78")) {
    static_cast<void>(report_page(bytes));
    return;
  }
  const auto length = static_cast<std::uint32_t>(bytes.size());
  std::string whole("WYTHE\0\0\2", 8);
  whole.append(reinterpret_cast<const char*>(&length), sizeof length);
  whole += bytes;
  uLongf size = compressBound(whole.size());
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
            reinterpret_cast<const Bytef*>(whole.data()), whole.size(), 1);
  packed.resize(size);
  static_cast<void>(report_page(packed));
}

// A checkpoint of a small wall, and how it is made of its content: with a head that fits.
struct CheckpointHead {
  char magic[16];
  std::uint32_t format, program_bytes;
  std::uint64_t content_bytes, model, others;
};

const std::string& small_checkpoint() {
  static const std::string kBytes = [] {
    const ModelSpec spec = parse_model(kWall, "model.toml");
    Model model = compile(spec);
    model.spec_hash = spec_hash(spec);
    return checkpoint_bytes(order_of(spec, "model.toml"), model, initial_state(model), {});
  }();
  return kBytes;
}

// Places of 4 bytes and the byte to put there, in the content of the small checkpoint; then, or else, the content itself.
void read_checkpoint_content(const std::string& bytes) {
  CheckpointHead head;
  std::memcpy(&head, small_checkpoint().data(), sizeof head);
  std::string content = small_checkpoint().substr(sizeof head + head.program_bytes);
  if (bytes.starts_with("content:")) {
    content = bytes.substr(8);
  } else {
    for (std::size_t at = 0; at + 5 <= bytes.size(); at += 5) {
      std::uint32_t place = 0;
      std::memcpy(&place, bytes.data() + at, sizeof place);
      content[place % content.size()] = bytes[at + 4];
    }
  }
  const std::string rest = small_checkpoint().substr(sizeof head, head.program_bytes) + content;
  head.content_bytes = content.size();
  head.others = 0;
  Hash hash;
  hash.add(&head, sizeof head);
  hash.add(std::string_view(rest));
  head.others = hash.value();
  put("checkpoint.wythe", std::string(reinterpret_cast<const char*>(&head), sizeof head) + rest);
  static_cast<void>(read_checkpoint(scratch().string()));
}

// All that `wythe report` and `wythe store check` make of a store.
void use_store(const std::string& folder) {
  const Campaign campaign = read_campaign(folder);
  const Statistics statistics = statistics_of(campaign);
  const SampleWalls walls = {
      .build = model_builder(campaign.study),
      .states = [&](int sample, const Model& model) { return read_states(folder, sample, model); }};
  static_cast<void>(samples_csv(campaign) + statistics_json(statistics) +
                    campaign_data(campaign, statistics, walls));
  static_cast<void>(campaign_progress(folder));
  check_campaign(folder);
}

// Tables and columns of the small store, to be changed by number.
std::vector<std::pair<std::string, std::string>> columns_of(study::Database& database) {
  std::vector<std::pair<std::string, std::string>> columns;
  study::Statement all(database,
                       "SELECT t.name, c.name FROM sqlite_schema t, pragma_table_info(t.name) c "
                       "WHERE t.type = 'table' ORDER BY t.name, c.cid");
  while (all.step()) {
    std::string table = all.text();
    columns.emplace_back(std::move(table), all.text());
  }
  return columns;
}

// Each edit: column (2 bytes), kind of value, then 8 bytes.
void edit(study::Database& database, const std::string& bytes) {
  const auto columns = columns_of(database);
  database.execute("PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY");
  for (std::size_t at = 0; at + 11 <= bytes.size(); at += 11) {
    std::uint16_t which = 0;
    std::int64_t value = 0;
    double number = 0;
    std::memcpy(&which, bytes.data() + at, sizeof which);
    std::memcpy(&value, bytes.data() + at + 3, sizeof value);
    std::memcpy(&number, bytes.data() + at + 3, sizeof number);
    const auto& [table, column] = columns[which % columns.size()];
    study::Statement update(database, "UPDATE OR IGNORE " + table + " SET " + column + " = ?");
    switch (bytes[at + 2] & 7) {
      case 0: update.run(value); break;
      case 1: update.run(number); break;
      case 2: update.run(std::string_view(bytes).substr(at + 3, 8)); break;
      case 3: update.run(study::Bytes{std::string_view(bytes).substr(at + 3)}); break;
      case 4: update.bind_null(), update.run(); break;
      default: update.run(value & 7); break;
    }
  }
}

// The small store is of `wythe campaign tests/fuzz/store/study.toml`, in pages of 512 bytes (SQLite: VACUUM). Make it anew
// when what a store holds has changed: the test of the corpus says so.
void read_store(const std::string& bytes) {
  static const std::string kSmall = [] {
    std::ifstream file(source_dir() + "/tests/data/store.db", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }();
  const fs::path folder = scratch() / "campaign";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const bool whole = bytes.starts_with("SQLite format 3");
  put("campaign/campaign.db", whole ? bytes : kSmall);
  if (!whole) {
    try {
      study::Database database(folder / "campaign.db", study::Database::Access::kWrite);
      edit(database, bytes);
    } catch (const IoError&) {
      return;  // SQLite itself forbids it
    }
    scenes::renew_checksums(folder.string());
  }
  use_store(folder.string());
}

}  // namespace

std::vector<Target> result_targets() {
  return {{"report", read_report}, {"checkpoint", read_checkpoint_content}, {"store", read_store}};
}

}  // namespace wythe::fuzz
