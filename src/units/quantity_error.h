// What is wrong with the text of a quantity, as problem and cure. A reader that knows the key
// can replace the cure by its own example.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace wythe {

class QuantityError : public std::invalid_argument {
 public:
  QuantityError(std::string problem, std::string cure)
      : std::invalid_argument(problem + "; " + cure),
        problem_(std::move(problem)),
        cure_(std::move(cure)) {}
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] const std::string& cure() const { return cure_; }

 private:
  std::string problem_, cure_;
};

}  // namespace wythe
