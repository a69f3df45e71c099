// Nominal sizes in millimetres, and closed forms of section values in metres (docs/theory/frames.md, 20.9 and 20.10).
// A fillet or rounded corner is a square less a quarter circle. Channels have tabulated values instead.
#include "geometry/wall/profiles.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/ascii.h"
#include "core/elementary.h"
#include "core/text.h"

namespace wythe::geometry {
namespace {

constexpr double kSteel = 7850;  // [kg/m^3], EN 1991-1-1 table A.4

// Millimetres; `r` between web and flange. IPE, HEA, HEB: EN 10365.
struct RolledBeam {
  const char* name;
  double h, b, tw, tf, r;
};
constexpr RolledBeam kBeams[] = {
    {"IPE 80", 80, 46, 3.8, 5.2, 5},       {"IPE 100", 100, 55, 4.1, 5.7, 7},
    {"IPE 120", 120, 64, 4.4, 6.3, 7},     {"IPE 140", 140, 73, 4.7, 6.9, 7},
    {"IPE 160", 160, 82, 5.0, 7.4, 9},     {"IPE 180", 180, 91, 5.3, 8.0, 9},
    {"IPE 200", 200, 100, 5.6, 8.5, 12},   {"IPE 220", 220, 110, 5.9, 9.2, 12},
    {"IPE 240", 240, 120, 6.2, 9.8, 15},   {"IPE 270", 270, 135, 6.6, 10.2, 15},
    {"IPE 300", 300, 150, 7.1, 10.7, 15},  {"IPE 330", 330, 160, 7.5, 11.5, 18},
    {"IPE 360", 360, 170, 8.0, 12.7, 18},  {"IPE 400", 400, 180, 8.6, 13.5, 21},
    {"IPE 450", 450, 190, 9.4, 14.6, 21},  {"IPE 500", 500, 200, 10.2, 16.0, 21},
    {"IPE 550", 550, 210, 11.1, 17.2, 24}, {"IPE 600", 600, 220, 12.0, 19.0, 24},
    {"HEA 100", 96, 100, 5, 8, 12},        {"HEA 120", 114, 120, 5, 8, 12},
    {"HEA 140", 133, 140, 5.5, 8.5, 12},   {"HEA 160", 152, 160, 6, 9, 15},
    {"HEA 180", 171, 180, 6, 9.5, 15},     {"HEA 200", 190, 200, 6.5, 10, 18},
    {"HEA 220", 210, 220, 7, 11, 18},      {"HEA 240", 230, 240, 7.5, 12, 21},
    {"HEA 260", 250, 260, 7.5, 12.5, 24},  {"HEA 280", 270, 280, 8, 13, 24},
    {"HEA 300", 290, 300, 8.5, 14, 27},    {"HEA 320", 310, 300, 9, 15.5, 27},
    {"HEA 340", 330, 300, 9.5, 16.5, 27},  {"HEA 360", 350, 300, 10, 17.5, 27},
    {"HEA 400", 390, 300, 11, 19, 27},     {"HEA 450", 440, 300, 11.5, 21, 27},
    {"HEA 500", 490, 300, 12, 23, 27},     {"HEB 100", 100, 100, 6, 10, 12},
    {"HEB 120", 120, 120, 6.5, 11, 12},    {"HEB 140", 140, 140, 7, 12, 12},
    {"HEB 160", 160, 160, 8, 13, 15},      {"HEB 180", 180, 180, 8.5, 14, 15},
    {"HEB 200", 200, 200, 9, 15, 18},      {"HEB 220", 220, 220, 9.5, 16, 18},
    {"HEB 240", 240, 240, 10, 17, 21},     {"HEB 260", 260, 260, 10, 17.5, 24},
    {"HEB 280", 280, 280, 10.5, 18, 24},   {"HEB 300", 300, 300, 11, 19, 27},
    {"HEB 320", 320, 300, 11.5, 20.5, 27}, {"HEB 340", 340, 300, 12, 21.5, 27},
    {"HEB 360", 360, 300, 12.5, 22.5, 27}, {"HEB 400", 400, 300, 13.5, 24, 27},
    {"HEB 450", 450, 300, 14, 26, 27},     {"HEB 500", 500, 300, 14.5, 28, 27}};

// Millimetres; area [cm2], second moment [cm4], plastic modulus [cm3], weak second moment and torsion constant [cm4] from
// tables. UPN: EN 10365.
struct Channel {
  const char* name;
  double h, b, tw, tf, area, second, plastic, weak, torsion;
};
constexpr Channel kChannels[] = {{"UPN 80", 80, 45, 6, 8, 11.0, 106, 31.8, 19.4, 2.16},
                                 {"UPN 100", 100, 50, 6, 8.5, 13.5, 206, 49.0, 29.3, 2.81},
                                 {"UPN 120", 120, 55, 7, 9, 17.0, 364, 72.6, 43.2, 4.15},
                                 {"UPN 140", 140, 60, 7, 10, 20.4, 605, 103, 62.7, 5.68},
                                 {"UPN 160", 160, 65, 7.5, 10.5, 24.0, 925, 138, 85.3, 7.39},
                                 {"UPN 180", 180, 70, 8, 11, 28.0, 1350, 179, 114, 9.55},
                                 {"UPN 200", 200, 75, 8.5, 11.5, 32.2, 1910, 228, 148, 11.9},
                                 {"UPN 220", 220, 80, 9, 12.5, 37.4, 2690, 292, 197, 16},
                                 {"UPN 240", 240, 85, 9.5, 13, 42.3, 3600, 358, 248, 19.7},
                                 {"UPN 260", 260, 90, 10, 14, 48.3, 4820, 442, 317, 25.5},
                                 {"UPN 280", 280, 95, 10, 15, 53.3, 6280, 532, 399, 31},
                                 {"UPN 300", 300, 100, 10, 16, 58.8, 8030, 632, 495, 37.4}};

// Millimetres; outer radius 1.5 t, inner t. Square tubes, hot finished: EN 10210-2.
struct Tube {
  const char* name;
  double b, t;
};
constexpr Tube kTubes[] = {
    {"SHS 80x5", 80, 5},       {"SHS 80x6.3", 80, 6.3},   {"SHS 100x5", 100, 5},
    {"SHS 100x6.3", 100, 6.3}, {"SHS 100x8", 100, 8},     {"SHS 120x5", 120, 5},
    {"SHS 120x6.3", 120, 6.3}, {"SHS 120x8", 120, 8},     {"SHS 140x6.3", 140, 6.3},
    {"SHS 140x8", 140, 8},     {"SHS 150x6.3", 150, 6.3}, {"SHS 150x8", 150, 8},
    {"SHS 160x8", 160, 8},     {"SHS 180x8", 180, 8},     {"SHS 200x8", 200, 8},
    {"SHS 200x10", 200, 10}};

// The part of a square r x r outside a quarter circle of radius r: area, distance of its centroid from the outer
// sides of the square, second moment about that centroid.
struct Fillet {
  double area, from_side, second;
};
Fillet fillet(double r) {
  const double area = (1 - std::numbers::pi / 4) * r * r;
  const double first =
      (0.5 - (std::numbers::pi / 4 - 1.0 / 3)) * r * r * r;  // square less quarter of a circle
  const double from_side = area > 0 ? first / area : 0;
  // second moments about the outer side: square r^4/3, quarter circle with its centre at distance r
  const double quarter = std::numbers::pi / 16 - 2.0 / 3 + std::numbers::pi / 4;
  return {area, from_side, (1.0 / 3 - quarter) * r * r * r * r - area * from_side * from_side};
}

// All in millimetres.
struct Values {
  double h, b, area, shear, second, plastic, weak, torsion, weak_shear;
};
Section in_metres(const Values& v) {
  return {1e-3 * v.h,        1e-3 * v.b,         1e-6 * v.area,          1e-6 * v.shear,
          1e-12 * v.second,  1e-9 * v.plastic,   kSteel * 1e-6 * v.area, 1e-12 * v.weak,
          1e-12 * v.torsion, 1e-6 * v.weak_shear};
}

constexpr double kOfFlanges = 5.0 / 6;  // of a rectangle in shear

Section section_of(const RolledBeam& p) {
  const double web = p.h - 2 * p.tf, flange = (p.h - p.tf) / 2;
  const Fillet corner = fillet(p.r);
  const double arm = web / 2 - corner.from_side, aside = p.tw / 2 + corner.from_side;
  const double area = 2 * p.b * p.tf + web * p.tw + 4 * corner.area;
  const double second = 2 * (p.b * elementary::pow(p.tf, 3) / 12 + p.b * p.tf * flange * flange) +
                        p.tw * elementary::pow(web, 3) / 12 +
                        4 * (corner.second + corner.area * arm * arm);
  const double plastic = 2 * p.b * p.tf * flange + p.tw * web * web / 4 + 4 * corner.area * arm;
  const double weak = 2 * p.tf * elementary::pow(p.b, 3) / 12 +
                      web * elementary::pow(p.tw, 3) / 12 +
                      4 * (corner.second + corner.area * aside * aside);
  // flanges and web, and the contribution of their intersections (frames.md, 20.16)
  const double meet =
      (elementary::pow(p.r + p.tw / 2, 2) + elementary::pow(p.r + p.tf, 2) - p.r * p.r) /
      (2 * p.r + p.tf);
  const double torsion = 2.0 / 3 * (p.b - 0.63 * p.tf) * elementary::pow(p.tf, 3) +
                         web * elementary::pow(p.tw, 3) / 3 +
                         2 * p.tw / p.tf * (0.145 + 0.1 * p.r / p.tf) * elementary::pow(meet, 4);
  return in_metres({p.h, p.b, area, p.tw * (p.h - p.tf), second, plastic, weak, torsion,
                    kOfFlanges * 2 * p.b * p.tf});
}

Section section_of(const Channel& p) {
  return in_metres({p.h, p.b, 1e2 * p.area, p.tw * (p.h - p.tf), 1e4 * p.second, 1e3 * p.plastic,
                    1e4 * p.weak, 1e4 * p.torsion, kOfFlanges * 2 * p.b * p.tf});
}

// A square without its corners outside the outer circles, less the same for the hole.
Section section_of(const Tube& p) {
  struct Sums {
    double area, second, plastic;
  };
  const auto rounded = [](double b, double r) {
    const Fillet corner = fillet(r);
    const double arm = b / 2 - corner.from_side;
    return Sums{b * b - 4 * corner.area,
                elementary::pow(b, 4) / 12 - 4 * (corner.second + corner.area * arm * arm),
                b * b * b / 4 - 4 * corner.area * arm};
  };
  const Sums whole = rounded(p.b, 1.5 * p.t), hole = rounded(p.b - 2 * p.t, p.t);
  const double second = whole.second - hole.second, shear = 2 * p.t * (p.b - p.t);
  // EN 10210-2, annex B: along the middle line, whose corners have the radius 1.25 t
  const double radius = 1.25 * p.t, corners = 4 - std::numbers::pi, side = p.b - p.t;
  const double around = 4 * side - 2 * radius * corners;
  const double inside = side * side - radius * radius * corners;
  const double torsion = elementary::pow(p.t, 3) * around / 3 + 4 * inside * inside * p.t / around;
  return in_metres({p.b, p.b, whole.area - hole.area, shear, second, whole.plastic - hole.plastic,
                    second, torsion, shear});
}

// Capitals without spaces; "HE200B" becomes "HEB200".
std::string key_of(const std::string& name) {
  std::string key;
  for (const char c : name)
    if (!is_ascii_space(c)) key += ascii_capital(c);
  if (key.size() > 3 && key.starts_with("HE") && (key.back() == 'A' || key.back() == 'B'))
    key = "HE" + key.substr(key.size() - 1) + key.substr(2, key.size() - 3);
  return key;
}

// "HEB 600": ("HEB", 600); "SHS 100x5": ("SHS", 100).
std::pair<std::string, int> series_and_size(const std::string& name) {
  const std::string key = key_of(name);
  std::size_t at = 0;
  while (at < key.size() && !is_digit(key[at])) ++at;
  int size = 0;
  for (std::size_t i = at; i < key.size() && is_digit(key[i]) && size < 100000; ++i)
    size = 10 * size + (key[i] - '0');
  return {key.substr(0, at), size};
}

template <class Table>
std::optional<Section> found_in(const Table& table, const std::string& key) {
  for (const auto& profile : table)
    if (key_of(profile.name) == key) return section_of(profile);
  return std::nullopt;
}

}  // namespace

std::optional<Section> profile_named(const std::string& name) {
  const std::string key = key_of(name);
  if (const auto beam = found_in(kBeams, key)) return beam;
  if (const auto channel = found_in(kChannels, key)) return channel;
  return found_in(kTubes, key);
}

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  for (const RolledBeam& p : kBeams) names.emplace_back(p.name);
  for (const Channel& p : kChannels) names.emplace_back(p.name);
  for (const Tube& p : kTubes) names.emplace_back(p.name);
  return names;
}

std::string profile_advice(const std::string& name) {
  const std::vector<std::string> names = profile_names();
  const auto [series, size] = series_and_size(name);
  std::vector<std::string> alike;
  for (const std::string& other : names)
    if (series_and_size(other).first == series) alike.push_back(other);
  if (!alike.empty() &&
      (size < series_and_size(alike.front()).second || size > series_and_size(alike.back()).second))
    return "the table has " + alike.front() + " to " + alike.back() + ".";
  const std::string advice = name_advice(name, names);
  return advice.ends_with('?') ? advice : advice + " in the table.";
}

}  // namespace wythe::geometry
