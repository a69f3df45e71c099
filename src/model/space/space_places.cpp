// Finds bodies by a stated place: an id or its beginning, a box around centroids, or a point; a role restricts each of them.
// Numbers of a place are in the axes of the blocks file; in_wall() rotates them where z points up there. A coordinate
// that a point omits is that of each body's own centroid.
#include "model/space/space_places.h"

#include "model/space/space_roles.h"

#include <algorithm>
#include <cmath>

namespace wythe {
namespace {

using geometry::Facet;
using geometry::SpaceAssembly;

// Distance of a point outside a convex part; negative inside.
double outside(const Polyhedron& part, Vec3 p) {
  double most = -1e300;
  for (const auto& corners : part.face) {
    const Facet facet = geometry::facet_of(part, corners);
    most = std::fmax(most, dot(p - facet.centre, facet.normal));
  }
  return most;
}

double outside(const BodySpec& body, Vec3 p) {
  double least = 1e300;
  for (const Polyhedron& part : body.part) least = std::fmin(least, outside(part, p));
  return least;
}

// The part of a ray that lies on the inner side of planes.
class RayInside {
 public:
  RayInside(Vec3 from, Vec3 direction) : from_(from), direction_(direction) {}
  void cut(Vec3 normal, double outside) {
    constexpr double kLevel = 1e-9;  // [m]
    const double speed = dot(normal, direction_);
    if (std::fabs(speed) < kLevel)
      leave_ = outside > -kLevel ? enter_ : leave_;
    else if (speed > 0)
      leave_ = std::fmin(leave_, -outside / speed);
    else
      enter_ = std::fmax(enter_, -outside / speed);
  }
  [[nodiscard]] bool is_long() const { return leave_ > enter_ + 1e-6; }  // [m]
  [[nodiscard]] bool meets(const geometry::Box3& box) {
    for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      cut(n, dot(n, from_ - box.high));
      cut(-1.0 * n, dot(n, box.low - from_));
    }
    return is_long();
  }
  [[nodiscard]] bool meets(const Polyhedron& part) {
    for (const auto& corners : part.face) {
      const Facet facet = geometry::facet_of(part, corners);
      cut(facet.normal, dot(from_ - facet.centre, facet.normal));
    }
    return is_long();
  }

 private:
  Vec3 from_, direction_;
  double enter_ = 0, leave_ = 1e300;
};

bool is_named(const BodySpec& body, const std::string& pattern) {
  if (pattern.ends_with("*")) return body.id.starts_with(pattern.substr(0, pattern.size() - 1));
  return body.id == pattern;
}

bool has_role(const BodySpec& body, const std::string& role) {
  return role.empty() || (!body.fixed && role == word_of(kBlockRoleWords, role_of(body)));
}

}  // namespace

SpacePlaces::SpacePlaces(const ModelSpec& spec, const SpaceAssembly& assembly)
    : spec_(spec), assembly_(assembly) {
  for (const BodySpec& body : assembly.body) box_.push_back(geometry::box_of(body));
}

Vec3 SpacePlaces::in_wall(Vec3 v) const { return z_up() ? Vec3{v.x, v.z, -v.y} : v; }
Vec3 SpacePlaces::in_file(Vec3 v) const { return z_up() ? Vec3{v.x, -v.z, v.y} : v; }

std::vector<std::size_t> SpacePlaces::find(const PlaceSpec& place) const {
  const bool is_box =
      std::isfinite(place.width) || std::isfinite(place.height) || std::isfinite(place.depth);
  const bool is_point =
      !is_box && (std::isfinite(place.x) || std::isfinite(place.y) || std::isfinite(place.z));
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < assembly_.body.size(); ++k) {
    const Vec3 c = in_file(assembly_.moments[k].centroid);
    const auto within = [](double x, double from, double width) {
      return !std::isfinite(from) || (x >= from && (!std::isfinite(width) || x <= from + width));
    };
    const bool matches = !place.block.empty() ? is_named(assembly_.body[k], place.block)
                         : is_box             ? within(c.x, place.x, place.width) &&
                                        within(c.y, place.y, place.height) &&
                                        within(c.z, place.z, place.depth)
                         : is_point ? holds_point(k, place)
                                    : true;
    if (matches && has_role(assembly_.body[k], place.role)) found.push_back(k);
  }
  return found;
}

bool SpacePlaces::holds_point(std::size_t k, const PlaceSpec& place) const {
  const Vec3 c = in_file(assembly_.moments[k].centroid);
  const Vec3 p =
      in_wall({std::isfinite(place.x) ? place.x : c.x, std::isfinite(place.y) ? place.y : c.y,
               std::isfinite(place.z) ? place.z : c.z});
  return outside(assembly_.body[k], p) <= 1e-6 * box_[k].longest();
}

std::optional<Vec3> SpacePlaces::point_of(const PlaceSpec& place) const {
  if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z))
    return std::nullopt;
  return in_wall({place.x, place.y, place.z});
}

bool SpacePlaces::is_covered(Vec3 point, Vec3 direction, const std::vector<bool>& counts) const {
  for (std::size_t k = 0; k < box_.size(); ++k) {
    if (!counts[k] || !RayInside(point, direction).meets(box_[k])) continue;
    const std::vector<Polyhedron>& parts = assembly_.body[k].part;
    if (std::any_of(parts.begin(), parts.end(), [&](const Polyhedron& part) {
          return RayInside(point, direction).meets(part);
        }))
      return true;
  }
  return false;
}

std::optional<std::size_t> SpacePlaces::body_at(Vec3 p, bool fixed) const {
  constexpr double kReach = 0.01, kSame = 1e-9;  // [m]
  std::optional<std::size_t> best;
  double least = kReach, nearest = 1e300;
  for (std::size_t k = 0; k < box_.size(); ++k) {
    if (assembly_.body[k].fixed != fixed) continue;
    const geometry::Box3 at{p, p};
    if (!geometry::near(box_[k], at, 2 * kReach)) continue;
    const double away = std::fmax(0, outside(assembly_.body[k], p));
    const double middle = length(assembly_.moments[k].centroid - p);
    if (away < least - kSame || (away <= least + kSame && middle < nearest - kSame)) {
      least = std::fmin(least, away);
      nearest = middle;
      best = k;
    }
  }
  return best;
}

}  // namespace wythe
