// The start of `wythe run`, from a model or a checkpoint, and the checkpoints that it writes.
#pragma once

#include <chrono>
#include <string>

#include "commands.h"
#include "wythe/io.h"
#include "wythe/solve.h"

namespace wythe::app {

struct RunStart {
  Checkpoint from = {};  // at rest, unless the run is resumed
  std::string out = {};  // folder of the results
  bool is_resumed = false;
  [[nodiscard]] bool has_checkpoints() const { return from.order.every > 0; }
};
// Throws InputError where options conflict, or the model or the checkpoint is not usable.
[[nodiscard]] RunStart start_of(const RunArguments& arguments);

// Writes the checkpoint of a run whenever it is due.
class CheckpointWriter {
 public:
  CheckpointWriter(const RunStart& start, Replacement& results);
  // For SolveOptions::checkpoint.
  void operator()(const State& state, const RunRecord& record, bool ends);

 private:
  using Clock = std::chrono::steady_clock;
  const RunStart& start_;
  Replacement& results_;
  Clock::time_point last_ = Clock::now();
  int written_ = 0;
};

}  // namespace wythe::app
