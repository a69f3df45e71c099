// Mortar of layers -> faces beside those of the masonry that it covers, with their own laws, and its mass
// (docs/theory/layers.md, "The mortar").
//
//     | unit a | unit b |
//     +========+========+     the joint between a and b, as thick as the wall: its own law
//     :::::::::::::::::::     the mortar over it, `sides` times as thick as one coat: a second joint at the same place
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "geometry/polygon.h"
#include "model/parts.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Face;
using geometry::FaceKind;
using geometry::Rect;
using geometry::Role;

constexpr double kShortest = 1e-3;           // length of a covered face [m]
constexpr double kShearPerYoungs = 1 / 2.4;  // with Poisson's ratio 0.2

// The rectangle of a layer, by default the whole masonry.
Rect box_of(const ModelSpec& spec, const LayerSpec& layer, const Assembly& assembly) {
  Rect all{1e300, 1e300, -1e300, -1e300};
  for (const geometry::Block& block : assembly.blocks)
    if (holds_layers(spec, block)) all = geometry::join(all, geometry::bounds(block.outline));
  const double x = std::isnan(layer.x) ? all.x0 : layer.x;
  const double y = std::isnan(layer.y) ? all.y0 : layer.y;
  return {x, y, std::isnan(layer.width) ? all.x1 : x + layer.width,
          std::isnan(layer.height) ? all.y1 : y + layer.height};
}

// The part of a face inside a rectangle; shorter than kShortest where the face lies outside or on its border.
Face clipped(Face face, const Rect& box) {
  double from = 0, to = 1;
  const Vec2 d{face.p1.x - face.p0.x, face.p1.y - face.p0.y};
  const auto clip = [&](double start, double along, double low, double high) {
    if (std::fabs(along) < kShortest) {
      if (start < low + kShortest || start > high - kShortest) to = from;
      return;
    }
    const double a = (low - start) / along, b = (high - start) / along;
    from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
  };
  clip(face.p0.x, d.x, box.x0, box.x1);
  clip(face.p0.y, d.y, box.y0, box.y1);
  const Vec2 start = face.p0;
  to = std::max(from, to);
  face.p0 = {start.x + from * d.x, start.y + from * d.y};
  face.p1 = {start.x + to * d.x, start.y + to * d.y};
  return face;
}

class CoatBuilder {
 public:
  CoatBuilder(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map, Model& model,
              FaultList& faults)
      : spec_(spec), assembly_(assembly), map_(map), model_(model), faults_(faults) {}

  std::vector<Coat> all() {
    for (std::size_t k = 0; k < spec_.layer.size(); ++k) {
      path_ = fmt::format("layer.{}.mortar", k);
      if (is_given(spec_.layer[k].mortar)) add(spec_.layer[k], k);
    }
    return std::move(coats_);
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  bool is_given(const LayerMortarSpec& mortar) {
    const bool any = mortar.thickness > 0 || mortar.youngs_modulus > 0 || !mortar.joint.empty();
    if (!any) return false;
    const std::size_t before = faults_.all().size();
    if (!(mortar.thickness > 0))
      fault("thickness", "", "is missing", "write thickness = \"30 mm\", of one face");
    if (!(mortar.youngs_modulus > 0))
      fault("youngs_modulus", "", "is missing", "write youngs_modulus = \"12 GPa\"");
    if (!spec_.material.contains(mortar.joint))
      fault("joint", "\"" + mortar.joint + "\"", "is no [material.*] of this model",
            "write joint = \"plaster\", and its strengths and energies under [material.plaster]");
    return faults_.all().size() == before;
  }

  void add(const LayerSpec& layer, std::size_t number) {
    const Rect box = box_of(spec_, layer, assembly_);
    const std::size_t first = coats_.size();
    for (const Face& face : assembly_.faces) {
      if (face.a == geometry::kGround || face.kind == FaceKind::kLintelChain) continue;
      const auto a = static_cast<std::size_t>(face.a), b = static_cast<std::size_t>(face.b);
      if (map_[a] < 0 || map_[b] < 0 || !holds_layers(spec_, assembly_.blocks[a]) ||
          !holds_layers(spec_, assembly_.blocks[b]))
        continue;
      Face own = clipped(face, box);
      const double length = elementary::hypot(own.p1.x - own.p0.x, own.p1.y - own.p0.y);
      if (length < kShortest) continue;
      own.kind = FaceKind::kCoat;
      coats_.push_back(
          {own, layer.sides * layer.mortar.thickness, law(layer, own, length), layer.mortar.joint});
    }
    add_mass(layer, box);
    if (coats_.size() == first) {
      const bool has_fibres = layer.fibres.horizontal > 0 || layer.fibres.vertical > 0;
      if (has_fibres) return;  // layers.cpp refuses such a layer
      faults_.add({"", fmt::format("layer.{}", number), layer.name,
                   "crosses no joint of the masonry, so it can hold nothing together",
                   "make it larger", 0});
      return;
    }
    // The softest joint has the most elastic energy at its strength, so it asks for the most fracture energy.
    const auto softest = std::min_element(coats_.begin() + static_cast<std::ptrdiff_t>(first),
                                          coats_.end(), [](const Coat& a, const Coat& b) {
                                            return a.law.normal_stiffness < b.law.normal_stiffness;
                                          });
    for (const MaterialFault& f : check_joint_material(softest->law))
      faults_.add({"", fmt::format("material.{}.{}", layer.mortar.joint, f.key), f.value, f.problem,
                   f.cure, 0});
    model_.anatomy.notes.push_back(
        {"layer.mortar",
         {{"layer", layer.name.empty() ? fmt::format("{}", number + 1) : layer.name},
          {"joints", coats_.size() - first},
          {"thickness_mm", 1e3 * layer.sides * layer.mortar.thickness}}});
  }

  // The stiffness of the mortar over the length of both units is put into the joint: E / distance of their centroids (22.8).
  [[nodiscard]] JointMaterial law(const LayerSpec& layer, const Face& face, double length) const {
    const std::size_t i = map_[face.a];
    const std::size_t j = map_[face.b];
    const double nx = -(face.p1.y - face.p0.y) / length, ny = (face.p1.x - face.p0.x) / length;
    const double apart = std::fabs(nx * (model_.centroid_x[j] - model_.centroid_x[i]) +
                                   ny * (model_.centroid_y[j] - model_.centroid_y[i]));
    JointMaterial law = spec_.material.at(layer.mortar.joint);
    law.normal_stiffness = layer.mortar.youngs_modulus / apart;
    law.shear_stiffness = kShearPerYoungs * law.normal_stiffness;
    return law;
  }

  void add_mass(const LayerSpec& layer, const Rect& box) {
    const double per_area = layer.sides * layer.mortar.thickness * layer.mortar.density;
    if (!(per_area > 0)) return;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] < 0 || !holds_layers(spec_, assembly_.blocks[b])) continue;
      const std::size_t i = map_[b];
      const double more =
          per_area * geometry::overlap_area(assembly_.blocks[b].outline, geometry::outline_of(box));
      if (!(more > 0)) continue;
      if (model_.mass[i] > 0) model_.inertia[i] *= 1 + more / model_.mass[i];
      model_.mass[i] += more;
      model_.gravity_mass[i] += more;
    }
  }

  const ModelSpec& spec_;
  const Assembly& assembly_;
  const BlockMap& map_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
  std::vector<Coat> coats_;
};

}  // namespace

bool holds_layers(const ModelSpec& spec, const geometry::Block& block) {
  if (block.role == Role::kMasonry) return true;
  const bool put_in_later = block.opening >= 0 && !spec.wall.opening[block.opening].cut.empty();
  return geometry::is_chain(block) && !put_in_later;
}

std::vector<Coat> compile_coats(const ModelSpec& spec, const Assembly& assembly,
                                const BlockMap& map, Model& model, FaultList& faults) {
  return CoatBuilder(spec, assembly, map, model, faults).all();
}

}  // namespace wythe
