// Solids as texts of mesh files, for tests of their readers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "wythe/parts/body.h"

namespace wythe::scenes {

inline const std::string kTwoBoxes =
    "# two boxes\no low\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "usemtl tuff\nf 1/1 4/2 3 2\nf 5//1 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
    "g high\nusemtl brick\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\n"
    "f -8 -5 -6 -7\nf -4 -3 -2 -1\nf -8 -7 -3 \\\n-4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 "
    "-1\n";

inline std::vector<std::array<Vec3, 3>> triangles_of(const std::vector<BodySpec>& bodies) {
  std::vector<std::array<Vec3, 3>> all;
  for (const BodySpec& body : bodies)
    for (const Polyhedron& part : body.part)
      for (const auto& f : part.face)
        for (std::size_t k = 1; k + 1 < f.size(); ++k) {
          const auto v = [&](std::size_t i) { return part.vertex[f[i]]; };
          all.push_back({v(0), v(k), v(k + 1)});
        }
  return all;
}

inline std::string ascii_stl(const std::vector<BodySpec>& bodies) {
  std::string text = "solid wall\n";
  for (const auto& t : triangles_of(bodies)) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const Vec3 p : t)
      text += "  vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
              std::to_string(p.z) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid wall\n";
}

inline void add_bytes(std::string& text, const void* from, std::size_t n, bool big = false) {
  std::string bytes(static_cast<const char*>(from), n);
  if (big) std::reverse(bytes.begin(), bytes.end());
  text += bytes;
}

inline std::string binary_stl(const std::vector<BodySpec>& bodies) {
  const auto triangles = triangles_of(bodies);
  std::string text = "solid, as some programs begin binary files too";
  text.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(triangles.size());
  add_bytes(text, &count, 4);
  for (const auto& t : triangles) {
    text += std::string(12, '\0');
    for (const Vec3 p : t)
      for (const double x : {p.x, p.y, p.z}) {
        const auto f = static_cast<float>(x);
        add_bytes(text, &f, 4);
      }
    text += std::string(2, '\0');
  }
  return text;
}

inline std::string ply(const std::vector<BodySpec>& bodies, const std::string& form) {
  std::string head, text;
  int vertices = 0, faces = 0;
  const bool big = form == "binary_big_endian";
  for (const BodySpec& body : bodies)
    for (const Vec3 v : body.part[0].vertex) {
      ++vertices;
      if (form == "ascii")
        text +=
            std::to_string(v.x) + " 7 " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
      const std::uint8_t red = 7;
      for (int k = 0; form != "ascii" && k < 3; ++k) {
        const double x = k == 0 ? v.x : k == 1 ? v.y : v.z;
        add_bytes(text, &x, 8, big);
        if (k == 0) add_bytes(text, &red, 1);
      }
    }
  std::int32_t first = 0;
  for (const BodySpec& body : bodies) {
    for (const auto& f : body.part[0].face) {
      ++faces;
      const auto n = static_cast<std::uint8_t>(f.size());
      if (form == "ascii") text += std::to_string(n);
      if (form != "ascii") add_bytes(text, &n, 1);
      for (const std::int32_t i : f) {
        const std::int32_t at = i + first;
        if (form == "ascii") text += " " + std::to_string(at);
        if (form != "ascii") add_bytes(text, &at, 4, big);
      }
      if (form == "ascii") text += "\n";
    }
    first += static_cast<std::int32_t>(body.part[0].vertex.size());
  }
  head = "ply\nformat " + form + " 1.0\ncomment of a test\nelement vertex " +
         std::to_string(vertices) +
         "\nproperty double x\nproperty uchar red\nproperty double y\nproperty double z\nelement "
         "face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
  return head + text;
}

}  // namespace wythe::scenes
