// Compiles walls that mostly share one shape, such as samples of a study; it builds their assembly once.
//
//   ModelSpec ──build_assembly──► Assembly ──────────────────► Model
//                                    │    + materials, densities, loads, stages, settings
//               kept while the shape_key is the same
#pragma once

#include "geometry/assembly.h"
#include "geometry/bodies/joint_faces.h"
#include "wythe/parts/model.h"

namespace wythe {

class Compiler {
 public:
  // Builds the assembly of `spec`; throws InputError as compile() does.
  explicit Compiler(const ModelSpec& spec);
  // Gives the same bits or faults as compile(spec), also for a spec of another shape. May be
  // called from several threads.
  [[nodiscard]] Model compile(const ModelSpec& spec) const;

 private:
  std::uint64_t shape_;
  geometry::Assembly assembly_;
  geometry::SpaceAssembly in_space_;  // for walls in space
};

}  // namespace wythe
