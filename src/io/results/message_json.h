// Messages in JSON files: KEY in English, and KEY_message as data. Lists and columns of numbers.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/decimal_point.h"
#include "core/messages.h"

namespace wythe::io {

// What `of`, a function or a member, gives for each item.
template <class Items, class Of>
nlohmann::ordered_json list_of(const Items& items, const Of& of) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& item : items) list.push_back(std::invoke(of, item));
  return list;
}
// A number of each item, in another unit.
template <class Item>
nlohmann::ordered_json column_of(const std::vector<Item>& items, double Item::*value,
                                 double to_unit = 1) {
  return list_of(items, [&](const Item& item) { return item.*value * to_unit; });
}

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
