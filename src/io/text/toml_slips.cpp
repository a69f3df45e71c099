// Looks for known mistakes in the line at which the parser stopped. The first that fits is reported, so the order
// matters: habits of other formats, keys, numbers, quotes. The cure shows the correct line. Texts in quotes are
// masked in the search for marks.
#include "io/text/toml_slips.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/ascii.h"
#include "core/text.h"

namespace wythe::io {
namespace {

// A line without its comment; quotes of either kind may contain a #.
std::string_view without_comment(std::string_view line) {
  char open = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (open == '"' && line[i] == '\\')
      ++i;
    else if (open != '\0')
      open = line[i] == open ? '\0' : open;
    else if (line[i] == '"' || line[i] == '\'')
      open = line[i];
    else if (line[i] == '#')
      return line.substr(0, i);
  }
  return line;
}

// Masks texts in quotes, because their characters have no meaning in TOML.
std::string outside_quotes(std::string_view line) {
  std::string out(line);
  char open = '\0';
  for (char& c : out) {
    const char own = c;
    if (open != '\0' || own == '"' || own == '\'') c = '_';
    if (open != '\0')
      open = own == open ? '\0' : open;
    else if (own == '"' || own == '\'')
      open = own;
  }
  return out;
}

// Habits of other formats: marks at the end of a line, comments, colons, booleans.
Slip foreign_mark(std::string_view line) {
  std::string bare = outside_quotes(line);
  const auto without = [&](std::size_t from, std::size_t count) {
    std::string cured(line);
    return std::string(trimmed(cured.erase(from, count)));
  };
  if (const std::size_t slashes = bare.find("//"); slashes != std::string::npos && slashes > 0)
    return {
        "has // where a remark begins with #",
        fmt::format("write {}  #{}", trimmed(line.substr(0, slashes)), line.substr(slashes + 2))};
  const bool in_list =
      std::count(bare.begin(), bare.end(), '[') > std::count(bare.begin(), bare.end(), ']');
  if (bare.starts_with('=')) return {"has no key before its =", "write key = value"};
  const bool is_open =
      std::count(bare.begin(), bare.end(), '{') > std::count(bare.begin(), bare.end(), '}');
  if (is_open && bare.ends_with(','))
    return {"has no } in its line", "write { ... } in one line, or its keys under a [table]"};
  for (const std::size_t comma : {bare.find(", }"), bare.find(",}")})
    if (comma != std::string::npos && !is_open &&
        std::count(bare.begin(), bare.end(), '{') == std::count(bare.begin(), bare.end(), '}'))
      return {"has a comma before its }", "write " + without(comma, 1)};
  if (bare.ends_with(';') ||
      (bare.ends_with(',') && !in_list && bare.find('=') != std::string::npos))
    return {fmt::format("ends with a {}", bare.back()), "write " + without(line.size() - 1, 1)};
  if (bare.starts_with('[') && bare.find('=') == std::string::npos) {
    std::string cured(line);
    const bool wrong = cured.find_first_of(",/:") != std::string::npos;
    for (char& c : cured)
      if (c == ',' || c == '/' || c == ':') c = '.';
    return wrong ? Slip{"parts of a name stand with a dot between them", "write " + cured} : Slip{};
  }
  const std::size_t equals = bare.find('='), colon = bare.find(':');
  if (colon != std::string::npos &&
      (equals == std::string::npos || colon < equals || bare.find('{') < colon)) {
    std::string cured(line);
    const bool blank = cured[colon - (colon > 0 ? 1 : 0)] == ' ';
    return {"has a : where TOML has =", "write " + cured.replace(colon, 1, blank ? "=" : " =")};
  }
  for (const auto& [theirs, ours] : {std::pair{"True", "true"},
                                     {"False", "false"},
                                     {"TRUE", "true"},
                                     {"FALSE", "false"},
                                     {"yes", "true"},
                                     {"no", "false"},
                                     {"on", "true"},
                                     {"off", "false"}}) {
    const std::string_view word(theirs);
    const std::size_t at = bare.rfind(word);
    if (equals == std::string::npos || at == std::string::npos || at < equals) continue;
    // the whole value, not one word of a text without quotes
    const std::size_t before = bare.find_last_not_of(' ', at - 1);
    const std::size_t after = bare.find_first_not_of(' ', at + word.size());
    const bool is_inner = bare.find_first_of("[{", equals) < at;  // of a list or a table in braces
    const std::string_view begins = is_inner ? "=[," : "=", ends = is_inner ? "}]," : "";
    if (begins.find(bare[before]) == std::string_view::npos ||
        (after != std::string::npos && ends.find(bare[after]) == std::string_view::npos))
      continue;
    std::string cured(line);
    return {fmt::format("has {} where TOML has {}", theirs, ours),
            "write " + cured.replace(at, word.size(), ours)};
  }
  if (std::count(bare.begin(), bare.end(), '{') > std::count(bare.begin(), bare.end(), '}'))
    return {"has no } in its line", "write { ... } in one line"};
  return {};
}

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](std::string_view start) { return text.starts_with(start); });
}

// Files and remarks of other formats, and headers of tables.
Slip foreign_line(std::string_view line) {
  if (line.starts_with('{'))
    return {"is JSON, it seems, and a model is TOML",
            "write tables as [wall] and values as key = value"};
  if (line.starts_with('<'))
    return {"is XML, it seems, and a model is TOML",
            "write tables as [wall] and values as key = value"};
  if (starts_with_any(line, {";", "%", "//", "/*", "!", "--"}))
    return {"begins with a mark of remarks that TOML has not",
            fmt::format("write # {}", trimmed(line.substr(line.find_first_not_of(";%/*!- "))))};
  const bool is_head = line.starts_with('[') && line.find('=') == std::string_view::npos;
  const std::size_t name = line.find_first_not_of("[] ");
  if (is_head && name == std::string_view::npos) return {"names no table", "write e.g. [wall]"};
  if (is_head && line.starts_with("[[") && line.ends_with(']') && !line.ends_with("]]"))
    return {"has one ] where two belong", fmt::format("write {}]", line)};
  if (line.ends_with(':') && line.find_first_of("=[{\"") == std::string_view::npos)
    return {"is YAML, it seems, and a model is TOML",
            fmt::format("write [{}]", line.substr(0, line.size() - 1))};
  return {};
}

// A key that is not valid in TOML.
Slip wrong_key(const std::string& key, std::string_view value) {
  if (key.empty() || key.find_first_of("[]{}") != std::string::npos) return {};
  const auto quotes = std::count(key.begin(), key.end(), '"');
  std::string cured = key;
  if (quotes == 1) {
    std::erase(cured, '"');
    return {"lacks a quote", fmt::format("write {} = {}", cured, value)};
  }
  if (quotes > 0 || key.find('\'') != std::string::npos) return {};
  if (key.find("..") != std::string::npos || key.ends_with('.') || key.starts_with('.'))
    return {"has a part without a name in its key", "write one dot between two names"};
  if (const std::size_t blank = key.find_first_of(" \t");
      blank != std::string::npos && key.find('.') == std::string::npos) {
    std::replace(cured.begin(), cured.end(), ' ', '_');
    return {"has a blank in its key", fmt::format("write {} = {}", cured, value)};
  }
  const bool is_ascii = std::all_of(key.begin(), key.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (!is_ascii)
    return {"has a letter in its key that no key has", "write the key with letters of English"};
  return {};
}

// A number that is not valid in TOML, "30." or ".5"; `key` for the cure.
Slip wrong_number(const std::string& key, std::string_view value) {
  const bool has_sign = value.starts_with('-') || value.starts_with('+');
  std::string digits(value.substr(has_sign ? 1 : 0));
  const std::string sign(value.substr(0, has_sign ? 1 : 0));
  if (digits.empty() || digits.find_first_not_of("0123456789._") != std::string::npos) return {};
  const std::string was = digits;
  std::erase(digits, '_');
  if (digits.starts_with('.')) digits = "0" + digits;
  if (digits.ends_with('.')) digits += "0";
  while (digits.size() > 1 && digits[0] == '0' && is_digit(digits[1])) digits.erase(0, 1);
  if (std::count(digits.begin(), digits.end(), '.') > 1)
    return {"has several points in a number", "write one point, before the decimals"};
  if (digits == was)
    return digits.size() > 18 && digits.find('.') == std::string::npos
               ? Slip{"is larger than a whole number may be", fmt::format("write {} = 1e30", key)}
               : Slip{};
  return {"is no number as TOML has them",
          fmt::format("write {0} = {1}{2}, or {0} = \"{1}{2} UNIT\" for a quantity", key, sign,
                      digits)};
}

bool has_any(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::any_of(parts.begin(), parts.end(), [&](std::string_view part) {
    return text.find(part) != std::string_view::npos;
  });
}

// A number with a unit and without quotes: "1.0 m", "-2 mm/s".
bool is_bare_quantity(std::string_view value) {
  std::size_t i = value.starts_with('-') || value.starts_with('+') ? 1 : 0;
  const std::size_t first = i;
  while (i < value.size() && (is_digit(value[i]) || value[i] == '.')) ++i;
  return i > first && i < value.size() &&
         (is_ascii_letter(value[i]) || value[i] == ' ' || value[i] == '%');
}

}  // namespace

Slip slip_in(std::string_view written) {
  const std::string_view line = trimmed(without_comment(written));
  if (has_any(line, {"“", "”", "„", "‘", "’", "«", "»"}))
    return {"has quotes of a text program", "write straight ones: \""};
  if (const Slip foreign = foreign_line(line); !foreign.problem.empty()) return foreign;
  if (line.starts_with('[') && !line.ends_with(']') && line.find('=') == std::string_view::npos)
    return {"has no ] at its end",
            fmt::format("write {}]{}", line, line.starts_with("[[") ? "]" : "")};
  if (const Slip mark = foreign_mark(line); !mark.problem.empty()) return mark;
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos)
    return line.starts_with('[') ? Slip{} : Slip{"has no =", "write key = value"};
  const std::string key(trimmed(line.substr(0, equals)));
  const std::string_view value = trimmed(line.substr(equals + 1));
  if (value.starts_with('='))
    return {"has == where TOML has =", fmt::format("write {} = {}", key, trimmed(value.substr(1)))};
  if (const Slip wrong = wrong_key(key, value); !wrong.problem.empty()) return wrong;
  if (starts_with_any(value, {"–", "—", "−"}))
    return {"has a dash of a text program", "write a minus sign: -"};
  if (value.starts_with("\"\"\""))
    return {"has no \"\"\" at its end", "write the text between two \""};
  if (std::count(value.begin(), value.end(), '\'') == 1 &&
      value.find('"') == std::string_view::npos)
    return {"lacks a quote", "write each text between two quotes"};
  if (const Slip wrong = wrong_number(key, value); !wrong.problem.empty()) return wrong;
  const bool is_plain = !value.empty() && value.find_first_of("[]{}'") == std::string_view::npos;
  const auto quotes = std::count(value.begin(), value.end(), '"');
  if (is_plain && quotes == 1) {
    const std::string inner(trimmed(
        value.substr(value.starts_with('"') ? 1 : 0,
                     value.size() - (value.starts_with('"') || value.ends_with('"') ? 1 : 0))));
    return {"lacks a quote", fmt::format("write {} = \"{}\"", key, inner)};
  }
  if (value.empty()) return {"has no value", "write key = value"};
  if (quotes % 2 == 1) return {"lacks a quote", "write each text between two quotes"};
  if (is_plain && quotes == 2 && value.starts_with('"') && value.ends_with('"') &&
      value.find('\\') != std::string_view::npos) {
    std::string path(value);
    std::replace(path.begin(), path.end(), '\\', '/');
    return {"has a \\ in double quotes, which begins a character such as a tab",
            fmt::format("write {} = {}, or single quotes", key, path)};
  }
  if (const std::size_t last = value.rfind('"');
      is_plain && quotes == 2 && value.starts_with('"') && last + 1 < value.size())
    return {"goes on behind its quotes",
            fmt::format("write {} = \"{} {}\"", key, trimmed(value.substr(1, last - 1)),
                        trimmed(value.substr(last + 1)))};
  if (is_plain && quotes == 0) {
    std::string number(value);
    const std::size_t comma = number.find(',');
    if (comma != std::string::npos && comma > 0 && comma + 1 < number.size() &&
        is_digit(number[comma - 1]) && is_digit(number[comma + 1])) {
      number[comma] = '.';
      if (is_bare_quantity(number))
        return {"has a decimal comma", fmt::format("write {} = \"{}\"", key, number)};
      return {"has a decimal comma",
              fmt::format("write {0} = {1}, or {0} = \"{1} UNIT\" for a quantity", key, number)};
    }
    if (is_bare_quantity(value))
      return {"is a quantity without quotes", fmt::format("write {} = \"{}\"", key, value)};
    const bool has_sign = value.size() > 1 && (value[0] == '+' || value[0] == '-');
    if (is_ascii_letter(value[has_sign ? 1 : 0]))
      return {"is a text without quotes", fmt::format("write {} = \"{}\"", key, value)};
  }
  return {};
}

Slip stated_twice(std::string_view written, std::string_view description) {
  const std::size_t open = description.find('\'');
  const std::size_t close = description.find('\'', open + 1);
  if (description.find("cannot redefine") == std::string_view::npos ||
      close == std::string_view::npos)
    return {};
  const std::string_view name = description.substr(open + 1, close - open - 1);
  const std::string problem = fmt::format("states {} a second time", name);
  if (!trimmed(without_comment(written)).starts_with('[')) return {problem, "leave one of them"};
  return {problem,
          fmt::format("put both under one [{0}]; several of a list are each under [[{0}]], "
                      "with two brackets",
                      name)};
}

Slip slip_of_parser(std::string_view description) {
  const auto says = [&](std::string_view words) {
    return description.find(words) != std::string_view::npos;
  };
  if (says("cannot insert")) {
    const std::size_t open = description.find('\''), close = description.find('\'', open + 1);
    const std::string name(
        close == std::string_view::npos ? "table" : description.substr(open + 1, close - open - 1));
    return {fmt::format("adds {} to a table in {{ }} above, which is complete", name),
            "write it within these { }"};
  }
  if (says("end-of-file"))
    return {"ends within a text or a list", "close what is open above: \"\"\", ] or }"};
  if (says("parsing array"))
    return {"stands within a list that is not closed", "write ] at the end of the list above"};
  if (says("control characters"))
    return {"has a control character within a text", "delete it, or write the text anew"};
  if (says("parsing date") || says("parsing time"))
    return {"is read as a date or a time", "write it in quotes"};
  if (says("expected '\\n' after '\\r'"))
    return {"has line ends of old Macs, CR alone", "save it with line ends of today, LF or CR LF"};
  return {
      "cannot be read",
      "write each line as key = value or [table]: texts and quantities in quotes, lists in [ ]"};
}

std::string path_as_meant(std::string_view path) {
  constexpr std::string_view kMarks = "\b\t\n\f\r\x1b", kLetters = "btnfre";
  if (path.find_first_of(kMarks) == std::string_view::npos) return "";
  std::string meant;
  for (const char c : path) {
    const std::size_t mark = kMarks.find(c);
    if (mark != std::string_view::npos)
      (meant += '/') += kLetters[mark];
    else
      meant += c == '\\' ? '/' : c;
  }
  return meant;
}

}  // namespace wythe::io
