// Arches, barrel vaults and domes from parameters: voussoirs between plane joints (docs/theory/builder.md).
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/elementary.h"
#include "core/limits.h"
#include "geometry/builder/builder.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

constexpr int kMostAlong = 10000;  // voussoirs, units or courses

// Part of a circle: intrados of radius `inner` about a point at `centre` above the springing, up to `reach` on both sides of the crown.
struct Ring {
  double inner = 0, outer = 0, centre = 0;  // [m]
  double reach = 0;                         // [rad]
};

Ring ring_of(double span, double rise, double depth) {
  const double half = span / 2;
  Ring ring;
  ring.inner = (half * half + rise * rise) / (2 * rise);
  ring.outer = ring.inner + depth;
  ring.centre = rise - ring.inner;
  ring.reach = elementary::atan2(half, -ring.centre);
  return ring;
}

std::string path_of(const char* table, int index, const char* key) {
  return table + ("." + std::to_string(index)) + "." + key;
}

bool check_number(const std::string& path, int value, int least, FaultList& faults) {
  if (value >= least && value <= kMostAlong) return true;
  add_fault(faults, path, std::to_string(value),
            fmt::format("must be from {} to {}", least, kMostAlong),
            fmt::format("write {} = {}", last_key(path), std::max(least, 16)));
  return false;
}

// Whether the bond is running rather than stack; adds a fault for other bonds.
bool is_running(const std::string& path, const std::string& bond, FaultList& faults) {
  if (bond.empty() || bond == "running") return true;
  if (bond != "stack")
    add_fault(faults, path, "\"" + bond + "\"", "must be running or stack",
              "write bond = \"running\": joints are broken from course to course");
  return false;
}

// Checks the keys that arch and dome share.
template <class Spec>
bool check_shell(const Site& site, const char* table, int index, const Spec& spec, double& rise,
                 FaultList& faults) {
  const auto path = [&](const char* key) { return path_of(table, index, key); };
  const std::size_t before = faults.all().size();
  const bool wide = is_positive({path("span"), spec.span, "m", "4 m"}, faults);
  (void)is_positive({path("depth"), spec.depth, "m", "0.3 m"}, faults);
  rise = std::isnan(spec.rise) ? spec.span / 2 : spec.rise;
  if (wide && is_positive({path("rise"), rise, "m", "2 m"}, faults) && rise > spec.span)
    add_fault(faults, path("rise"), metres(rise), "is more than the span",
              "write half the span, " + metres(spec.span / 2) + ", or less");
  site.check_material(path("material"), spec.material, faults);
  return faults.all().size() == before;
}

// Converts the model's axes to places in plan and height.
struct Springing {
  PlanAxes axes;
  Vec2 plan;
  double height;
  template <class Spec>
  Springing(const PlanAxes& given, const Spec& spec)
      : axes(given),
        plan{spec.x, given.z_up ? spec.y : spec.z},
        height(given.z_up ? spec.z : spec.y) {}
  [[nodiscard]] Vec3 place(Vec2 p, double up) const { return axes.place(plan + p, height + up); }
};

template <class Spec>
BuiltBody voussoir_of(const Spec& spec, const std::string& id, int course, bool fixed) {
  BuiltBody built;
  built.body.id = spec.name + "." + id;
  if (!spec.material.empty()) built.body.material = spec.material;
  built.body.fixed = fixed;
  built.wall = spec.name;
  built.course = course;
  return built;
}

// --- arch -------------------------------------------------------------------------------------------

class ArchBuilder {
 public:
  ArchBuilder(const StandingArchSpec& spec, double rise, const PlanAxes& axes)
      : spec_(spec), site_(axes, spec), ring_(ring_of(spec.span, rise, spec.depth)) {
    const double turn = axes.z_up ? spec.turn : -spec.turn;
    along_ = {elementary::cos(turn), elementary::sin(turn)};
    if (spec.turn == 0) along_ = {1, 0};
    across_ = {-along_.y, along_.x};
  }

  std::vector<BuiltBody> build(bool running) {
    const double w = spec_.width;
    for (int k = 0; k < spec_.voussoirs; ++k) {
      std::vector<double> cuts{0};
      const bool shifted = running && k % 2 == 1 && spec_.units > 1;
      for (int u = 0; u < spec_.units; ++u)
        cuts.push_back(shifted ? (u + 0.5) * w / spec_.units : (u + 1) * w / spec_.units);
      if (shifted) cuts.push_back(w);
      for (std::size_t u = 0; u + 1 < cuts.size(); ++u)
        add(fmt::format("c{:02}u{:02}", k, u), k, cuts[u] - w / 2, cuts[u + 1] - w / 2, false);
    }
    if (spec_.springers) {
      add("left", -1, -w / 2, w / 2, true);
      add("right", spec_.voussoirs, -w / 2, w / 2, true);
    }
    return std::move(bodies_);
  }

 private:
  // Ray k from the left springing. The right half mirrors the left one to the bit.
  [[nodiscard]] Vec2 ray(int k) const {
    const int n = spec_.voussoirs;
    if (2 * k == n) return {0, 1};
    if (k == 0 || k == n) {
      const double side = k == 0 ? -1 : 1;
      return {side * spec_.span / 2 / ring_.inner, -ring_.centre / ring_.inner};
    }
    const double angle = ring_.reach * (1 - 2.0 * std::min(k, n - k) / n);
    return {(2 * k < n ? -1 : 1) * elementary::sin(angle), elementary::cos(angle)};
  }

  void add(const std::string& id, int k, double w0, double w1, bool fixed) {
    std::vector<Vec3> back, front;
    for (const auto& [ray_number, radius] : {std::pair(k, ring_.inner),
                                             {k + 1, ring_.inner},
                                             {k + 1, ring_.outer},
                                             {k, ring_.outer}}) {
      const Vec2 r = ray(ray_number);
      const double s = radius * r.x, up = ring_.centre + radius * r.y;
      for (const auto& [list, w] : {std::pair(&back, w0), {&front, w1}})
        list->push_back(
            site_.place({s * along_.x + w * across_.x, s * along_.y + w * across_.y}, up));
    }
    BuiltBody body = voussoir_of(spec_, id, k, fixed);
    body.body.part = {solid_between(back, front)};
    bodies_.push_back(std::move(body));
  }

  const StandingArchSpec& spec_;
  Springing site_;
  Ring ring_;
  Vec2 along_, across_;
  std::vector<BuiltBody> bodies_;
};

// --- dome -------------------------------------------------------------------------------------------

// Beds lie on cones about the dome's centre, replaced by plane triangles: the four corners of a bed lie on two
// rays, hence in one plane. A unit is two such wedges, so that units of broken courses share planes above and below.
class DomeBuilder {
 public:
  DomeBuilder(const DomeSpec& spec, double rise, const PlanAxes& axes)
      : spec_(spec), site_(axes, spec), ring_(ring_of(spec.span, rise, spec.depth)) {
    eye_ = spec.oculus > 0 ? elementary::asin(spec.oculus / 2 / ring_.inner) : 0;
    // without an oculus the keystone covers half a course on each side of the crown
    step_ =
        spec.oculus > 0 ? (ring_.reach - eye_) / spec.courses : ring_.reach / (spec.courses + 0.5);
    if (spec.oculus <= 0) eye_ = step_ / 2;
  }

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] double step() const { return step_; }

  std::vector<BuiltBody> build(bool running) {
    for (int c = 0; c < spec_.courses; ++c)
      for (int u = 0; u < spec_.units; ++u)
        add_unit(fmt::format("c{:02}u{:02}", c, u), c, 2 * u + (running ? c % 2 : 0), false);
    if (spec_.oculus <= 0) add_keystone();
    for (int u = 0; u < spec_.units && spec_.springers; ++u)
      add_unit(fmt::format("ground{:02}", u), -1, 2 * u + (running ? 1 : 0), true);
    return std::move(bodies_);
  }

 private:
  // Corner at bed b (0 is the springing) and half meridian k on the sphere of radius r [m].
  [[nodiscard]] Vec3 corner(int b, int k, double r) const {
    const int n = 2 * spec_.units;
    const double down = b == spec_.courses ? eye_ : ring_.reach - b * step_;
    const double turn = 2 * M_PI * (k % n) / n;
    double out = r * elementary::sin(down), up = r * elementary::cos(down);
    if (b == 0) out = r * (spec_.span / 2 / ring_.inner), up = -r * (ring_.centre / ring_.inner);
    return site_.place({out * elementary::cos(turn), out * elementary::sin(turn)},
                       ring_.centre + up);
  }

  void add_unit(const std::string& id, int course, int k, bool fixed) {
    BuiltBody body = voussoir_of(spec_, id, course, fixed);
    for (const int h : {k, k + 1}) {
      std::vector<Vec3> inside, outside;
      for (const auto& [bed, meridian] :
           {std::pair(course, h), {course, h + 1}, {course + 1, h + 1}, {course + 1, h}}) {
        inside.push_back(corner(bed, meridian, ring_.inner));
        outside.push_back(corner(bed, meridian, ring_.outer));
      }
      body.body.part.push_back(solid_between(inside, outside));
    }
    bodies_.push_back(std::move(body));
  }

  void add_keystone() {
    BuiltBody body = voussoir_of(spec_, "key", spec_.courses, false);
    std::vector<Vec3> inside, outside;
    for (int k = 0; k < 2 * spec_.units; ++k) {
      inside.push_back(corner(spec_.courses, k, ring_.inner));
      outside.push_back(corner(spec_.courses, k, ring_.outer));
    }
    body.body.part = {solid_between(inside, outside)};
    bodies_.push_back(std::move(body));
  }

  const DomeSpec& spec_;
  Springing site_;
  Ring ring_;
  double eye_ = 0, step_ = 0;  // [rad]
  std::vector<BuiltBody> bodies_;
};

bool check_built(const std::string& path, double count, FaultList& faults) {
  if (count <= static_cast<double>(kMostBuilt)) return true;
  add_fault(faults, path, fmt::format("{:.3g} blocks", count),
            fmt::format("are more than {} blocks, the most that are built", kMostBuilt),
            "write fewer");
  return false;
}

}  // namespace

std::vector<BuiltBody> build_arch(const Site& site, int index, FaultList& faults) {
  const StandingArchSpec& spec = site.spec.arch[index];
  const auto path = [&](const char* key) { return path_of("arch", index, key); };
  double rise = 0;
  bool good = check_shell(site, "arch", index, spec, rise, faults);
  good &= is_positive({path("width"), spec.width, "m", "1 m"}, faults);
  good &= check_number(path("voussoirs"), spec.voussoirs, 3, faults);
  good &= check_number(path("units"), spec.units, 1, faults);
  const std::size_t before = faults.all().size();
  const bool running = is_running(path("bond"), spec.bond, faults);
  good &= faults.all().size() == before;
  if (!good || !check_built(path("units"), 1.0 * spec.units * spec.voussoirs, faults)) return {};
  return ArchBuilder(spec, rise, {site.z_up()}).build(running);
}

std::vector<BuiltBody> build_dome(const Site& site, int index, FaultList& faults) {
  const DomeSpec& spec = site.spec.dome[index];
  const auto path = [&](const char* key) { return path_of("dome", index, key); };
  double rise = 0;
  bool good = check_shell(site, "dome", index, spec, rise, faults);
  good &= check_number(path("courses"), spec.courses, 2, faults);
  good &= check_number(path("units"), spec.units, 4, faults);
  const std::size_t before = faults.all().size();
  const bool running = is_running(path("bond"), spec.bond, faults);
  if (spec.oculus < 0 || (good && spec.oculus > 0 && !(spec.oculus < spec.span)))
    add_fault(faults, path("oculus"), metres(spec.oculus),
              "must be less than the span, and not negative",
              "leave it out for a keystone, or write e.g. oculus = \"0.6 m\"");
  good &= faults.all().size() == before;
  if (!good || !check_built(path("units"), 1.0 * spec.units * spec.courses, faults)) return {};
  DomeBuilder dome(spec, rise, {site.z_up()});
  if (spec.springers && dome.ring().reach + dome.step() > M_PI)
    add_fault(faults, path("courses"), std::to_string(spec.courses),
              "leave no room for springers below the springing", "write more courses");
  return dome.build(running);
}

}  // namespace wythe::geometry
