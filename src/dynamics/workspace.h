// Scratch of the step: what is computed anew each step and never saved.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/law.h"
#include "wythe/model.h"

namespace wythe::dynamics {

// Work done in a step, summed per chunk and added up in order.
struct ChunkEnergy {
  double friction = 0, fracture = 0, crushing = 0;  // written by forces [J]
  double loads = 0, damping = 0;                    // written by integrate [J]
};

// A run of joints of one material that stand on the same kind of neighbour.
struct JointChunk {
  JointId begin = 0, end = 0;
  bool on_ground = false;
};

struct Workspace {
  // Arrays of entities hold `lanes` walls side by side: entity i of wall k at i lanes + k.
  explicit Workspace(const Model& model, int lanes = 1);

  std::vector<contact::LawConstants<double>> law;  // (n_material)
  std::vector<JointChunk> joint_chunks;
  int block_chunks = 0;
  std::vector<double> half_length;  // of a joint's face, along its tangent [m] (n_joint)

  // written by turn_pass: rows ux [m], uy [m], cos theta/2, sin theta/2 (n_block + 1, 4); the last
  // is the ground's, at rest
  std::vector<double> pose;

  // written by forces: rows of the force on side a along x and y [N], the moments on a and b about
  // their centroids [N m] (n_joint, 4)
  std::vector<double> force;

  // whether a joint's points, then a zone contact's, were not at rest (n_joint + n_contact): which way
  // a step takes, never what it gives
  std::vector<std::uint8_t> busy;

  // written by gather: contact forces and loads on each block (n_block)
  std::vector<double> contact_x, contact_y, contact_m;  // [N], [N m]
  std::vector<double> load_x, load_y, load_m;           // applied point loads [N], [N m]
  std::vector<double> total_x, total_y, total_m;        // with gravity and body force

  std::vector<double> is_free;  // 0: moved by drive_pass (n_block), set at a stage's start
  std::vector<std::int32_t> block_middle;  // first entry of a block where it is side b (n_block)

  // written by zone_pass: rows of the forces on corners 0 and 1, then those on 2 and 3 (2, n_zone, 4)
  std::vector<double> zone_force;  // [N]
  // written by zone_contact_pass: rows on the rigid block and on the edge's nodes (n_contact, 4)
  std::vector<double> contact_block_force, contact_edge_force;
  // written by node_pass: forces on each node with gravity (n_node) [N]
  std::vector<double> node_total_x, node_total_y;
  std::vector<JointChunk> contact_chunks;  // on_ground unused
  std::vector<JointChunk> zone_chunks;     // of one shape
  int node_chunks = 0;

  std::vector<ChunkEnergy> joint_energy, block_energy, contact_energy, node_energy;  // (chunks)
};

inline constexpr int kChunk = 256;  // joints or blocks; fixed, so sums do not depend on threads

}  // namespace wythe::dynamics
