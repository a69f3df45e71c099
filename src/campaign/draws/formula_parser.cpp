// Recursive descent, one function for each level of the grammar. Powers group from the right: 2^3^2 is
// 2^(3^2), and -2^2 is -(2^2). A number takes the unit behind it directly, with the same conversion as
// every quantity of a file. Length and nesting have limits, because each level costs stack.
#include "campaign/draws/formula_parser.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/number.h"
#include "core/text.h"
#include "units/quantity_error.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace {

using Kind = FormulaNode::Kind;

bool begins_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%';
}

bool is_unit(std::string_view word) { return !unit_definition(word).empty(); }

// Index of a function by its name, or the number of functions.
std::size_t function_named(std::string_view name) {
  const auto found = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                  [&](const FormulaFunction& f) { return f.name == name; });
  return static_cast<std::size_t>(found - std::begin(kFunctions));
}

// Longer or deeper formulas are mistakes, and would cost too much stack.
constexpr int kDeepest = 100;                  // nested parentheses and powers
constexpr std::size_t kLongestFormula = 2000;  // characters

}  // namespace

bool is_function_name(const std::string& name) {
  return function_named(name) < std::size(kFunctions);
}

std::size_t FormulaParser::read() {
  if (trimmed(text_).empty()) throw FormulaError("is empty", "write e.g. formula = \"1.5 * ft_j\"");
  if (text_.size() > kLongestFormula)
    throw FormulaError(fmt::format("has more than {} characters", kLongestFormula),
                       "split it into several dependents");
  const std::size_t root = expression();
  skip_blanks();
  if (at_ < text_.size())
    throw FormulaError(fmt::format("'{}' is not expected there", text_.substr(at_)),
                       "put an operator (+ - * / ^) between two terms");
  return root;
}

std::size_t FormulaParser::expression() {
  if (++depth_ > kDeepest)
    throw FormulaError("has too many nested parentheses", "split it into several dependents");
  std::size_t left = term();
  while (peek() == '+' || peek() == '-') {
    const std::size_t begin = at_;
    const Kind kind = text_[at_++] == '+' ? Kind::kAdd : Kind::kSubtract;
    left = add(kind, begin, {left, term()});
  }
  --depth_;
  return left;
}

std::size_t FormulaParser::term() {
  std::size_t left = factor();
  while (peek() == '*' || peek() == '/') {
    const std::size_t begin = at_;
    const Kind kind = text_[at_++] == '*' ? Kind::kTimes : Kind::kOver;
    left = add(kind, begin, {left, factor()});
  }
  return left;
}

std::size_t FormulaParser::factor() {
  bool negative = false;
  const std::size_t begin = at_;
  while (peek() == '+' || peek() == '-') negative ^= text_[at_++] == '-';
  const std::size_t inner = power();
  return negative ? add(Kind::kNegate, begin, {inner}) : inner;
}

std::size_t FormulaParser::power() {
  const std::size_t base = atom();
  if (peek() != '^') return base;
  const std::size_t begin = at_++;
  if (++depth_ > kDeepest)
    throw FormulaError("has too many nested powers", "split it into several dependents");
  const std::size_t exponent = factor();
  --depth_;
  return add(Kind::kPower, begin, {base, exponent});
}

std::size_t FormulaParser::atom() {
  const char c = peek();
  if (take('(')) {
    const std::size_t inner = expression();
    expect(')', "the bracket's expression");
    return inner;
  }
  if (is_digit(c) || c == '.') return number();
  if (begins_word(c)) return word();
  if (c == '\0') throw FormulaError("ends where a number or a name is expected", "complete it");
  throw FormulaError(fmt::format("'{}' stands where a number or a name is expected", c),
                     "write e.g. \"1.5 * ft_j\"");
}

std::size_t FormulaParser::number() {
  const std::size_t begin = at_;
  const auto found = leading_number(std::string_view(text_).substr(at_));
  if (!found)
    throw FormulaError(fmt::format("'{}' is not a number", text_.substr(begin)),
                       "write it with a point, e.g. 0.15");
  at_ = text_.size() - found->rest.size();
  const std::string digits = text_.substr(begin, at_ - begin);
  const std::string unit = unit_after_number(begin);
  const std::size_t out = add(Kind::kNumber, begin, {});
  node[out].number = found->value;
  if (unit.empty()) return out;
  node[out].dimension = dimension_of(unit);
  // parsed like every quantity: 310 mm has the bits of 0.31 m
  node[out].number = parse_quantity(digits + ' ' + unit, node[out].dimension.unit());
  return out;
}

// A word and its whole exponent, "m^3"; `end` is where the word ends in the text.
std::string FormulaParser::unit_word(std::string_view word, std::size_t end) const {
  std::string out(word);
  if (end + 1 < text_.size() && text_[end] == '^' && is_digit(text_[end + 1]))
    for (std::size_t i = end; i == end || (i < text_.size() && is_digit(text_[i])); ++i)
      out += text_[i];
  return out;
}

std::string FormulaParser::unit_after_number(std::size_t number_begin) {
  const std::size_t after_number = at_;
  skip_blanks();
  if (at_ >= text_.size() || !begins_word(text_[at_])) return "";
  const std::string_view first = word_at(at_);
  const std::string digits = text_.substr(number_begin, after_number - number_begin);
  if (is_input(first) || is_function_name(std::string(first)))
    throw FormulaError(fmt::format("there is no operator between {} and {}", digits, first),
                       fmt::format("write {} * {}", digits, first));
  if (!is_unit(first))
    throw FormulaError(fmt::format("the unit {} is not known", first),
                       "write a unit such as MPa, N/m, mm or deg, or an operator before a name");
  std::string unit = unit_word(first, at_ + first.size());
  at_ += unit.size();
  while (at_ + 1 < text_.size() && text_[at_] == '/' && begins_word(text_[at_ + 1])) {
    const std::string_view next = word_at(at_ + 1);
    if (is_input(next) || is_function_name(std::string(next)) || !is_unit(next)) break;
    const std::string below = unit_word(next, at_ + 1 + next.size());
    unit += '/' + below;
    at_ += 1 + below.size();
  }
  return unit;
}

std::size_t FormulaParser::word() {
  const std::size_t begin = at_;
  const std::string name(word_at(at_));
  at_ += name.size();
  if (const std::size_t function = function_named(name);
      function < std::size(kFunctions) && peek() == '(')
    return call(function, begin);
  const auto found = std::find(known_.begin(), known_.end(), name);
  if (found == known_.end())
    throw FormulaError(fmt::format("there is no variable or dependent {}", name),
                       name_advice(name, known_));
  return add(Kind::kInput, begin, {}, static_cast<std::size_t>(found - known_.begin()));
}

std::size_t FormulaParser::call(std::size_t function, std::size_t begin) {
  const FormulaFunction& f = kFunctions[function];
  expect('(', f.name);
  std::vector<std::size_t> of{expression()};
  while (take(',')) of.push_back(expression());
  expect(')', "the function's operands");
  if (of.size() < f.least || of.size() > f.most)
    throw FormulaError(
        fmt::format("{} has {} operands", f.name, of.size()),
        f.most == 1 ? fmt::format("write {}(x)", f.name) : fmt::format("write {}(x, y)", f.name));
  return add(Kind::kCall, begin, std::move(of), function);
}

void FormulaParser::skip_blanks() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n'))
    ++at_;
}

char FormulaParser::peek() {
  skip_blanks();
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool FormulaParser::take(char c) {
  if (peek() != c) return false;
  ++at_;
  return true;
}

void FormulaParser::expect(char c, const char* after) {
  if (!take(c))
    throw FormulaError(fmt::format("'{}' is missing after {}", c, after), "close the bracket");
}

std::string_view FormulaParser::word_at(std::size_t at) const {
  std::size_t end = at;
  while (end < text_.size() && (begins_word(text_[end]) || is_digit(text_[end]))) ++end;
  return std::string_view(text_).substr(at, end - at);
}

bool FormulaParser::is_input(std::string_view word) const {
  return std::find(known_.begin(), known_.end(), word) != known_.end();
}

std::size_t FormulaParser::add(Kind kind, std::size_t begin, std::vector<std::size_t> of,
                               std::size_t which) {
  FormulaNode made;
  made.kind = kind;
  made.begin = begin;
  made.of = std::move(of);
  made.which = which;
  node.push_back(std::move(made));
  return node.size() - 1;
}

}  // namespace wythe
