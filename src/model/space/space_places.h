// Places of a model file in space -> bodies of the assembly, points on them, lines over them.
//
// Called by space_stages.cpp (loads and pushes), space_loads.cpp (points and lines) and links.cpp.
// Places and directions of a model file are in the axes of its blocks file, where z may point up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/bodies/joint_faces.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

inline constexpr double kFacing = 0.5;  // least cosine of a face's normal to the direction it faces

class SpacePlaces {
 public:
  SpacePlaces(const ModelSpec& spec, const geometry::SpaceAssembly& assembly);

  [[nodiscard]] bool z_up() const { return spec_.wall.up == "z"; }
  [[nodiscard]] Vec3 in_wall(Vec3 in_file) const;
  [[nodiscard]] Vec3 in_file(Vec3 in_wall) const;
  [[nodiscard]] const geometry::Box3& box(std::size_t body) const { return box_[body]; }

  // Bodies at a place, supports included; all bodies where the place states nothing. A role restricts it to free ones.
  [[nodiscard]] std::vector<std::size_t> find(const PlaceSpec& place) const;
  // The stated point in the axes of the wall; none where a coordinate is missing.
  [[nodiscard]] std::optional<Vec3> point_of(const PlaceSpec& place) const;
  // Whether a ray from a point meets any body of those that `counts` names.
  [[nodiscard]] bool is_covered(Vec3 point, Vec3 direction, const std::vector<bool>& counts) const;
  // The fixed (or free) body that contains the point or lies within 10 mm of it: the nearest one, then the one
  // with the nearest centroid; none farther away.
  [[nodiscard]] std::optional<std::size_t> body_at(Vec3 point, bool fixed) const;

 private:
  [[nodiscard]] bool holds_point(std::size_t body, const PlaceSpec& place) const;

  const ModelSpec& spec_;
  const geometry::SpaceAssembly& assembly_;
  std::vector<geometry::Box3> box_;
};

// The parts of a line that lie on bodies, each part on one face.
struct LinePiece {
  std::size_t body;
  double from, to;  // along the line [m]
  double share;     // 1, or the body's part where the line runs on a common edge
};
// Parts of the line on faces of free bodies directed against `load`, in order. A part without a body below is
// a fault at `path`, and nothing is returned.
[[nodiscard]] std::vector<LinePiece> pieces_under(const geometry::SpaceAssembly& assembly,
                                                  Vec3 from, Vec3 to, Vec3 load,
                                                  const std::string& path, FaultList& faults);

// Force or line load of a load stage; empty, with a fault, where it has no place.
[[nodiscard]] std::vector<PointLoad> stated_loads(const LoadStage& stage, const SpacePlaces& places,
                                                  const geometry::SpaceAssembly& assembly,
                                                  const std::vector<BlockId>& id,
                                                  const std::string& path, FaultList& faults);
// Loads of floors on blocks, for the stage that applies them; also adds their inertia to the blocks.
[[nodiscard]] std::vector<PointLoad> compile_space_floors(const ModelSpec& spec,
                                                          const geometry::SpaceAssembly& assembly,
                                                          const std::vector<BlockId>& id,
                                                          Model& model, FaultList& faults);

}  // namespace wythe
