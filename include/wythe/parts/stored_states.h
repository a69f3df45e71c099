// Reads what a page needs of a store: the results of all samples in little memory, and their states one by one. The store
// stays open for these, since opening it for each sample costs as much as a tiny run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/result.h"

namespace wythe {

// Reads a campaign for samples.csv, statistics.json and report.html: read_campaign() (wythe/parts/campaign.h) without features, events,
// energies, provenance of each sample, and evidence, scores and elements of failure modes (elements stay where an assessment needs them).
// So 100 000 small samples fit into 1 GiB. Throws InputError and IoError as read_campaign() does.
[[nodiscard]] Campaign read_answers(const std::string& folder);

class StoredStates {
 public:
  // Throws InputError where the folder holds no campaign, IoError where its store is damaged.
  explicit StoredStates(const std::string& folder);
  ~StoredStates();
  StoredStates(const StoredStates&) = delete;
  StoredStates& operator=(const StoredStates&) = delete;
  // The states of one sample (1-based), as read_states() (wythe/parts/campaign.h) gives them; `model` is its wall.
  [[nodiscard]] std::vector<Snapshot> of(int sample, const Model& model);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace wythe
