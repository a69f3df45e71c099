// The tower of the peers, and what is measured of it, from poses alone: the same for them (peers.cpp) and for wythe (ours.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace peers {

constexpr double kLength = 0.25, kHeight = 0.125, kThickness = 0.25, kDensity = 2000;  // of a block
constexpr double kFriction = 0.6, kGravity = 9.81, kPush = 0.5 * kGravity, kPushed = 1.0;
constexpr double kDuration = 4.0, kLook = 0.02;  // [s]

struct Block {
  double x, y, width;
  [[nodiscard]] double mass() const { return kDensity * width * kHeight * kThickness; }
  [[nodiscard]] double inertia() const { return mass() * (width * width + kHeight * kHeight) / 12; }
};
struct Pose {
  double x, y, turn, vx, vy, spin;
};

inline std::vector<Block> tower(int columns, int courses) {
  std::vector<Block> blocks;
  for (int course = 0; course < courses; ++course) {
    const double y = (course + 0.5) * kHeight;
    const bool shifted = course % 2 != 0;
    if (shifted) blocks.push_back({0.25 * kLength, y, 0.5 * kLength});
    for (int c = 0; c < columns - (shifted ? 1 : 0); ++c)
      blocks.push_back({(c + (shifted ? 1.0 : 0.5)) * kLength, y, kLength});
    if (shifted) blocks.push_back({(columns - 0.25) * kLength, y, 0.5 * kLength});
  }
  return blocks;
}

// --- what is measured, from poses alone ---------------------------------------------------------------------------

using Corners = std::array<std::array<double, 2>, 4>;
inline Corners corners_of(const Block& b, const Pose& p) {
  const double c = std::cos(p.turn), s = std::sin(p.turn), w = 0.5 * b.width, h = 0.5 * kHeight;
  Corners out;
  const double at[4][2] = {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
  for (int k = 0; k < 4; ++k)
    out[k] = {p.x + c * at[k][0] - s * at[k][1], p.y + s * at[k][0] + c * at[k][1]};
  return out;
}

// How far two boxes would have to move to part; 0 where they are apart.
inline double depth(const Corners& a, const Corners& b) {
  double least = 1e9;
  for (const Corners* of : {&a, &b})
    for (int k = 0; k < 2; ++k) {
      double nx = (*of)[k + 1][1] - (*of)[k][1], ny = (*of)[k][0] - (*of)[k + 1][0];
      const double length = std::hypot(nx, ny);
      nx /= length, ny /= length;
      double a0 = 1e9, a1 = -1e9, b0 = 1e9, b1 = -1e9;
      for (const auto& p : a)
        a0 = std::min(a0, nx * p[0] + ny * p[1]), a1 = std::max(a1, nx * p[0] + ny * p[1]);
      for (const auto& p : b)
        b0 = std::min(b0, nx * p[0] + ny * p[1]), b1 = std::max(b1, nx * p[0] + ny * p[1]);
      least = std::min({least, a1 - b0, b1 - a0});
    }
  return std::max(0.0, least);
}

struct Measured {
  double depth = 0;   // deepest of all times [m]
  double growth = 0;  // of the energy above its least so far [J]
  double fallen = 0;  // energy lost from the start to the end [J]
  double seconds = 0;
  long steps = 0;
};

class Meter {
 public:
  explicit Meter(const std::vector<Block>& blocks) : blocks_(blocks) {}
  void look(const std::vector<Pose>& poses, double push) {
    std::vector<Corners> corners;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      corners.push_back(corners_of(blocks_[i], poses[i]));
      order.push_back(i);
      for (const auto& p : corners.back()) deepest_ = std::max(deepest_, -p[1]);
    }
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return poses[a].x < poses[b].x; });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && poses[order[j]].x - poses[order[i]].x < 0.3;
           ++j)
        if (std::fabs(poses[order[j]].y - poses[order[i]].y) < 0.3)
          deepest_ = std::max(deepest_, depth(corners[order[i]], corners[order[j]]));
    double energy = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Pose& p = poses[i];
      const double m = blocks_[i].mass();
      energy += 0.5 * m * (p.vx * p.vx + p.vy * p.vy) +
                0.5 * blocks_[i].inertia() * p.spin * p.spin + m * kGravity * p.y - m * push * p.x;
    }
    if (push != push_) least_ = energy;  // the field has changed
    push_ = push;
    growth_ = std::max(growth_, energy - least_);
    least_ = std::min(least_, energy);
  }
  [[nodiscard]] double deepest() const { return deepest_; }
  [[nodiscard]] double growth() const { return growth_; }

 private:
  const std::vector<Block>& blocks_;
  double deepest_ = 0, growth_ = 0, least_ = 1e99, push_ = kPush;
};

}  // namespace peers
