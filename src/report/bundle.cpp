// Packs a header and aligned arrays into deflated bytes, and reads the header of such bytes. The origin of bytes
// that are read is unknown. So unpacking stops at the sizes that the header states, and data too large for a browser
// are refused before they are unpacked. Arrays are stored as in memory, so the build requires little endian.
#include "report/bundle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/decimal_point.h"
#include "core/limits.h"
#include "core/shape.h"
#include "report/deflate.h"
#include "wythe/parts/error.h"

namespace wythe::report {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are stored as they lie");

constexpr char kMark[8] = {'W', 'Y', 'T', 'H', 'E', 0, 0, 2};  // the last byte is the version
constexpr std::size_t kHead = sizeof kMark + sizeof(std::uint32_t);
constexpr std::size_t kAlign = 8;

// Packed bytes that are unpacked only on demand, because a few of them may stand for very many.
class Inflation {
 public:
  explicit Inflation(std::string_view packed) : inflater_(packed) {
    if (packed.size() > kMostPacked) refuse_data("are larger than a browser takes");
  }

  // The next bytes, exactly `count` of them.
  std::string next(std::size_t count) {
    std::string out(count, '\0');
    if (inflater_.read(out) != count) refuse_data("are damaged");
    return out;
  }
  // Whether exactly `count` bytes are left, including checksums; none of them is kept.
  bool ends_after(std::size_t count) {
    std::string chunk(1 << 18, '\0');
    while (count > chunk.size()) {
      if (inflater_.read(chunk) != chunk.size()) return false;
      count -= chunk.size();
    }
    chunk.resize(count + 1);
    return inflater_.read(chunk) == count && inflater_.ended();
  }

 private:
  Inflater inflater_;
};
// Size of all arrays in bytes, as the header places them.
std::size_t bytes_of_arrays(const Json& arrays) {
  double end = 0;
  for (const auto& [name, array] : arrays.items()) {
    const std::string type = array.at("type");
    const double size = type == "float32" || type == "int32" ? 4 : type == "int16" ? 2 : 1;
    end = std::max(end, array.at("at").get<double>() + size * array.at("count").get<double>());
  }
  if (!(end <= kMostPacked)) refuse_data("unpack to more than a browser takes (512 MB)");
  return (static_cast<std::size_t>(end) + kAlign - 1) / kAlign * kAlign;
}

}  // namespace

void Bundle::place(const std::string& name, const char* type, std::size_t count,
                   std::span<const std::byte> bytes) {
  table_[name] = {{"type", type}, {"at", arrays_.size()}, {"count", count}};
  arrays_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  arrays_.resize((arrays_.size() + kAlign - 1) / kAlign * kAlign, '\0');
}

void Bundle::add(const std::string& name, std::span<const float> values) {
  place(name, "float32", values.size(), std::as_bytes(values));
}

void Bundle::add(const std::string& name, std::span<const std::int32_t> values) {
  place(name, "int32", values.size(), std::as_bytes(values));
}

void Bundle::add(const std::string& name, std::span<const std::uint8_t> values) {
  place(name, "uint8", values.size(), std::as_bytes(values));
}

void Bundle::add_rounded(const std::string& name, std::span<const double> values) {
  add_rounded(name, values, 1);
  table_[name]["step"] = table_[name]["steps"][0];
  table_[name].erase("steps");
}

void Bundle::add_rounded(const std::string& name, std::span<const double> values, int rows) {
  constexpr double kMost = 32767;
  const std::size_t width = rows > 0 ? values.size() / static_cast<std::size_t>(rows) : 0;
  std::vector<std::int16_t> rounded;
  rounded.reserve(values.size());
  Json steps = Json::array();
  for (int row = 0; row < rows; ++row) {
    const auto part = values.subspan(static_cast<std::size_t>(row) * width, width);
    double largest = 0;
    for (double v : part)
      if (std::isfinite(v)) largest = std::max(largest, std::fabs(v));
    const double step = largest > 0 ? largest / kMost : 1;
    for (double v : part)
      rounded.push_back(std::isfinite(v) ? static_cast<std::int16_t>(std::lround(v / step)) : 0);
    steps.push_back(step);
  }
  place(name, "int16", rounded.size(), std::as_bytes(std::span(rounded)));
  table_[name]["steps"] = steps;
}

std::string Bundle::packed() const {
  Json whole = header;
  whole["arrays"] = table_;
  // "replace", so that a name that is not UTF-8 does not lose the page
  std::string text = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.append((kAlign - (kHead + text.size()) % kAlign) % kAlign, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string bytes(kMark, sizeof kMark);
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  return deflated(bytes + text + arrays_);
}

void refuse_data(const std::string& what) {
  throw IoError("the data of a report " + what + "; run the model again to write them anew");
}

std::uint8_t share_byte(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

Json header_of(std::string_view packed) {
  Inflation data(packed);
  const std::string head = data.next(kHead);
  if (std::memcmp(head.data(), kMark, 5) != 0) refuse_data("are damaged");
  if (std::memcmp(head.data(), kMark, sizeof kMark) != 0)
    refuse_data("were written by another version of wythe");
  std::uint32_t length = 0;
  std::memcpy(&length, head.data() + sizeof kMark, sizeof length);
  if (length > kMostJson) refuse_data("are damaged");
  try {
    const std::string text = data.next(length);
    check_shape(text, Syntax::kJson, "");
    const DecimalPoint point;
    Json header = Json::parse(text);
    if (!header.contains("kind") || !data.ends_after(bytes_of_arrays(header.at("arrays"))))
      refuse_data("are damaged");
    return header;
  } catch (const InputError&) {
    refuse_data("are damaged");
  } catch (const Json::exception&) {
    refuse_data("are damaged");
  }
}

}  // namespace wythe::report
