// Reads a text three times: for its depth (core/shape.h), for keys that occur twice, then to parse it. Keys have a
// pass of their own, because with the parser's callback the time grows with the square of a list's length.
#include "io/text/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/decimal_point.h"
#include "core/shape.h"
#include "wythe/parts/error.h"

namespace wythe::io {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& problem,
                         const std::string& cure, std::ptrdiff_t line = 0) {
  throw InputError(
      {{.file = file, .problem = problem, .cure = cure, .line = static_cast<int>(line)}});
}

// Checks only keys, in a pass of its own: the parser's callback costs the square of a long list.
class Keys : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Keys(const std::string& file) : file_(file) {}
  bool key(std::string& name) override {
    if (!open_.back().insert(name).second)
      refuse(file_, fmt::format("has the key \"{}\" twice in one object", name),
             "leave one of the two");
    return true;
  }
  bool start_object(std::size_t) override { return open_.emplace_back(), true; }
  bool end_object() override { return open_.pop_back(), true; }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(nlohmann::json::binary_t&) override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  // the following parse reports the error
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

 private:
  const std::string& file_;
  std::vector<std::set<std::string>> open_;
};

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& file) {
  check_shape(text, Syntax::kJson, file);
  const DecimalPoint point;
  Keys keys(file);
  static_cast<void>(nlohmann::json::sax_parse(text, &keys));
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto at = static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    refuse(file, fmt::format("not valid JSON at byte {}", error.byte),
           "correct it there, or write the file again",
           std::count(text.begin(), text.begin() + at, '\n') + 1);
  } catch (const nlohmann::json::out_of_range&) {
    refuse(file, "holds a number beyond 1.8e308", "write smaller numbers");
  }
}

}  // namespace wythe::io
