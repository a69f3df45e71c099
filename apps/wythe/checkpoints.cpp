// A run begins at rest, or with the state and the rows of a checkpoint. New checkpoints are written at an interval
// of time. Each is written beside the last one before it takes its place.
#include "checkpoints.h"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "campaign_commands.h"
#include "interrupt.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/spec.h"

namespace wythe::app {
namespace {

double seconds_between(const std::string& text) {
  double seconds = 0;
  try {
    seconds = parse_quantity(text, "s");
  } catch (const std::invalid_argument& error) {
    refuse("--checkpoint", text, error.what(), "write e.g. --checkpoint \"60 s\"");
  }
  if (!(seconds > 0) || !std::isfinite(seconds))
    refuse("--checkpoint", text, "is no time between checkpoints",
           "write e.g. --checkpoint \"60 s\"");
  return seconds;
}

RunStart resumed(const RunArguments& a) {
  if (!a.out.empty())
    refuse("--out", a.out, "does not go with --resume: results are put where the checkpoint is",
           "leave it out");
  if (a.model.empty() && !a.overrides.empty())
    refuse("--set", a.overrides.front(), "would change the run that is resumed", "leave it out");
  finish_replacement(a.resume);
  RunStart start{.from = read_checkpoint(a.resume), .out = a.resume, .is_resumed = true};
  if (!a.model.empty() && spec_hash(read_model(a.model, a.overrides)) != start.from.model.spec_hash)
    refuse(a.resume + "/" + kCheckpointFile, "",
           fmt::format("is of another model than {}", a.model),
           "leave the model out to go on with the one in the checkpoint, or start a new run in "
           "another folder");
  if (!a.language.empty()) start.from.order.language = a.language;
  return start;
}

RunStart begun(const RunArguments& a) {
  if (a.model.empty() || a.out.empty())
    refuse(a.model.empty() ? "MODEL.toml" : "--out", "", "is missing",
           "write wythe run MODEL.toml --out DIR, or wythe run --resume DIR");
  RunStart start{.out = a.out};
  Checkpoint& from = start.from;
  from.spec = read_model(a.model, a.overrides);
  from.model = compile(from.spec);
  from.model.spec_hash = spec_hash(from.spec);
  from.state = initial_state(from.model);
  from.order = order_of(from.spec, a.model);
  from.order.language = a.language.empty() ? "en" : a.language;
  return start;
}

}  // namespace

RunStart start_of(const RunArguments& a) {
  const double every = a.checkpoint.empty() ? 0 : seconds_between(a.checkpoint);
  if (!a.language.empty()) check_language(a.language);
  RunStart start = a.resume.empty() ? begun(a) : resumed(a);
  if (every > 0) start.from.order.every = every;
  return start;
}

CheckpointWriter::CheckpointWriter(const RunStart& start, Replacement& results)
    : start_(start), results_(results) {}

// A failed write must not end a long run, because the last good checkpoint stays. At the
// end the checkpoint goes into the folder with the results and replaces the last one.
void CheckpointWriter::operator()(const State& state, const RunRecord& record, bool ends) {
  const auto since = std::chrono::duration<double>(Clock::now() - last_).count();
  if (!ends && since < start_.from.order.every) return;
  const std::string bytes = checkpoint_bytes(start_.from.order, start_.from.model, state, record);
  if (ends) return write_text(results_.path() + "/" + kCheckpointFile, bytes);
  try {
    const std::string number = std::to_string(++written_);
    results_.put(kCheckpointFile, bytes, [&](const char* point) {
      hold_for_test(fmt::format("checkpoint {} {}", number, point));
    });
  } catch (const std::runtime_error& error) {  // IoError, InputError
    fmt::print(stderr, "warning: {}; the run goes on, the checkpoint before stands\n",
               readable(error.what()));
  }
  last_ = Clock::now();
}

}  // namespace wythe::app
