// The table of words (messages.json) and messages as JSON: {"code": "...", "arguments": {...}}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

extern const std::string_view kMessagesJson;  // made by cmake/embed.cmake

[[nodiscard]] std::vector<std::string> message_languages();
[[nodiscard]] bool is_message(const std::string& code);
// JSON of a message; "" for one that is empty or only text (as_text), which its text describes completely.
[[nodiscard]] std::string message_json(const Message& message);
// The message that `json` holds; as_text(text) where `json` is "" or holds no message that this table knows.
[[nodiscard]] Message message_of(std::string_view json, const std::string& text);

}  // namespace wythe
