// What a page takes of a store: the answers of all samples in little memory, and their states one by one with the
// store open all the while, since to open it for each sample costs as much as to run a tiny one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/result.h"

namespace wythe {

// A campaign as samples.csv, statistics.json and report.html need it: read_campaign (wythe/parts/campaign.h) without
// features, events, energies, the program that ran each sample, and evidence and scores of failure modes (their elements
// too, where no assessment asks for them): a part of the memory, so that 100 000 small samples fit into 1 GiB. InputError and IoError as there.
[[nodiscard]] Campaign read_answers(const std::string& folder);

class StoredStates {
 public:
  // InputError where the folder holds no campaign, IoError where its store is damaged.
  explicit StoredStates(const std::string& folder);
  ~StoredStates();
  StoredStates(const StoredStates&) = delete;
  StoredStates& operator=(const StoredStates&) = delete;
  // As read_states (wythe/parts/campaign.h): of one sample (1-based), `model` being its wall.
  [[nodiscard]] std::vector<Snapshot> of(int sample, const Model& model);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace wythe
