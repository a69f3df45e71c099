// A batch: rows of inputs give rows of results, all in memory. It serves optimisers, surrogate models and samplers that
// evaluate a model a thousand times from another program.
//
//   model.toml + columns {path, unit} + rows ──► run_batch() ──► one SampleRecord a row
//
// A row is the base model with settings, exactly as a sample of a campaign. All cores solve walls side by side in
// lanes; the bits of a row depend only on the model and the numbers of the row.
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
  std::string unit;  // "MPa"; "1": a bare number, "": the unit of a bare number in the file
};

struct BatchSpec {
  std::string model_text, model_file;  // TOML; name for messages, folder for relative paths
  std::vector<std::string> settings;   // "path=value", for all rows
  std::vector<BatchColumn> columns;
  std::vector<std::vector<double>> rows;  // (n_row, n_column), in the units of the columns
  std::vector<double> states;             // displacements at which states are stored [m]
  double read_modes_at = kUnset;          // displacement at which failure modes are named [m]
  int jobs = 0;                           // workers; 0: one for each core
};

// Returns records in the order of the rows. A row with inadmissible inputs has the status "refused" with its
// reason; a row that had not ended when `stop` was set has the status "". `progress` gets the numbers of rows
// done and of all rows, never in two threads at once. Throws InputError with every fault of the columns, of
// numbers that are not finite, and of the base model.
[[nodiscard]] std::vector<SampleRecord> run_batch(
    const BatchSpec& batch, const std::atomic<bool>* stop = nullptr,
    const std::function<void(int done, int total)>& progress = {});

}  // namespace wythe
