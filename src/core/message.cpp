// Messages as text and as JSON. Below the room io only this file uses nlohmann-json: it reads the table of words.
//
// A text of the table has {name} or {name:format} for each argument. For a number the format is one of fmt;
// for a list of messages it is the separator between them ("; " without one).
#include "wythe/parts/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "core/ascii.h"
#include "core/decimal_point.h"
#include "core/messages.h"

namespace wythe {
namespace {

using Json = nlohmann::ordered_json;

const Json& table() {
  static const Json kTable = Json::parse(kMessagesJson);
  return kTable;
}

constexpr const char* kText = "text";  // the code of as_text()

// Index of a language in the rows of the table.
std::size_t place_of(std::string_view language) {
  const auto known = message_languages();
  const auto at = std::find(known.begin(), known.end(), language);
  return at == known.end() ? 0 : static_cast<std::size_t>(at - known.begin());
}

std::string said(const Message& message, std::size_t language);

// A number in its format. A number other than 0 must not appear as 0: up to three decimals are added until a digit shows.
// Formats without decimals are for counts and stay as they are.
// A foreign file may hold a number where the text expects a list: such a format is invalid for it and is ignored.
std::string in_digits(double number, std::string format) try {
  std::string text = fmt::format(fmt::runtime("{:" + format + "}"), number);
  if (number == 0 || !format.ends_with('f') || format.ends_with(".0f")) return text;
  for (int more = 0; more < 3 && text.find_first_of("123456789") == std::string::npos; ++more) {
    ++format[format.size() - 2];
    text = fmt::format(fmt::runtime("{:" + format + "}"), number);
  }
  return text;
} catch (const fmt::format_error&) {
  return fmt::format("{}", number);
}

// Whether the next argument is the value of a key, as in `until = "{until_mm} mm"`, or a quantity in quotes. It then has a
// decimal point in every language, as in a file. A single letter before the equals sign is a coordinate.
bool is_value_of_key(std::string_view before) {
  if (before.ends_with('"')) return true;
  if (!before.ends_with("= ")) return false;
  before.remove_suffix(2);
  if (before.ends_with(' ')) before.remove_suffix(1);
  const auto is_letter = [](char c) { return is_ascii_letter(c) || c == '_'; };
  return before.size() > 1 && is_letter(before.back()) && is_letter(before[before.size() - 2]);
}

std::string in_words(const Argument& argument, const std::string& format, bool is_code,
                     std::size_t language) {
  if (const auto* number = std::get_if<double>(&argument.value)) {
    std::string text = in_digits(*number, format);
    const std::string sign = is_code ? "." : table()["decimal"].at(language);
    if (const std::size_t at = text.find('.'); at != std::string::npos) text.replace(at, 1, sign);
    return text;
  }
  if (const auto* text = std::get_if<std::string>(&argument.value)) return *text;
  std::string list;
  for (const Message& part : std::get<std::vector<Message>>(argument.value))
    list += (list.empty() ? "" : format.empty() ? "; " : format) + said(part, language);
  return list;
}

std::string said(const Message& message, std::size_t language) {
  if (message.empty()) return "";
  const Json& words = table()["messages"];
  if (!words.contains(message.code)) return message.code;
  const std::string pattern = words[message.code].at(language);
  std::string text;
  std::size_t from = 0;
  for (std::size_t open; (open = pattern.find('{', from)) != std::string::npos;) {
    const std::size_t close = pattern.find('}', open);
    const std::string place = pattern.substr(open + 1, close - open - 1);
    const std::size_t colon = std::min(place.find(':'), place.size());
    const std::string format = colon < place.size() ? place.substr(colon + 1) : "";
    const auto found =
        std::find_if(message.arguments.begin(), message.arguments.end(),
                     [&](const Argument& a) { return a.name == place.substr(0, colon); });
    text += pattern.substr(from, open - from);
    text += found == message.arguments.end()
                ? "{" + place + "}"
                : in_words(*found, format, is_value_of_key(text), language);
    from = close + 1;
  }
  return text + pattern.substr(from);
}

Json json_of(const Message& message) {
  Json arguments = Json::object();
  for (const Argument& a : message.arguments) {
    if (const auto* number = std::get_if<double>(&a.value)) arguments[a.name] = *number;
    if (const auto* text = std::get_if<std::string>(&a.value)) arguments[a.name] = *text;
    if (const auto* list = std::get_if<std::vector<Message>>(&a.value)) {
      arguments[a.name] = Json::array();
      for (const Message& part : *list) arguments[a.name].push_back(json_of(part));
    }
  }
  return {{"code", message.code}, {"arguments", arguments}};
}

constexpr int kDeepest = 16;  // nesting of messages; the engine's own reach 5

// Nothing where the table does not know the message, or one of the messages in it: an incomplete sentence
// would say something else.
std::optional<Message> read(const Json& json, int depth = 0) {
  if (depth > kDeepest || !json.is_object() || !json.contains("code") || !json["code"].is_string())
    return std::nullopt;
  Message message{json["code"].get<std::string>(), {}};
  if (!message.empty() && !table()["messages"].contains(message.code)) return std::nullopt;
  if (!json.contains("arguments")) return message;
  for (const auto& [name, value] : json["arguments"].items()) {
    if (value.is_string()) {
      message.arguments.emplace_back(name, value.get<std::string>());
    } else if (value.is_array()) {
      std::vector<Message> list;
      for (const Json& part : value) {
        std::optional<Message> known = read(part, depth + 1);
        if (!known) return std::nullopt;
        list.push_back(*std::move(known));
      }
      message.arguments.emplace_back(name, std::move(list));
    } else {
      const double none = std::numeric_limits<double>::quiet_NaN();
      message.arguments.emplace_back(name, value.is_number() ? value.get<double>() : none);
    }
  }
  return message;
}

}  // namespace

Argument::Argument(std::string called, double number) : name(std::move(called)), value(number) {}
Argument::Argument(std::string called, std::string text)
    : name(std::move(called)), value(std::move(text)) {}
Argument::Argument(std::string called, const char* text)
    : name(std::move(called)), value(std::string(text)) {}
Argument::Argument(std::string called, Message message)
    : name(std::move(called)), value(std::vector<Message>{std::move(message)}) {}
Argument::Argument(std::string called, std::vector<Message> messages)
    : name(std::move(called)), value(std::move(messages)) {}

double Message::number(std::string_view called) const {
  for (const Argument& a : arguments)
    if (const auto* value = std::get_if<double>(&a.value); value != nullptr && a.name == called)
      return *value;
  return std::numeric_limits<double>::quiet_NaN();
}

bool operator==(const Argument& a, const Argument& b) {
  return a.name == b.name && a.value == b.value;
}
bool operator==(const Message& a, const Message& b) {
  return a.code == b.code && a.arguments == b.arguments;
}

Message as_text(std::string text) {
  if (text.empty()) return {};
  return {kText, {{"text", std::move(text)}}};
}

std::string text_of(const Message& message, std::string_view language) {
  return said(message, place_of(language));
}

std::vector<std::string> texts_of(const std::vector<Message>& messages, std::string_view language) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(text_of(message, language));
  return texts;
}

std::ostream& operator<<(std::ostream& out, const Message& message) {
  return out << text_of(message);
}

std::vector<std::string> message_languages() { return table()["languages"]; }
bool is_message(const std::string& code) { return table()["messages"].contains(code); }

std::string message_json(const Message& message) {
  if (message.empty() || message.code == kText) return "";
  // replace: a name that is not UTF-8 must not end the run
  return json_of(message).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Message message_of(std::string_view json, const std::string& text) {
  if (json.empty()) return as_text(text);
  const DecimalPoint point;
  const std::optional<Message> message = read(Json::parse(json, nullptr, false));
  return message && !message->empty() ? *message : as_text(text);
}

}  // namespace wythe
