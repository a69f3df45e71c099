// Errors by cause (docs/architecture.md). Wrong input: InputError with all faults at
// once. A problem of the machine or file system: IoError. A failure of the computation:
// SolveStatus in Result, never an exception.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace wythe {

// One fault of the input: its place, the value read, the problem and the cure.
struct Fault {
  std::string file = {};   // file name, or "--set" for an override
  std::string path = {};   // dotted key path, e.g. "wall.opening.0.width"
  std::string value = {};  // the value as read, empty when missing
  std::string problem;     // what is wrong, in one clause
  std::string cure = {};   // what to write instead, may be empty
  int line = 0;            // line in `file`, 0 when unknown
};

// "model.toml:12: wall.length = -3 m: must be positive; write e.g. length = \"5.10 m\""
[[nodiscard]] std::string to_string(const Fault& fault);

// Where the user wrote a key: in a line of a file, or in an option.
struct KeyPlace {
  std::string file;   // "model.toml", or "--set"
  int line = 0;       // 0: no line
  std::string given;  // the key as the option spells it; "": as it is
};

// The places of a spec's keys, as reading found them.
struct KeyPlaces {
  std::map<std::string, KeyPlace> key;  // by dotted path; "" is the file itself
  std::string blocks;                   // file of the blocks; "": none

  // The faults, each with the place of its key or of the nearest table above it, in the order of the lines. A fault that names a file
  // keeps it.
  [[nodiscard]] std::vector<Fault> placed(const std::vector<Fault>& faults) const;
};

// All faults of one input; what() lists them, one a line. Programs exit with code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

// A problem of the machine or file system: missing file, unwritable folder, full disk. Programs exit with code 4.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Collects faults while a spec is read and checked, then throws them together.
class FaultList {
 public:
  void add(Fault fault) { faults_.push_back(std::move(fault)); }
  [[nodiscard]] bool empty() const { return faults_.empty(); }
  [[nodiscard]] const std::vector<Fault>& all() const { return faults_; }
  // Throws InputError when there is at least one fault.
  void throw_if_any() const;

 private:
  std::vector<Fault> faults_;
};

}  // namespace wythe
