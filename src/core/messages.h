// The table of words (messages.json) and messages as JSON: {"code": "...", "arguments": {...}}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

extern const std::string_view kMessagesJson;  // cmake/embed.cmake

[[nodiscard]] std::vector<std::string> message_languages();
[[nodiscard]] bool is_message(const std::string& code);
// "" for a message that is empty or only text (as_text): then the text is all there is.
[[nodiscard]] std::string message_json(const Message& message);
// `text` as it stands where `json` is "", or no message this table knows.
[[nodiscard]] Message message_of(std::string_view json, const std::string& text);

}  // namespace wythe
