// Stored states of the samples of one campaign, with its store open all the while: to open it for each sample costs as
// much as to run a tiny one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wythe/result.h"

namespace wythe {

class StoredStates {
 public:
  // InputError where the folder holds no campaign, IoError where its store is damaged.
  explicit StoredStates(const std::string& folder);
  ~StoredStates();
  StoredStates(const StoredStates&) = delete;
  StoredStates& operator=(const StoredStates&) = delete;
  // As read_states (wythe/campaign.h): of one sample (1-based), `model` being its wall.
  [[nodiscard]] std::vector<Snapshot> of(int sample, const Model& model);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace wythe
