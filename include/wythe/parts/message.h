// Messages of the engine as data: a code and its arguments. One table holds the text of every code
// in each language: src/core/messages.json.
//
//   Message{"stage.not_settled", {{"stage", "gravity"}, {"ratio", 0.02}, ...}}
//   text_of(it)        stage "gravity" did not settle: unbalance ratio 0.02 ...
//   text_of(it, "it")  la fase “gravity” non ha raggiunto la quiete: ...
//
// Programs test the code, never the text.
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

// An argument: a number in the unit that its name ends with (displacement_mm), the name of a block, stage or
// key, or other messages.
struct Argument {
  std::string name;
  std::variant<double, std::string, std::vector<Message>> value;

  Argument(std::string called, double number);
  Argument(std::string called, std::integral auto number);  // behind Message, which clang 14 needs
  Argument(std::string called, std::string text);
  Argument(std::string called, const char* text);
  Argument(std::string called, Message message);
  Argument(std::string called, std::vector<Message> messages);
};

struct Message {
  std::string code = {};  // "": no message
  std::vector<Argument> arguments = {};
  [[nodiscard]] bool empty() const { return code.empty(); }
  // The argument of that name as a number; NaN where there is none.
  [[nodiscard]] double number(std::string_view called) const;
};
inline Argument::Argument(std::string called, std::integral auto number)
    : Argument(std::move(called), static_cast<double>(number)) {}
[[nodiscard]] bool operator==(const Message& a, const Message& b);
[[nodiscard]] bool operator==(const Argument& a, const Argument& b);

// A text that is the same in every language, such as a user's own.
[[nodiscard]] Message as_text(std::string text);

// The text of a message; languages are those of report_languages() (report.h), any other gives English. A code
// without an entry in the table gives the code.
[[nodiscard]] std::string text_of(const Message& message, std::string_view language = "en");
[[nodiscard]] std::vector<std::string> texts_of(const std::vector<Message>& messages,
                                                std::string_view language = "en");
std::ostream& operator<<(std::ostream& out, const Message& message);  // English

}  // namespace wythe
