// Looks up named inputs and makes outputs on demand. If a text is given several times, one()
// returns the last, all() returns each. An output is made when it is first requested, and then
// kept. tables_json() makes every table, because the names of columns are known only then.
#include "api/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "wythe/parts/error.h"

namespace wythe::api {
namespace {

template <class Map>
void refuse_others(const Map& given, const std::vector<std::string>& known, const char* what,
                   const std::string& task, FaultList& faults) {
  for (const auto& [name, value] : given) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    faults.add({.file = task,
                .path = name,
                .problem = fmt::format("is no {} that this task takes", what),
                .cure = known.empty() ? "leave it out" : "known are " + joined(known, ", ")});
  }
}

}  // namespace

std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void Inputs::check(const std::string& task, const std::vector<std::string>& texts,
                   const std::vector<std::string>& numbers, bool columns) const {
  FaultList faults;
  refuse_others(text, texts, "text", task, faults);
  refuse_others(number, numbers, "number", task, faults);
  if (!columns) refuse_others(column, {}, "column", task, faults);
  faults.throw_if_any();
}

std::string Inputs::one(const std::string& name, const std::string& otherwise) const {
  const auto found = text.find(name);
  return found == text.end() || found->second.empty() ? otherwise : found->second.back();
}

std::string Inputs::out_folder() const {
  const std::string folder = one("out");
  if (has("out") && folder.empty())
    throw InputError(
        {{.path = "out", .problem = "is empty", .cure = "name a folder, or leave it out"}});
  return folder;
}

std::vector<std::string> Inputs::all(const std::string& name) const {
  const auto found = text.find(name);
  return found == text.end() ? std::vector<std::string>{} : found->second;
}

int Inputs::integer(const std::string& name, int otherwise, int least, int most) const {
  const double value = real(name, otherwise);
  if (value == std::floor(value) && value >= least && value <= most) return static_cast<int>(value);
  throw InputError({{.path = name,
                     .value = fmt::format("{}", value),
                     .problem = fmt::format("must be a whole number from {} to {}", least, most),
                     .cure = "write one, or leave it out"}});
}

int Inputs::cores(const std::string& name, int otherwise) const {
  constexpr int kMost = 1024;
  return integer(name, otherwise, 0, kMost);
}

double Inputs::real(const std::string& name, double otherwise) const {
  const auto found = number.find(name);
  return found == number.end() ? otherwise : found->second;
}

void Answers::clear() {
  text_.clear();
  text_maker_.clear();
  table_.clear();
  table_maker_.clear();
}

const std::string* Answers::text(const std::string& name) {
  const auto found = text_.find(name);
  if (found == text_.end()) return nullptr;
  if (const auto maker = text_maker_.find(name); maker != text_maker_.end()) {
    found->second = maker->second();
    text_maker_.erase(maker);
  }
  return &found->second;
}

const Table* Answers::table(const std::string& name) {
  const auto found = table_.find(name);
  if (found == table_.end()) return nullptr;
  if (const auto maker = table_maker_.find(name); maker != table_maker_.end()) {
    found->second = maker->second();
    table_maker_.erase(maker);
  }
  return &found->second;
}

const std::vector<double>* Answers::column(const std::string& name, const std::string& column) {
  const Table* found = table(name);
  if (found == nullptr) return nullptr;
  const auto at = std::find(found->column.begin(), found->column.end(), column);
  return at == found->column.end() ? nullptr : &found->value[at - found->column.begin()];
}

std::string Answers::tables_json() {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : table_) json[name] = table(name)->column;
  return json.dump();
}

std::string Answers::columns_json(const std::string& name) {
  const Table* found = table(name);
  return found == nullptr ? "" : nlohmann::json(found->column).dump();
}

std::string Answers::texts_json() const {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& [name, value] : text_) json.push_back(name);
  return json.dump();
}

}  // namespace wythe::api
