// Counts open brackets, dots of keys, keys and lines; it skips strings and comments, whose brackets do not nest.
// It is no parser: its counts are upper bounds. In TOML it counts a decimal point as a dot, and a list as a key.
#include "core/shape.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/limits.h"
#include "wythe/parts/error.h"

namespace wythe {
namespace {

class Scan {
 public:
  Scan(std::string_view text, Syntax syntax, const std::string& file)
      : text_(text), toml_(syntax == Syntax::kToml), file_(file) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || (toml_ && c == '\''))
        skip_string(c);
      else if (toml_ && c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else
        take(c), ++at_;
    }
  }

 private:
  void take(char c) {
    if (c == '\n') ++line_;
    if (c == '[' || c == '{') ++brackets_;
    if (c == ']' || c == '}') brackets_ = std::max(0, brackets_ - 1);
    // each dot of a key opens a nested table; any of these characters ends the key
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') dots_ = 0;
    if (c == '.' && toml_) ++dots_;
    if (brackets_ + dots_ > kMostDepth)
      refuse(fmt::format("nests deeper than {} levels", kMostDepth),
             "write fewer tables or lists in each other");
    const bool heads = c == '[' && (at_ == 0 || text_[at_ - 1] != '[');  // [a] and [[a]] count once
    if (toml_ && (c == '=' || heads)) ++keys_;
    if (keys_ > kMostKeys)
      refuse(fmt::format("has more than {} keys", kMostKeys),
             "leave some out; values of a list may stand in a CSV file");
  }

  // Skips the string that begins here. Only a TOML string between three quotes may be longer than a line.
  void skip_string(char quote) {
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool lines = toml_ && text_.substr(at_, 3) == three;
    const std::string_view end = lines ? three : three.substr(0, 1);
    for (at_ += end.size(); at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!lines) return;
        ++line_;
      } else if (c == '\\' && quote == '"' && at_ + 1 < text_.size()) {
        line_ += text_[++at_] == '\n';
      } else if (text_.substr(at_, end.size()) == end) {
        at_ += end.size();
        for (int more = 0; lines && more < 2 && at_ < text_.size() && text_[at_] == quote; ++more)
          ++at_;  // quotes that belong to the text, before the three that end it
        return;
      }
    }
  }

  [[noreturn]] void refuse(const std::string& problem, const std::string& cure) const {
    throw InputError({{.file = file_,
                       .problem = problem,
                       .cure = cure + " (docs/reference/limits.md)",
                       .line = line_}});
  }

  std::string_view text_;
  bool toml_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1, brackets_ = 0, dots_ = 0, keys_ = 0;
};

}  // namespace

void check_shape(std::string_view text, Syntax syntax, const std::string& file) {
  Scan(text, syntax, file).run();
}

}  // namespace wythe
