// Formulas of dependent quantities: "0.029 mm * ft_j", "ft_j / (0.15 MPa) * 125 N/m".
//
//   expression := term { (+|-) term }          term  := factor { (*|/) factor }
//   factor     := [+|-] power                  power := atom [ ^ factor ]
//   atom       := number [unit] | name | function ( expression, ... ) | ( expression )
//   unit       := word[^n] { /word[^n] }       a word after a number: MPa, N/m, kg/m^3
//
// Functions: sqrt exp log tan atan sin cos min max. All numbers are SI inside, angles radians. A
// number and its unit are one: `x / 2 mm` divides by 2 mm.
#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "units/dimension.h"

namespace wythe {

// The fault of a formula, and what to write instead.
class FormulaError : public std::invalid_argument {
 public:
  FormulaError(const std::string& problem, std::string cure)
      : std::invalid_argument(problem), cure_(std::move(cure)) {}
  [[nodiscard]] const std::string& cure() const { return cure_; }

 private:
  std::string cure_;
};

struct FormulaNode {
  enum class Kind { kNumber, kInput, kNegate, kAdd, kSubtract, kTimes, kOver, kPower, kCall };
  Kind kind = Kind::kNumber;
  double number = 0;            // [SI]
  Dimension dimension;          // of a number
  std::size_t which = 0;        // input, or function
  std::size_t begin = 0;        // first character in the text, for messages
  std::vector<std::size_t> of;  // operands, by node
};

class Formula {
 public:
  // Reads the text; `known` are the names it may use. Throws FormulaError.
  Formula(const std::string& text, const std::vector<std::string>& known);

  // Names it uses, each once, in the order of `known`.
  [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
  // The text of the formula with names replaced by given texts.
  [[nodiscard]] std::string replaced(const std::map<std::string, std::string>& by) const;
  // Dimension of the value for inputs with these dimensions. Throws FormulaError where dimensions clash.
  [[nodiscard]] Dimension dimension(const std::map<std::string, Dimension>& of) const;
  // The value [SI] for the values of inputs(), in that order. NaN where it does not exist.
  [[nodiscard]] double value(std::span<const double> inputs) const;

 private:
  [[nodiscard]] Dimension dimension_at(std::size_t node,
                                       const std::map<std::string, Dimension>& of) const;
  [[nodiscard]] Dimension power_dimension(const FormulaNode& node, const Dimension& base,
                                          const std::map<std::string, Dimension>& of) const;
  [[nodiscard]] double value_at(std::size_t node, std::span<const double> inputs) const;
  [[nodiscard]] double exponent_at(std::size_t node) const;

  std::string text_;
  std::vector<std::string> inputs_;
  std::vector<FormulaNode> node_;
  std::size_t root_ = 0;
};

// Names of functions, which an input cannot have.
[[nodiscard]] bool is_function_name(const std::string& name);

}  // namespace wythe
