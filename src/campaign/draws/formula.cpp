// Dimensions and values of a formula's nodes.
#include "campaign/draws/formula.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "campaign/draws/formula_parser.h"
#include "core/elementary.h"
#include "units/quantity_error.h"

namespace wythe {
namespace {

using Kind = FormulaNode::Kind;
using Dimensions = std::map<std::string, Dimension>;

// atan(x) of a formula gives an angle, log(x) a number; the operand must be a number.
void need_number(const char* function, const Dimension& dimension) {
  if (dimension.is_number()) return;
  throw FormulaError(fmt::format("{} of {}", function, dimension.words()),
                     fmt::format("divide by a quantity in {} first", dimension.unit()));
}

[[noreturn]] void refuse_mixture(const char* what, const Dimension& a, const Dimension& b) {
  throw FormulaError(fmt::format("{} {} and {}", what, a.words(), b.words()),
                     "give both the same unit");
}

double call_value(std::size_t function, std::span<const double> x) {
  switch (function) {
    case kSqrt: return std::sqrt(x[0]);
    case kExp: return elementary::exp(x[0]);
    case kLog: return elementary::log(x[0]);
    case kTan: return elementary::tan(x[0]);
    case kAtan: return elementary::atan(x[0]);
    case kSin: return elementary::sin(x[0]);
    case kCos: return elementary::cos(x[0]);
    case kMin: return *std::min_element(x.begin(), x.end());
    default: return *std::max_element(x.begin(), x.end());
  }
}

}  // namespace

Formula::Formula(const std::string& text, const std::vector<std::string>& known) : text_(text) {
  FormulaParser parser(text, known);
  try {
    root_ = parser.read();
  } catch (const QuantityError& error) {
    throw FormulaError(error.problem(), error.cure());
  }
  node_ = std::move(parser.node);
  std::vector<std::size_t> place(known.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    const bool used = std::any_of(node_.begin(), node_.end(), [&](const FormulaNode& n) {
      return n.kind == Kind::kInput && n.which == i;
    });
    if (!used) continue;
    place[i] = inputs_.size();
    inputs_.push_back(known[i]);
  }
  for (FormulaNode& n : node_)
    if (n.kind == Kind::kInput) n.which = place[n.which];
}

std::string Formula::replaced(const std::map<std::string, std::string>& by) const {
  std::map<std::size_t, std::string> at;  // names by their first character
  for (const FormulaNode& n : node_)
    if (n.kind == Kind::kInput) at[n.begin] = inputs_[n.which];
  std::string out = text_;
  for (auto name = at.rbegin(); name != at.rend(); ++name)
    if (const auto text = by.find(name->second); text != by.end())
      out.replace(name->first, name->second.size(), text->second);
  return out;
}

Dimension Formula::dimension(const Dimensions& of) const { return dimension_at(root_, of); }

double Formula::value(std::span<const double> inputs) const { return value_at(root_, inputs); }

// --- dimensions ----------------------------------------------------------------------------------

Dimension Formula::dimension_at(std::size_t node, const Dimensions& of) const {
  const FormulaNode& n = node_[node];
  std::vector<Dimension> operand;
  if (n.kind != Kind::kPower)
    for (const std::size_t at : n.of) operand.push_back(dimension_at(at, of));
  switch (n.kind) {
    case Kind::kNumber: return n.dimension;
    case Kind::kInput: return of.at(inputs_[n.which]);
    case Kind::kNegate: return operand[0];
    case Kind::kTimes: return operand[0].times(operand[1]);
    case Kind::kOver: return operand[0].over(operand[1]);
    case Kind::kPower: return power_dimension(n, dimension_at(n.of[0], of), of);
    case Kind::kAdd:
    case Kind::kSubtract:
      if (operand[0] != operand[1])
        refuse_mixture(n.kind == Kind::kAdd ? "adds" : "subtracts", operand[0], operand[1]);
      return operand[0];
    case Kind::kCall: break;
  }
  if (n.which == kSqrt) return operand[0].power(0.5);
  if (n.which == kMin || n.which == kMax) {
    for (const Dimension& other : operand)
      if (other != operand[0]) refuse_mixture("compares", operand[0], other);
    return operand[0];
  }
  need_number(kFunctions[n.which].name, operand[0]);
  return {};
}

// The exponent of a quantity must be constant, because the unit of x^y would change from sample to sample.
Dimension Formula::power_dimension(const FormulaNode& node, const Dimension& base,
                                   const Dimensions& of) const {
  const Dimension exponent = dimension_at(node.of[1], of);
  if (!exponent.is_number())
    throw FormulaError(fmt::format("has {} as an exponent", exponent.words()),
                       "an exponent is a number without unit");
  if (base.is_number()) return {};
  const double constant = exponent_at(node.of[1]);
  if (std::isnan(constant))
    throw FormulaError(fmt::format("raises {} to a power that varies", base.words()),
                       fmt::format("divide by a quantity in {} first", base.unit()));
  return base.power(constant);
}

// The value of a node without inputs; NaN for a node with inputs.
double Formula::exponent_at(std::size_t node) const {
  const FormulaNode& n = node_[node];
  if (n.kind == Kind::kInput) return std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t at : n.of)
    if (std::isnan(exponent_at(at))) return std::numeric_limits<double>::quiet_NaN();
  return value_at(node, {});
}

// --- values --------------------------------------------------------------------------------------

double Formula::value_at(std::size_t node, std::span<const double> inputs) const {
  const FormulaNode& n = node_[node];
  std::vector<double> x;
  for (const std::size_t at : n.of) x.push_back(value_at(at, inputs));
  switch (n.kind) {
    case Kind::kNumber: return n.number;
    case Kind::kInput: return inputs[n.which];
    case Kind::kNegate: return -x[0];
    case Kind::kAdd: return x[0] + x[1];
    case Kind::kSubtract: return x[0] - x[1];
    case Kind::kTimes: return x[0] * x[1];
    case Kind::kOver: return x[0] / x[1];
    case Kind::kPower: return elementary::pow(x[0], x[1]);
    case Kind::kCall: break;
  }
  return call_value(n.which, x);
}

}  // namespace wythe
