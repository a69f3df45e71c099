// Writes each member of a struct as a line "key = value", and a model spec as a complete TOML text. A quantity
// has its key's unit, or SI if only that reads back to the same bits. An unset one (NaN) has no line. Fields
// that [scatter] creates when the model is read are left out; a field that differs from them is written.
#include "io/text/toml_writer.h"
#include "campaign/draws/scatter.h"
#include "core/ascii.h"
#include "core/text.h"
#include "io/keys/same_spec.h"

#include <algorithm>
#include <cmath>

#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {
namespace {

std::string escaped(char c) {
  switch (c) {
    case '"': return "\\\"";
    case '\\': return "\\\\";
    case '\n': return "\\n";
    case '\t': return "\\t";
    case '\r': return "\\r";
    default: break;
  }
  const auto code = static_cast<unsigned char>(c);
  const bool control = code < 0x20 || code == 0x7f;
  return control ? fmt::format("\\u{:04X}", code) : std::string(1, c);
}

template <class Items, class Text>
std::string list_text(const Items& items, Text text) {
  std::string out = "[";
  for (const auto& item : items) out += (out.size() > 1 ? ", " : "") + text(item);
  return out + "]";
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += escaped(c);
  return out + '"';
}

std::string key_text(const std::string& name) {
  const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return is_ascii_letter(c) || is_digit(c) || c == '_' || c == '-';
  });
  return bare ? name : quoted(name);
}

void Writer::put(const char* name, std::string value, const Key& key) {
  const bool foreign = kind_ != 0 && key.kinds != 0 && !(key.kinds & kind_);
  if (!foreign) lines_.emplace_back(name, std::move(value));
}

void Writer::quantity(const char* name, const double& value, const Key& key) {
  if (std::isnan(value)) return;
  put(name, quoted(format_quantity(value, key.unit, key.shown)), key);
}

void Writer::quantities(const char* name, const std::vector<double>& values, const Key& key) {
  if (values.empty()) return;
  put(name,
      list_text(values,
                [&](double value) { return quoted(format_quantity(value, key.unit, key.shown)); }),
      key);
}

void Writer::points(const char* name, const std::vector<std::array<double, 2>>& points,
                    const Key& key) {
  if (points.empty()) return;
  const auto coordinate = [&](double x) { return quoted(format_quantity(x, key.unit, key.shown)); };
  put(name, list_text(points, [&](const auto& point) { return list_text(point, coordinate); }),
      key);
}

namespace {

// TOML reads -0 as the integer 0, so a negative zero needs its point.
std::string bare(double value) {
  return value == 0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

}  // namespace

void Writer::number(const char* name, const double& value, const Key& key) {
  if (!std::isnan(value)) put(name, bare(value), key);
}

void Writer::numbers(const char* name, const std::vector<double>& values, const Key& key) {
  if (!values.empty()) put(name, list_text(values, bare), key);
}

void Writer::integer(const char* name, const int& value, const Key& key) {
  if (value == 0 && *key.fallback != '\0') return;  // not given
  put(name, std::to_string(value), key);
}

void Writer::flag(const char* name, const bool& value, const Key& key) {
  put(name, value ? "true" : "false", key);
}

// An empty text is left out only where absence means the same, so where the key has no default.
void Writer::text(const char* name, const std::string& value, const Key& key) {
  if (!value.empty() || *key.fallback == '\0') put(name, quoted(value), key);
}

void Writer::texts(const char* name, const std::vector<std::string>& values, const Key& key) {
  if (key.count > 0) return put(name, list_text(values, quoted), key);
  std::string lines;  // one sentence in each line
  for (const std::string& value : values) lines += "  " + quoted(value) + ",\n";
  if (!lines.empty()) put(name, "[\n" + lines + "]", key);
}

std::string Writer::text() const {
  std::string out;
  for (const auto& [name, value] : lines_) out += name + " = " + value + '\n';
  return out + below_;
}

std::string Writer::in_braces() const {
  std::string out;
  for (const auto& [name, value] : lines_) out += (out.empty() ? "" : ", ") + name + " = " + value;
  return "{ " + out + " }";
}

}  // namespace io

namespace {

// Removes the fields that [scatter] creates in the same form.
void drop_scatter(ModelSpec& spec) {
  if (!spec.scatter.is_asked()) return;
  const auto is_own = [](const auto& field) {
    return field.first.starts_with(study::kScatterPrefix);
  };
  ModelSpec again = spec;
  std::erase_if(again.field, is_own);
  FaultList faults;
  study::add_scatter(
      again,
      [&](const std::string& path) {
        return std::any_of(spec.field.begin(), spec.field.end(), [&](const auto& field) {
          return is_own(field) && field.second.path == path;
        });
      },
      faults);
  std::erase_if(spec.field, [&](const auto& field) {
    const auto made = again.field.find(field.first);
    return is_own(field) && made != again.field.end() &&
           io::flatten(field.second) == io::flatten(made->second);
  });
}

}  // namespace

std::string write_model(const ModelSpec& spec) {
  ModelSpec copy = spec;  // one description serves readers and writers, so it takes T&
  drop_scatter(copy);     // [scatter] makes these fields again
  io::Writer writer("");
  describe(writer, copy);
  const std::string text = writer.text();
  return text.starts_with('\n') ? text.substr(1) : text;
}

}  // namespace wythe
