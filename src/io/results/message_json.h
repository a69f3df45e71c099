// Messages in JSON files: KEY in English, and KEY_message as data.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/decimal_point.h"
#include "core/messages.h"

namespace wythe::io {

template <class Json>
Json data_of(const Message& message) {
  const std::string data = message_json(message);
  const DecimalPoint point;
  return data.empty() ? Json() : Json::parse(data);
}

template <class Json>
void put(Json& json, const std::string& key, const Message& message) {
  json[key] = text_of(message);
  if (Json data = data_of<Json>(message); !data.is_null()) json[key + "_message"] = std::move(data);
}

// null in the list of data for a plain text.
template <class Json>
void put(Json& json, const std::string& key, const std::vector<Message>& messages) {
  json[key] = texts_of(messages);
  Json& list = json[key + "_message"] = Json::array();
  for (const Message& message : messages) list.push_back(data_of<Json>(message));
}

}  // namespace wythe::io
