// Messages: codes and arguments to words, in every language; to JSON and back. The table of words
// is compared with the engine's sources, so that no text is missing, unused or without a value.
#include "wythe/parts/message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "core/messages.h"
#include "scenes/places.h"

namespace wythe::message_test {
namespace {

namespace fs = std::filesystem;

const Message kUnsettled{
    "stage.not_settled",
    {{"stage", "dead {load}"}, {"ratio", 0.0213}, {"time_s", 1.5}, {"wanted", 1e-3}}};

// --- words

TEST(Message, is_said_in_every_language_with_its_numbers) {
  EXPECT_EQ(
      text_of(kUnsettled),
      "stage \"dead {load}\" did not settle: unbalance ratio 0.021 after 1.5 s, wanted 0.001");
  EXPECT_EQ(
      text_of(kUnsettled, "it"),
      "la fase “dead {load}” non ha raggiunto la quiete: squilibrio 0,021 dopo 1,5 s, richiesto "
      "0,001");
}

TEST(Message, says_of_no_number_that_it_is_0_where_it_is_not) {
  const auto said = [](double percent, const char* language) {
    return text_of({"compare.peak_few", {{"percent", percent}, {"pairs", 3}}}, language)
        .substr(0, 8);
  };
  EXPECT_EQ(said(3.74, "en"), "+3.7 % p");
  EXPECT_EQ(said(0.021, "en"), "+0.02 % ");
  EXPECT_EQ(said(-0.0042, "it"), "-0,004 %");
  EXPECT_EQ(said(0, "en"), "+0.0 % p");
  EXPECT_EQ(said(1e-12, "en").substr(0, 7), "+0.0000");  // nothing of rounding
}

TEST(Message, keeps_the_decimal_point_of_a_value_that_goes_into_a_file) {
  const Message cure{"promise.cure_adapted", {{"velocity", 0.5}, {"below", 2.5e-5}}};
  for (const std::string& language : message_languages()) {
    const std::string said = text_of(cure, language);
    EXPECT_NE(said.find("fast_velocity = \"0.5 mm/s\""), std::string::npos) << said;
    EXPECT_NE(said.find("fast_below = 2.5e-05"), std::string::npos) << said;
  }
  EXPECT_NE(text_of({"scale.push", {{"stage", "push"}, {"push_m", 2.5}}}, "it").find("\"2.5 mm\""),
            std::string::npos);
  EXPECT_NE(text_of({"scatter.odd",
                     {{"key", "x.cov"}, {"cov", 2.5}, {"cov_percent", 250}, {"share", 0.025}}},
                    "fr")
                .find("x.cov = 0.025"),
            std::string::npos);
  const Message place{"block.toppled",
                      {{"block", "b"}, {"tilt_degrees", 90}, {"time_s", 1.25}, {"stage", "push"}}};
  EXPECT_NE(text_of(place, "de").find("1,250"), std::string::npos);
}

TEST(Message, holds_others_and_lists_of_them) {
  const Message part{"part.shows",
                     {{"part", Message{"part.left_pier"}},
                      {"signs", {Message{"sign.rocking"}, Message{"sign.flexural"}}}}};
  EXPECT_EQ(text_of({"mode.parts", {{"parts", {part, part}}}}),
            "left pier: rocking, flexural crack; left pier: rocking, flexural crack");
  EXPECT_EQ(text_of(part, "it"), "maschio sinistro: oscillazione, fessura flessionale");
}

TEST(Message, of_an_unknown_code_or_language_is_still_readable) {
  EXPECT_EQ(text_of({"no.such_code"}), "no.such_code");
  EXPECT_EQ(text_of({"event.peak"}, "tlh"), "peak");
  EXPECT_EQ(text_of({}), "");
  EXPECT_EQ(text_of({"event.beyond_tension"}), "{body} beyond its tension limit");
}

TEST(Message, words_of_others_stay_as_they_are) {
  const Message theirs = as_text("1.5 {mm} \"x\"");
  EXPECT_EQ(text_of(theirs), "1.5 {mm} \"x\"");
  EXPECT_EQ(text_of(theirs, "it"), text_of(theirs));
  EXPECT_TRUE(as_text("").empty());
}

TEST(Message, numbers_are_found_by_name) {
  EXPECT_DOUBLE_EQ(kUnsettled.number("ratio"), 0.0213);
  EXPECT_TRUE(std::isnan(kUnsettled.number("stage")));
}

// --- as data

TEST(MessageJson, brings_back_what_was_written_to_the_bit) {
  const Message nested{"load.largest_carried", {{"why", kUnsettled}, {"factor", 1.0 / 3}}};
  EXPECT_EQ(message_of(message_json(nested), "unused"), nested);
  const Message nothing =
      message_of(message_json({"load.standstill", {{"factor", std::nan("")}}}), "");
  EXPECT_TRUE(std::isnan(nothing.number("factor")));
}

TEST(MessageJson, what_is_no_known_message_is_its_text) {
  for (const char* json : {"", "{", "7", "{\"code\": 7}", R"({"code": "no.such_code"})"})
    EXPECT_EQ(message_of(json, "as it was"), as_text("as it was")) << json;
  EXPECT_EQ(message_json(as_text("only words")), "");
  EXPECT_EQ(message_json({}), "");
}

TEST(MessageJson, with_an_unknown_part_is_its_text_as_a_whole) {
  const Message half{"load.largest_carried", {{"why", Message{"no.such_code"}}, {"factor", 0.5}}};
  EXPECT_EQ(message_of(message_json(half), "as it was"), as_text("as it was"));
  const Message silent{"load.largest_carried", {{"why", Message{}}, {"factor", 0.5}}};
  EXPECT_EQ(message_of(message_json(silent), "as it was"), silent);
}

TEST(MessageJson, of_a_damaged_store_is_still_said) {
  const std::string swapped =
      R"({"code": "until.measures", "arguments": {"list": 7.5}})";  // a number for a list
  EXPECT_NE(text_of(message_of(swapped, "")).find("7.5"), std::string::npos);
  const std::string named = R"({"code": "stop.budget_spent", "arguments": {"steps": "many"}})";
  EXPECT_EQ(text_of(message_of(named, "")), "many steps spent");
}

// --- the table and the sources

using Table = std::map<std::string, std::vector<std::string>>;
constexpr std::string_view kPage = ".page";  // words of a code in which a page has no keys

Table words() { return nlohmann::json::parse(kMessagesJson)["messages"].get<Table>(); }

// Names of the places of a text, with their formats: {"ratio:.2g", ...}.
std::multiset<std::string> places_in(const std::string& text) {
  static const std::regex kPlace(R"(\{([^}]*)\})");
  std::multiset<std::string> places;
  for (std::sregex_iterator at(text.begin(), text.end(), kPlace), end; at != end; ++at)
    places.insert((*at)[1]);
  return places;
}

std::set<std::string> names_in(const std::string& text) {
  std::set<std::string> names;
  for (const std::string& place : places_in(text)) names.insert(place.substr(0, place.find(':')));
  return names;
}

std::vector<std::string> sources() {
  std::vector<std::string> all;
  for (const char* folder : {"include", "src", "apps"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir()) / folder)) {
      const std::string kind = entry.path().extension().string();
      if ((kind != ".cpp" && kind != ".h") || entry.path().filename() == "message.h")
        continue;  // its examples are no messages
      std::stringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      all.push_back(text.str());
    }
  return all;
}

TEST(MessageTable, every_code_has_words_in_every_language_with_the_same_arguments) {
  const std::size_t languages = message_languages().size();
  ASSERT_GE(languages, 2U);
  for (const auto& [code, texts] : words()) {
    ASSERT_EQ(texts.size(), languages) << code;
    for (const std::string& text : texts) {
      EXPECT_FALSE(text.empty()) << code;
      EXPECT_EQ(places_in(text), places_in(texts.front())) << code << ": " << text;
    }
  }
}

// Text that a reader may copy is the same in all languages.
TEST(MessageTable, keys_with_their_values_and_options_are_not_translated) {
  static const std::regex kCode(R"([a-z_.]+ = "[^"]*"|--[a-z-]+)");
  int found = 0;
  for (const auto& [code, texts] : words())
    for (std::sregex_iterator at(texts.front().begin(), texts.front().end(), kCode), end; at != end;
         ++at, ++found)
      for (const std::string& text : texts)
        EXPECT_NE(text.find(at->str()), std::string::npos) << code << ": " << text;
  EXPECT_GT(found, 20);
}

TEST(MessageTable, every_code_is_used) {
  std::string all;
  for (const std::string& text : sources()) all += text;
  for (const auto& [code, texts] : words())
    EXPECT_TRUE(code.ends_with(kPage) || all.find('"' + code + '"') != std::string::npos)
        << code << " is used nowhere";
}

// A page is read by who types no file and no command.
TEST(MessageTable, words_for_a_page_say_what_those_they_stand_for_say_and_no_keys) {
  static const std::regex kKey(R"(\b[a-z]+_[a-z]+|--[a-z]|wythe |\[[a-z.]+\]| = ")");
  const Table table = words();
  for (const auto& [code, texts] : table) {
    if (!code.ends_with(kPage)) continue;
    const auto base = table.find(code.substr(0, code.size() - kPage.size()));
    ASSERT_NE(base, table.end()) << code;
    const auto said = names_in(texts.front()), whole = names_in(base->second.front());
    EXPECT_TRUE(std::includes(whole.begin(), whole.end(), said.begin(), said.end())) << code;
    for (const std::string& text : texts)
      EXPECT_FALSE(
          std::regex_search(std::regex_replace(text, std::regex(R"(\{[^}]*\})"), ""), kKey))
          << code << ": " << text;
  }
}

// {"group.what"} and {"group.what", {{...}}}, also behind ? and :, as messages are written.
TEST(MessageTable, every_code_that_is_used_is_there) {
  static const std::regex kCode(R"((?:\{|\? |: )\"([a-z]+\.[a-z0-9_]+)\"\s*(?:\}|,\s*\{\{|:|;))");
  const Table table = words();
  std::set<std::string> groups;
  for (const auto& [code, texts] : table) groups.insert(code.substr(0, code.find('.')));
  int found = 0;
  for (const std::string& text : sources())
    for (std::sregex_iterator at(text.begin(), text.end(), kCode), end; at != end; ++at) {
      const std::string code = (*at)[1];
      if (!groups.contains(code.substr(0, code.find('.')))) continue;
      ++found;
      EXPECT_TRUE(table.contains(code)) << code << " has no words";
    }
  EXPECT_GT(found, 50);
}

// Arguments as they stand behind a code: {"code", {{"a", ...}, {"b", ...}}}. Those of messages made in
// several steps (emplace_back) stand in the same file.
TEST(MessageTable, arguments_are_those_of_the_words) {
  static const std::regex kName(R"re(\{\s*"([A-Za-z_0-9]+)",)re");
  static const std::regex kAdded(R"re(emplace_back\("([A-Za-z_0-9]+)",)re");
  const Table table = words();
  int checked = 0;
  for (const std::string& text : sources())
    for (const auto& [code, texts] : table) {
      if (code == "text") continue;  // as_text() alone makes it
      for (std::size_t at = 0; (at = text.find("{\"" + code + "\"", at)) != std::string::npos;
           ++at) {
        const std::set<std::string> wanted = names_in(texts.front());
        // to the brace that closes the message
        std::size_t end = at;
        for (int depth = 0; end < text.size(); ++end) {
          depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
          if (depth == 0) break;
        }
        const std::string call = text.substr(at + 1, end - at);
        std::set<std::string> given;
        for (std::sregex_iterator n(call.begin(), call.end(), kName), none; n != none; ++n)
          given.insert((*n)[1]);
        for (std::sregex_iterator n(text.begin(), text.end(), kAdded), none; n != none; ++n)
          if (wanted.contains((*n)[1])) given.insert((*n)[1]);
        for (const std::string& name : wanted)
          EXPECT_TRUE(given.contains(name)) << code << " lacks " << name << ": " << call;
        const bool holds_others = call.find("Message{") != std::string::npos;
        for (const std::string& name : given)
          EXPECT_TRUE(holds_others || wanted.contains(name))
              << code << " has no place for " << name;
        ++checked;
      }
    }
  EXPECT_GT(checked, 50);
}

}  // namespace
}  // namespace wythe::message_test
