// Parts that the readers of meshes share: numbers, faults with their line, bodies from faces.
//
// Called by meshes.cpp and ply.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/limits.h"
#include "core/number.h"
#include "core/text.h"
#include "geometry/bodies/pieces.h"
#include "io/bodies/meshes.h"

namespace wythe::io {

template <class T>
std::optional<T> mesh_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return parse_number<T>(text);
}

// Words of a line, separated by blanks and tabs.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

// Lines of a text in order, with their numbers; a "\" at the end joins the next line.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  // False at the end of the text.
  bool next(std::string_view& line);
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::string joined_;
  int number_ = 0, lines_ = 0;
};

class MeshFaults {
 public:
  MeshFaults(const std::string& file, FaultList& faults) : file_(file), faults_(faults) {}
  void add(int line, std::string_view value, std::string problem, std::string cure);
  [[nodiscard]] bool enough() const { return wythe::enough(faults_); }

 private:
  std::string file_;
  FaultList& faults_;
};

// A body of these faces, with only the corners that they use.
[[nodiscard]] BodySpec body_of_faces(std::string id, const std::vector<Vec3>& vertex,
                                     const geometry::FaceList& faces);
// Every solid as a body: `name` if there is one, else `name`1, `name`2 ... Refuses
// a file with very many faces at one edge, or with faces that form no solid.
[[nodiscard]] std::vector<BodySpec> bodies_of_solids(const std::string& name,
                                                     const std::vector<Vec3>& all,
                                                     geometry::FaceList faces, MeshFaults& faults);

}  // namespace wythe::io
