// Translates a message into every language of the table, in the order of message_languages(), or into one text
// where all agree. Words of CODE.page take precedence over those of CODE, also in messages within a message.
#include "report/translation.h"

#include "core/messages.h"
#include "judge/modes/wall_parts.h"

namespace wythe::report {
namespace {

constexpr std::string_view kData = "_message";

// `text` is used where the data are null.
Json translated_json(const Json& data, const Json& text) {
  if (!data.is_array())
    return data.is_object() && text.is_string() ? translated(message_of(data.dump(), text)) : text;
  Json list = Json::array();
  for (std::size_t i = 0; i < data.size(); ++i)
    list.push_back(
        translated_json(data[i], text.is_array() && i < text.size() ? text[i] : Json("")));
  return list;
}

}  // namespace

Json translated(const Message& message) {
  Json texts = Json::array();
  bool same = true;
  const Message on_page = for_page(message);
  for (const std::string& language : message_languages()) {
    texts.push_back(text_of(on_page, language));
    same = same && texts.back() == texts.front();
  }
  return same ? texts.front() : texts;
}

Json translated(const std::vector<Message>& messages) {
  Json list = Json::array();
  for (const Message& message : messages) list.push_back(translated(message));
  return list;
}

Message for_page(Message message) {
  for (Argument& argument : message.arguments)
    if (auto* parts = std::get_if<std::vector<Message>>(&argument.value))
      for (Message& part : *parts) part = for_page(std::move(part));
  if (is_message(message.code + ".page")) message.code += ".page";
  return message;
}

Message shortened(Message sentence) {
  constexpr std::ptrdiff_t kListed = 3;
  for (Argument& argument : sentence.arguments) {
    auto* parts = std::get_if<std::vector<Message>>(&argument.value);
    if (parts == nullptr || argument.name != "parts") continue;
    const auto more = static_cast<std::ptrdiff_t>(parts->size()) - kListed;
    if (more <= 0) continue;
    parts->erase(parts->begin() + kListed, parts->end());
    parts->push_back({"part.more", {{"number", more}}});
  }
  return sentence;
}

Json names_of(const Model& model) {
  Json names = Json::object();
  for (const auto& [name, words] : study::find_parts(model).words) names[name] = translated(words);
  return names;
}

void translate_messages(Json& json) {
  if (json.is_array())
    for (Json& part : json) translate_messages(part);
  if (!json.is_object()) return;
  Json out = Json::object();
  for (auto& [key, value] : json.items()) {
    if (key.ends_with(kData) && json.contains(key.substr(0, key.size() - kData.size()))) continue;
    const std::string data = key + std::string(kData);
    if (json.contains(data)) {
      out[key] = translated_json(json[data], value);
    } else {
      translate_messages(value);
      out[key] = std::move(value);
    }
  }
  json = std::move(out);
}

}  // namespace wythe::report
