// Notes of one code become one line: what they share once, then what differs, as a list of things or as rows.
#include "notes.h"

#include <algorithm>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/result.h"

namespace wythe::app {
namespace {

// The different parts of texts that begin and end alike, in whole words.
std::vector<std::string> differing(const std::vector<std::string>& texts) {
  const std::string& first = texts.front();
  std::size_t begin = first.size(), end = first.size();
  for (const std::string& text : texts) {
    const auto [a, b] = std::mismatch(first.begin(), first.end(), text.begin(), text.end());
    begin = std::min(begin, static_cast<std::size_t>(a - first.begin()));
    const auto [c, d] = std::mismatch(first.rbegin(), first.rend(), text.rbegin(), text.rend());
    end = std::min(end, static_cast<std::size_t>(c - first.rbegin()));
  }
  begin = begin == 0 ? 0 : first.rfind(' ', begin - 1) + 1;
  while (end > 0 && first[first.size() - end] != ' ' && first[first.size() - end] != ':') --end;
  std::vector<std::string> out;
  for (const std::string& text : texts)
    out.push_back(begin + end < text.size() ? text.substr(begin, text.size() - begin - end) : text);
  return out;
}

std::string opening_of(const Message& note) {
  for (const Argument& argument : note.arguments)
    if (const auto* of = std::get_if<std::vector<Message>>(&argument.value);
        of && argument.name == "opening" && !of->empty())
      return text_of(of->front());
  return "";
}

// Sizes that were fitted, one opening in each row.
void print_rows(const std::vector<Message>& members) {
  std::string owner;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::string text = text_of(members[i]), own = opening_of(members[i]);
    if (!own.empty() && own == owner && text.starts_with(own + ' '))
      fmt::print(", {}", readable(text.substr(own.size() + 1)));
    else
      fmt::print("{}  {}", i == 0 ? "" : "\n", readable(text));
    owner = own;
  }
  fmt::print("\n");
}

// For one note about many things: only the things.
void print_things(const std::vector<Message>& members) {
  std::vector<std::string> texts;
  for (const Message& member : members) texts.push_back(text_of(member));
  std::string line;
  for (const std::string& thing : differing(texts)) line += (line.empty() ? "" : "; ") + thing;
  fmt::print("  {}\n", readable(line));
}

}  // namespace

void print_doubt(const Model& model, const Result& result) {
  if (const Message of_force = warning_of(result); !of_force.empty())
    fmt::print("WARNING {}\n", text_of(of_force));
  else if (const Message of_drift = warning_of(model, result); !of_drift.empty())
    fmt::print("note: {}\n", text_of(of_drift));
}

void print_notes(const std::vector<Message>& notes, bool with_tables) {
  for (const NoteGroup& group : grouped(notes)) {
    fmt::print("note: {}\n", readable(text_of(group.line)));
    if (!with_tables || group.members.empty()) continue;
    group.line.code == "notes.alike" ? print_things(group.members) : print_rows(group.members);
  }
}

}  // namespace wythe::app
