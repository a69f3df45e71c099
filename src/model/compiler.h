// Compiles walls that mostly have one shape, e.g. the samples of a study: their assembly is built once.
//
//   ModelSpec ──build_assembly──► Assembly ──────────────────► Model
//                                    │    + materials, densities, loads, stages, settings
//               kept where the shape_key is the same
#pragma once

#include "geometry/assembly.h"
#include "geometry/bodies/joint_faces.h"
#include "wythe/parts/model.h"

namespace wythe {

class Compiler {
 public:
  // Builds the assembly of `spec`; throws InputError as compile() does.
  explicit Compiler(const ModelSpec& spec);
  // The same bits or the same faults as compile(spec), also for a spec of another shape. Can be
  // called from several threads.
  [[nodiscard]] Model compile(const ModelSpec& spec) const;

 private:
  std::uint64_t shape_;
  geometry::Assembly assembly_;
  geometry::SpaceAssembly in_space_;  // of a wall in space
};

}  // namespace wythe
