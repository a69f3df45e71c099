// The text is a seal and the members of the record, in the order of the lists of record_rows.h. A number is 16 hexadecimal digits: its
// bits. The seal is a hash of the program, the sample and all that follows, so nothing but what this program wrote is read.
#include "campaign/runner/handed_sample.h"

#include <fmt/format.h>

#include <charconv>

#include "campaign/store/record_rows.h"
#include "core/bits.h"
#include "core/hash.h"
#include "core/messages.h"
#include "wythe/parts/error.h"
#include "wythe/parts/provenance.h"

namespace wythe::study {
namespace {

constexpr std::size_t kDigits = 16;

class Writer {
 public:
  std::string text;

  void operator()(const char*, double number) { add(bits_as<std::uint64_t>(number)); }
  void operator()(const char*, bool is) { add(is ? 1 : 0); }
  void operator()(const char*, std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
  void operator()(const char*, const std::string& words) {
    add(words.size());
    text += words;
  }
  void operator()(const char* name, const Message& message) {
    (*this)(name, text_of(message));
    (*this)(name, message_json(message));
  }
  template <class Row, class Columns>
  void list(const char*, std::vector<Row> RecordLists::*rows, const Columns& columns) {
    add((lists.*rows).size());
    for (Row& row : lists.*rows) columns(*this, row);
  }
  void add(std::uint64_t number) { text += fmt::format("{:016x}", number); }

  RecordLists lists;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  void operator()(const char*, double& number) { number = bits_as<double>(next()); }
  void operator()(const char*, bool& is) { is = next() != 0; }
  void operator()(const char*, std::int64_t& number) { number = static_cast<std::int64_t>(next()); }
  void operator()(const char*, std::string& words) { words = take(next()); }
  void operator()(const char* name, Message& message) {
    std::string words, json;
    (*this)(name, words);
    (*this)(name, json);
    message = message_of(json, words);
  }
  template <class Row, class Columns>
  void list(const char*, std::vector<Row> RecordLists::*rows, const Columns& columns) {
    const std::uint64_t count = next();
    for (std::uint64_t k = 0; k < count; ++k) columns(*this, (lists.*rows).emplace_back());
  }
  std::uint64_t next() {
    const std::string_view digits = take(kDigits);
    std::uint64_t number = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
    if (error != std::errc() || end != digits.data() + digits.size()) damaged();
    return number;
  }
  [[noreturn]] static void damaged() {
    throw InputError({{.path = "record",
                       .problem = "is damaged, or of another wall, model, setting or program",
                       .cure = "give what it was pushed with, or push that wall again"}});
  }

  RecordLists lists;

 private:
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) damaged();
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest_;
};

std::uint64_t seal_of(const StudySpec& study, const SampleTable& samples, int sample,
                      std::string_view text) {
  Hash hash;
  const Provenance program = provenance();
  for (const char* part : {program.version, program.commit}) hash.add(part), hash.add("\n");
  hash.add(&sample, sizeof sample);
  hash.add(study.model_text);
  hash.add(study.blocks_text);
  for (const auto& settings : {study.settings, settings_of(samples, sample - 1)})
    for (const std::string& setting : settings) hash.add("\n"), hash.add(setting);
  hash.add(text);
  return hash.value();
}

template <class Visitor, class Record>
void each_member(Visitor& v, Record& record) {
  each_column(v, record);
  if (record.answered()) each_output(v, record);
  each_list(v);
}

}  // namespace

std::string handed_text(const StudySpec& study, const SampleTable& samples,
                        const SampleRecord& record) {
  Writer out;
  out.add(record.curve.size());
  for (const double number : curve_columns(record.curve)) out("", number);
  out.lists = lists_of(record);
  SampleRecord given = record;
  each_member(out, given);
  return fmt::format("{:016x}", seal_of(study, samples, record.sample, out.text)) + out.text;
}

SampleRecord handed_record(const StudySpec& study, const SampleTable& samples, int sample,
                           std::string_view text) {
  if (text.size() < kDigits ||
      Reader(text).next() != seal_of(study, samples, sample, text.substr(kDigits)))
    Reader::damaged();
  Reader in(text.substr(kDigits));
  SampleRecord record;
  record.sample = sample;
  record.inputs = samples.value[sample - 1];
  const std::uint64_t rows = in.next();
  if (rows > text.size() / kDigits) Reader::damaged();
  record.curve.resize(rows);
  for (const CurveColumn& column : kCurveColumns)
    for (CurveRow& row : record.curve) in("", row.*column.value);
  each_column(in, record);
  if (record.answered()) each_output(in, record);
  each_list(in);
  put_lists(std::move(in.lists), record);
  return record;
}

}  // namespace wythe::study
