// What the engine has to say, as data: a code and its arguments. Words for every code stand in one
// table, in each language: src/core/messages.json.
//
//   Message{"stage.not_settled", {{"stage", "gravity"}, {"ratio", 0.02}, ...}}
//   text_of(it)        stage "gravity" did not settle: unbalance ratio 0.02 ...
//   text_of(it, "it")  la fase “gravity” non ha raggiunto la quiete: ...
//
// Ask the code what happened, never the text.
#pragma once

#include <concepts>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace wythe {

struct Message;

// A number in the unit its name ends with (displacement_mm), a name as it is (of a block, a stage, a
// key), or other messages.
struct Argument {
  std::string name;
  std::variant<double, std::string, std::vector<Message>> value;

  Argument(std::string called, double number);
  Argument(std::string called, std::integral auto number)
      : Argument(std::move(called), static_cast<double>(number)) {}
  Argument(std::string called, std::string text);
  Argument(std::string called, const char* text);
  Argument(std::string called, Message message);
  Argument(std::string called, std::vector<Message> messages);
};

struct Message {
  std::string code = {};  // "": nothing is said
  std::vector<Argument> arguments = {};
  [[nodiscard]] bool empty() const { return code.empty(); }
  // The number of that name; NaN where there is none.
  [[nodiscard]] double number(std::string_view called) const;
};
[[nodiscard]] bool operator==(const Message& a, const Message& b);
[[nodiscard]] bool operator==(const Argument& a, const Argument& b);

// Words that stand as they are in every language: a user's own.
[[nodiscard]] Message as_text(std::string text);

// In words; languages are those of report_languages() (report.h), any other reads as English. A code
// that the table has not stands for itself.
[[nodiscard]] std::string text_of(const Message& message, std::string_view language = "en");
[[nodiscard]] std::vector<std::string> texts_of(const std::vector<Message>& messages,
                                                std::string_view language = "en");
std::ostream& operator<<(std::ostream& out, const Message& message);  // English

}  // namespace wythe
