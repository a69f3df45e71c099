// Two blocks overlap where they share more than a film as thick as the contact tolerance. Identical blocks are reported
// together as duplicates. A block is supported by a chain of faces and frame sections down to the ground. Faces of
// masonry that a stage cuts out do not count, since they carry nothing in the end.
#include "geometry/wall/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "geometry/polygon.h"
#include "geometry/text.h"
#include "geometry/wall/joints.h"

namespace wythe::geometry {
namespace {

constexpr double kThinnest = 0.1;         // share of a half unit, of a course
constexpr std::size_t kMostPairs = 1000;  // for each block: only coincident blocks reach it
constexpr std::size_t kOverlapsTold = 20;
constexpr std::size_t kNamed = 5;  // most blocks named in one message

double longer_side(const Rect& box) { return std::max(box.x1 - box.x0, box.y1 - box.y0); }

// Pairs of identical blocks, "a12 and a31".
using Twins = std::vector<std::string>;

// Adds a fault if two blocks overlap, or adds them to `twins` if they are identical. True if they overlap.
bool refuse_overlap(const Block& a, const Block& b, double tolerance, Twins& twins,
                    FaultList& faults) {
  const Rect box_a = bounds(a.outline), box_b = bounds(b.outline);
  if (!overlaps(box_a, box_b, tolerance)) return false;
  const double area = overlap_area(a.outline, b.outline);
  // a film as thick as the contact tolerance along a whole side is contact, not overlap
  if (area <= tolerance * std::min(longer_side(box_a), longer_side(box_b))) return false;
  constexpr double kSame = 1e-3;  // of the area
  const double larger =
      std::max(overlap_area(a.outline, a.outline), overlap_area(b.outline, b.outline));
  if (area > (1 - kSame) * larger) {
    twins.push_back(a.id + " and " + b.id);
    return false;
  }
  add_fault(faults, "wall.blocks." + b.id, "",
            fmt::format("blocks \"{}\" and \"{}\" overlap by {:.6g} m^2", a.id, b.id, area),
            "move their corners apart");
  return true;
}

// Groups of connected blocks as a forest, one root a group; index n stands for the ground.
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[root(i)] = root(j); }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<std::string> unsupported_blocks(const Assembly& assembly) {
  const std::size_t n = assembly.blocks.size();
  const auto index = [n](int i) { return i == kGround ? n : static_cast<std::size_t>(i); };
  Groups groups(n + 1);
  const auto goes = [&](int i) { return i != kGround && assembly.blocks[i].cut_from >= 0; };
  for (const Face& face : assembly.faces)  // masonry that a stage cuts out carries nothing
    if (!goes(face.a) && !goes(face.b)) groups.join(index(face.a), index(face.b));
  for (const PlacedFrame& frame : assembly.frames) {
    std::vector<std::size_t> block(frame.segments.size(), n);
    for (std::size_t i = 0; i < n; ++i)
      if (assembly.blocks[i].frame == frame.index) block[assembly.blocks[i].segment] = i;
    const auto side = [&](int segment) { return segment == kGround ? n : block[segment]; };
    for (const FrameJoint& joint : frame.joints) groups.join(side(joint.a), side(joint.b));
  }
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < n; ++i) {
    const bool hangs = groups.root(i) != groups.root(n);
    if (hangs && assembly.blocks[i].role != Role::kSupport && !goes(static_cast<int>(i)))
      ids.push_back(assembly.blocks[i].id);
  }
  return ids;
}

std::string listed(const std::vector<std::string>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, ids.size()); ++i) {
    text += (i > 0 ? ", " : "") + ids[i];
  }
  if (ids.size() > kNamed) text += " and " + std::to_string(ids.size() - kNamed) + " more";
  return text;
}

}  // namespace

void check_overlaps(const std::vector<Block>& blocks, FaultList& faults) {
  const double tolerance = contact_tolerance(blocks);
  const std::size_t most = kMostPairs * blocks.size();
  const auto pairs = near_pairs(blocks, 0, most);
  std::size_t refused = 0;
  Twins twins;
  for (const auto& [i, j] : pairs) {
    const Block& a = blocks[i];
    const Block& b = blocks[j];
    refused += refuse_overlap(a, b, tolerance, twins, faults);
    if (twins.size() > blocks.size()) break;  // blocks listed more than twice: too many pairs
    if (refused < kOverlapsTold) continue;
    add_fault(faults, "wall.blocks", std::to_string(blocks.size()) + " blocks",
              "only the first " + std::to_string(kOverlapsTold) + " overlaps are told",
              "mend these and check the file again");
    return;
  }
  if (!twins.empty())
    add_fault(faults, "wall.blocks", listed(twins),
              twins.size() == 1 ? "are one block, given twice"
              : twins.size() > blocks.size()
                  ? "more than " + std::to_string(blocks.size()) +
                        " pairs are one block each, given several times"
                  : std::to_string(twins.size()) + " pairs are one block each, given twice",
              "leave one of each out");
  if (!pairs.empty() && pairs.size() >= most)
    add_fault(faults, "wall.blocks", std::to_string(blocks.size()) + " blocks",
              "more than " + std::to_string(kMostPairs) +
                  " blocks lie within the bounds of another, on average",
              "list every block once, and long ones in pieces");
}

void check_slivers(const std::vector<Block>& blocks, const std::vector<Storey>& storeys,
                   FaultList& faults) {
  for (const Block& block : blocks) {
    if (block.role != Role::kMasonry) continue;
    const Rect box = bounds(block.outline);
    const Lattice& lattice = storeys[std::max(0, block.storey)].lattice;
    const double width = box.x1 - box.x0, height = box.y1 - box.y0;
    if (width >= kThinnest * lattice.columns.step && height >= kThinnest * lattice.courses.step) {
      continue;
    }
    add_fault(faults, "wall.opening", millimetres(width) + " x " + millimetres(height),
              "the openings leave a strip of masonry too thin to lay at " + metres(box.x0) + ", " +
                  metres(box.y0),
              "move or join the openings so that a tenth of a unit or more is left");
  }
}

void check_support(const Assembly& assembly, FaultList& faults) {
  const std::vector<std::string> ids = unsupported_blocks(assembly);
  if (ids.empty()) return;
  add_fault(faults, "wall", std::to_string(ids.size()) + " blocks",
            "no support: blocks " + listed(ids) + " are not connected to the ground",
            "close the gap below them, or leave them out");
}

}  // namespace wythe::geometry
