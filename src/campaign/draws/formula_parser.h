// Reads the text of a formula into its nodes; the grammar is in formula.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/draws/formula.h"

namespace wythe {

struct FormulaFunction {
  const char* name;
  std::size_t least, most;  // operands
};
inline constexpr FormulaFunction kFunctions[] = {{"sqrt", 1, 1}, {"exp", 1, 1},  {"log", 1, 1},
                                                 {"tan", 1, 1},  {"atan", 1, 1}, {"sin", 1, 1},
                                                 {"cos", 1, 1},  {"min", 2, 9},  {"max", 2, 9}};
enum FunctionId : std::size_t { kSqrt, kExp, kLog, kTan, kAtan, kSin, kCos, kMin, kMax };

class FormulaParser {
 public:
  FormulaParser(const std::string& text, const std::vector<std::string>& known)
      : text_(text), known_(known) {}

  // Returns the root; nodes refer to inputs by their index in `known`.
  std::size_t read();
  std::vector<FormulaNode> node;

 private:
  std::size_t expression();
  std::size_t term();
  std::size_t factor();
  std::size_t power();
  std::size_t atom();
  std::size_t number();
  std::size_t word();
  std::size_t call(std::size_t function, std::size_t begin);
  std::string unit_after_number(std::size_t number_begin);
  std::string unit_word(std::string_view word, std::size_t end) const;

  void skip_blanks();
  bool take(char c);
  void expect(char c, const char* after);
  [[nodiscard]] char peek();
  [[nodiscard]] std::string_view word_at(std::size_t at) const;
  [[nodiscard]] bool is_input(std::string_view word) const;
  std::size_t add(FormulaNode::Kind kind, std::size_t begin, std::vector<std::size_t> of,
                  std::size_t which = 0);

  const std::string& text_;
  const std::vector<std::string>& known_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace wythe
