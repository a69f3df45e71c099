// A job of the C interface (wythe/c.h): named inputs in, named texts and tables out.
//
//   Job ──► task(job)       one function a task, below; throws what the library throws
//
// Outputs may be made when they are first requested, because pictures and states take time and most users do not need them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace wythe::api {

// As one line; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string dumped(const nlohmann::ordered_json& json);

struct Table {
  std::vector<std::string> column;
  std::vector<std::vector<double>> value;  // (n_column, n_row)
  void add(std::string name, std::vector<double> values) {
    column.push_back(std::move(name));
    value.push_back(std::move(values));
  }
};

class Inputs {
 public:
  std::map<std::string, std::vector<std::string>> text;
  std::map<std::string, double> number;
  std::map<std::string, std::vector<double>> column;

  // Throws InputError for each input that `task` does not have; each list contains a name once.
  void check(const std::string& task, const std::vector<std::string>& texts,
             const std::vector<std::string>& numbers, bool columns) const;

  [[nodiscard]] bool has(const std::string& name) const { return text.contains(name); }
  [[nodiscard]] std::string one(const std::string& name, const std::string& otherwise = "") const;
  // "out": a folder for files; "" where none is requested. Throws InputError where it is given but empty.
  [[nodiscard]] std::string out_folder() const;
  [[nodiscard]] std::vector<std::string> all(const std::string& name) const;
  // An integer from `least` to `most`; throws InputError.
  [[nodiscard]] int integer(const std::string& name, int otherwise, int least, int most) const;
  // "threads" or "jobs": a number of cores; 0 means all of them.
  [[nodiscard]] int cores(const std::string& name, int otherwise) const;
  [[nodiscard]] double real(const std::string& name, double otherwise) const;
};

class Answers {
 public:
  void put(const std::string& name, std::string text) { text_[name] = std::move(text); }
  void put(const std::string& name, Table table) { table_[name] = std::move(table); }
  // Made when it is first requested.
  void text_later(const std::string& name, std::function<std::string()> make) {
    text_[name] = {};
    text_maker_[name] = std::move(make);
  }
  void table_later(const std::string& name, std::function<Table()> make) {
    table_[name] = {};
    table_maker_[name] = std::move(make);
  }
  void clear();

  [[nodiscard]] const std::string* text(const std::string& name);
  [[nodiscard]] const std::vector<double>* column(const std::string& table,
                                                  const std::string& column);
  // {"curve": ["time_s", ...], ...} and ["summary", ...]; makes every table.
  [[nodiscard]] std::string tables_json();
  [[nodiscard]] std::string texts_json() const;
  // The columns of one table; none if the table does not exist.
  [[nodiscard]] std::string columns_json(const std::string& table);

 private:
  [[nodiscard]] const Table* table(const std::string& name);

  std::map<std::string, std::string> text_;
  std::map<std::string, std::function<std::string()>> text_maker_;
  std::map<std::string, Table> table_;
  std::map<std::string, std::function<Table()>> table_maker_;
};

struct Job {
  std::string task;
  Inputs in;
  Answers out;
  std::atomic<bool> stop{false};
  // The present activity and the finished share [0, 1]; displacement [mm] and force [kN] of a run.
  std::function<void(const std::string& what, double share, double mm, double kn)> progress;
  // The continuation of a stopped task, for its next call; none otherwise.
  std::function<bool(Job& job)> rest;
};

// Each fills job.out; returns true if it was stopped before its end. Throws InputError, IoError.
using Task = bool (*)(Job& job);
using Tasks = std::map<std::string, Task>;
[[nodiscard]] const Tasks& run_tasks();    // about one wall, and assess
[[nodiscard]] const Tasks& study_tasks();  // about many; none in the engine for browsers (src/wasm)
bool do_assess(Job& job);                  // assess_task.cpp

}  // namespace wythe::api
