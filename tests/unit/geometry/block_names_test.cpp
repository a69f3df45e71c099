// Names of materials in blocks files: a misspelt one is refused. It would silently leave a joint
// its common law, or a block the unit's density. In space: tests/cli/building_in_space_test.py.
#include <gtest/gtest.h>

#include "geometry/assembly.h"

namespace wythe::geometry::block_names_test {
namespace {

BlockSpec square(const std::string& id, double y, const std::string& material) {
  BlockSpec block;
  block.id = id;
  block.polygon = {{0, y}, {1, y}, {1, y + 1}, {0, y + 1}};
  block.material = material;
  return block;
}

// The cure at `path`; "" where nothing is refused there.
std::string cure(const ModelSpec& spec, const std::string& path) {
  FaultList faults;
  (void)build_assembly(spec, faults);
  for (const Fault& fault : faults.all())
    if (fault.path == path) return fault.cure;
  return "";
}

TEST(BlockNames, one_that_nearly_is_another_is_refused) {
  ModelSpec spec;
  spec.wall.blocks = "blocks.json";
  spec.wall.thickness = 1;
  spec.wall.unit.density = 2000;
  spec.block = {square("a", 0, "masonry"), square("b", 1, "stone")};
  spec.contact = {{{"stone", "masonry"}, "lime"}};
  for (const char* name : {"joint", "lime"}) spec.material[name] = {};
  EXPECT_EQ(cure(spec, "contact.0.between"), "");
  spec.contact[0].between[1] = "masonrry";
  EXPECT_EQ(cure(spec, "contact.0.between"), "did you mean masonry?");
  spec.contact[0].between[1] = "masonry";
  spec.block[0].material = "stoen";
  EXPECT_EQ(cure(spec, "wall.blocks.a.material"), "did you mean stone?");
  spec.contact[0].between[1] = "ground";
  spec.block[0].material = "slate";  // a name of its own
  EXPECT_EQ(cure(spec, "wall.blocks.a.material"), "");
}

// The second of two rules was passed over in silence.
TEST(BlockNames, a_pair_of_materials_has_one_rule) {
  ModelSpec spec;
  spec.wall.blocks = "blocks.json";
  spec.wall.thickness = 1;
  spec.wall.unit.density = 2000;
  spec.block = {square("a", 0, "masonry"), square("b", 1, "stone")};
  for (const char* name : {"joint", "lime", "clay"}) spec.material[name] = {};
  spec.contact = {{{"stone", "masonry"}, "lime"}, {{"stone", "ground"}, "clay"}};
  EXPECT_EQ(cure(spec, "contact.1.between"), "");
  spec.contact.push_back({{"masonry", "stone"}, "clay"});
  EXPECT_EQ(cure(spec, "contact.2.between"), "keep one rule for each pair of materials");
}

// --- one shape, described in several ways ------------------------------------------------------------------

// A block on another, the upper one with this outline.
Assembly two_blocks(const std::vector<std::array<double, 2>>& upper) {
  ModelSpec spec;
  spec.wall.blocks = "blocks.json";
  spec.wall.thickness = 1;
  spec.wall.unit.density = 2000;
  spec.block = {square("a", 0, "masonry"), square("b", 1, "masonry")};
  spec.block[1].polygon = upper;
  spec.material["joint"] = {};
  FaultList faults;
  Assembly assembly = build_assembly(spec, faults);
  faults.throw_if_any();
  return assembly;
}

TEST(Outlines, of_one_shape_are_one_whatever_corners_describe_them) {
  const Assembly plain = two_blocks({{0, 1}, {1, 1}, {1, 2}, {0, 2}});
  const std::vector<std::vector<std::array<double, 2>>> others = {
      {{0, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}},              // closed
      {{0, 1}, {1, 1}, {1, 2}, {0, 2}, {1e-12, 1 + 1e-12}},  // but for rounding
      {{0, 1}, {1, 1}, {1, 2}, {0, 2}, {1e-6, 1}},  // closed along an edge, by the micrometre
      {{0, 1}, {1, 1}, {1, 2}, {0, 2}, {-7e-6, 1 - 7e-6}},  // or beside it
      {{0, 1}, {1, 1}, {1 + 1e-9, 1}, {1, 2}, {0, 2}},      // a corner twice
      {{0, 1}, {0.5, 1}, {1, 1}, {1, 2}, {0, 2}},           // a corner on the joint
      {{0.3, 1},
       {0.6, 1 + 1e-10},
       {1, 1},
       {1, 1.4},
       {1, 2},
       {0, 2},
       {0, 1}},  // the list begins on an edge
      {{0, 2}, {0.1, 2}, {1, 2}, {1, 1}, {0.9, 1}, {0.2, 1}, {0, 1}}};  // clockwise
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Assembly other = two_blocks(others[k]);
    EXPECT_EQ(other.blocks[1].outline.size(), 4U) << k;
    ASSERT_EQ(other.faces.size(), plain.faces.size()) << k;
  }
  // what is no rounding stays
  EXPECT_EQ(two_blocks({{0, 1}, {1, 1}, {1, 2}, {0.5, 2.0001}, {0, 2}}).blocks[1].outline.size(),
            5U);
}

}  // namespace
}  // namespace wythe::geometry::block_names_test
