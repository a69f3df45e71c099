// A batch: rows of inputs in, answers out, all in memory. For optimisers, surrogate models and samplers that
// call a model a thousand times from another program.
//
//   model.toml + columns {path, unit} + rows ──► run_batch() ──► one SampleRecord a row
//
// A row is the base model with settings, exactly as a sample of a campaign: walls are solved side by side in
// lanes on all cores, and the bits of a row depend on nothing but the model and its numbers.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/study.h"

namespace wythe {

// One input of a batch: a key of the model and the unit in which its numbers are given.
struct BatchColumn {
  std::string path;  // "material.joint.cohesion"
  std::string unit;  // "MPa"; "1": a bare number, "": as the model file writes it without a unit
};

struct BatchSpec {
  std::string model_text, model_file;  // TOML; name for messages and relative paths
  std::vector<std::string> settings;   // "path=value", for all rows
  std::vector<BatchColumn> columns;
  std::vector<std::vector<double>> rows;  // (n_row, n_column), in the units of the columns
  std::vector<double> states;             // displacements at which states are kept in the run [m]
  double read_modes_at = kUnset;          // displacement at which failure modes are named [m]
  int jobs = 0;                           // workers; 0: one a core
};

// Answers in the order of the rows. A row whose inputs are not admissible has the status "refused" and says
// why; rows that had not ended when `stop` was set have the status "". `progress` is called with the number
// of rows done and of all, never two calls at once. Throws InputError with every fault of the columns, of the
// numbers that are not finite, and of the base model itself.
[[nodiscard]] std::vector<SampleRecord> run_batch(
    const BatchSpec& batch, const std::atomic<bool>* stop = nullptr,
    const std::function<void(int done, int total)>& progress = {});

}  // namespace wythe
