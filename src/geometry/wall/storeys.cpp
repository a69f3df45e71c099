// Each storey has the keys of the wall, replaced by its own. Mortar is added to bare units at once, so that all sizes are
// nominal afterwards. A storey remembers which sizes it states itself, so that a fault names the key that the user wrote.
// Faults of inherited values are reported once.
#include "geometry/wall/storeys.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

double or_else(double value, double otherwise) { return std::isnan(value) ? otherwise : value; }

// False where the text is an unknown word; "" leaves the value unchanged.
template <class E, std::size_t N>
bool take_word(const std::string& stated, const Word<E> (&words)[N], E& value) {
  for (const Word<E>& word : words)
    if (word.word == stated) {
      value = word.value;
      return true;
    }
  return stated.empty();
}

template <class E, std::size_t N>
void check_word(int storey, const char* key, const std::string& stated, const Word<E> (&words)[N],
                FaultList& faults) {
  E value{};
  if (take_word(stated, words, value)) return;
  std::vector<std::string> known;
  for (const Word<E>& word : words) known.emplace_back(word.word);
  add_fault(faults, storey_path(storey, key), "\"" + stated + "\"",
            "must be one of " + joined(known, ", "), name_advice(stated, known));
}

void check_words(const std::vector<StoreySpec>& storeys, FaultList& faults) {
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    check_word(static_cast<int>(i), "bond", storeys[i].bond, kBondWords, faults);
    check_word(static_cast<int>(i), "fit", storeys[i].fit, kFitWords, faults);
  }
}

// Makes a bare unit nominal by half a joint on each side.
void add_mortar(UnitSpec& unit) {
  if (std::isnan(unit.mortar.bed) && std::isnan(unit.mortar.head)) return;
  const double bed = or_else(unit.mortar.bed, unit.mortar.head);
  const double head = or_else(unit.mortar.head, unit.mortar.bed);
  unit.mortar = {bed, head};
  unit.length += head;
  unit.width += head;
  unit.height += bed;
  unit.real.length += head;
  unit.real.height += bed;
}

void take_sizes(const StoreySpec& stated, Storey& storey) {
  const auto take = [&](const char* key, double own, double& value) {
    if (std::isnan(own)) return;
    value = own;
    storey.own.emplace_back(key);
  };
  const UnitSpec& unit = stated.unit;
  take("thickness", stated.thickness, storey.thickness);
  take("unit.length", unit.length, storey.unit.length);
  take("unit.height", unit.height, storey.unit.height);
  take("unit.width", unit.width, storey.unit.width);
  take("unit.density", unit.density, storey.unit.density);
  take("unit.mortar.bed", unit.mortar.bed, storey.unit.mortar.bed);
  take("unit.mortar.head", unit.mortar.head, storey.unit.mortar.head);
  take("unit.real.length", unit.real.length, storey.unit.real.length);
  take("unit.real.height", unit.real.height, storey.unit.real.height);
}

Storey wall_itself(const WallSpec& wall) {
  Storey storey;
  storey.length = wall.length;
  storey.height = wall.height;
  storey.thickness = wall.thickness;
  storey.bond = wall.bond;
  storey.fit = wall.fit;
  storey.unit = wall.unit;
  return storey;
}

Storey storey_of(const WallSpec& wall, const StoreySpec& stated, int index) {
  Storey storey = wall_itself(wall);
  storey.index = index;
  storey.name = stated.name;
  storey.height = stated.height;
  storey.own.emplace_back("height");
  take_sizes(stated, storey);
  (void)take_word(stated.bond, kBondWords, storey.bond);
  (void)take_word(stated.fit, kFitWords, storey.fit);
  if (!stated.fit.empty()) storey.own.emplace_back("fit");
  storey.unit.split = stated.unit.split;
  return storey;
}

void check_names(const std::vector<StoreySpec>& storeys, FaultList& faults) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    const std::string& name = storeys[i].name;
    const std::string path = storey_path(static_cast<int>(i), "name");
    if (name.empty())
      add_fault(faults, path, "", "missing: openings, floors and regions name their storey",
                "write e.g. name = \"ground\"");
    else if (!seen.insert(name).second)
      add_fault(faults, path, "\"" + name + "\"", "two storeys have this name",
                "give each storey a name of its own; they stand on each other in their order");
  }
}

void check_sum(const WallSpec& wall, const std::vector<Storey>& storeys, FaultList& faults) {
  const double sum = storeys.back().top();
  constexpr double kSame = 1e-6;  // [m]
  if (std::isnan(wall.height) || std::isnan(sum) || std::abs(sum - wall.height) <= kSame) return;
  std::string parts;
  for (const Storey& storey : storeys)
    parts += (parts.empty() ? "" : " + ") + metres(storey.height);
  add_fault(faults, "wall.height", metres(wall.height),
            "the storeys add up to " + metres(sum) + " (" + parts + ")",
            "leave wall.height out, or change a storey's height");
}

// Reports a fault that several storeys inherit only once.
void add_once(const FaultList& found, FaultList& faults) {
  for (const Fault& fault : found.all()) {
    const auto is_told = [&](const Fault& f) {
      return f.path == fault.path && f.problem == fault.problem;
    };
    const auto& told = faults.all();
    if (std::none_of(told.begin(), told.end(), is_told)) faults.add(fault);
  }
}

// Refuses joints thicker than the bare unit: they are typing errors that would make any wall fit.
bool mortar_fits(const Storey& storey, const char* key, double joint, double bare, const char* side,
                 FaultList& faults) {
  if (std::isnan(joint)) return true;
  if (!is_not_negative({storey.path_of(key), joint, "m", "10 mm"}, faults)) return false;
  if (!(joint > bare)) return true;
  add_fault(faults, storey.path_of(key), millimetres(joint),
            std::string("is thicker than the unit is ") + side + " (" + millimetres(bare) + ")",
            "write e.g. " + last_key(key) + " = \"10 mm\"");
  return false;
}

bool mortar_fits(const Storey& storey, FaultList& faults) {
  const auto& [bed, head] = storey.unit.mortar;
  const bool bed_fits =
      mortar_fits(storey, "unit.mortar.bed", bed, storey.unit.height - bed, "high", faults);
  const bool head_fits = mortar_fits(storey, "unit.mortar.head", head,
                                     (storey.unit.length - head) / 2, "half long", faults);
  return bed_fits && head_fits;
}

// Checks that the drawn unit is a multiple of the real one, within the tolerance of fit = "whole".
void check_real(const Storey& storey, const char* key, double real, double drawn, double joint,
                FaultList& faults) {
  if (std::isnan(real) || !is_positive({storey.path_of(key), real - joint, "m", "65 mm"}, faults) ||
      !(drawn > 0))
    return;
  const double ratio = drawn / real, count = std::max(1.0, std::round(ratio));
  if (std::fabs(ratio / count - 1) <= kFitTolerance + 1e-9) return;
  const std::string value = millimetres(real - joint), unit = millimetres(drawn - joint),
                    word = last_key(key);
  if (ratio < 1)
    return add_fault(faults, storey.path_of(key), value,
                     "is larger than the drawn unit (" + unit + "), which stands for one or more",
                     "write the size of the units as they were built, or leave real out");
  add_fault(faults, storey.path_of(key), value,
            "is " + times(1 / ratio) + " of the drawn unit (" + unit +
                "), which must stand for a whole number of real ones",
            "write unit." + word + " = \"" + millimetres(count * real - joint) + "\", or real." +
                word + " = \"" + millimetres(drawn / count - joint) + "\"");
}

void check_body(const Storey& storey, FaultList& faults) {
  (void)is_positive({storey.path_of("thickness"), storey.thickness, "m", "0.31 m"}, faults);
  (void)is_positive({storey.path_of("unit.density"), storey.unit.density, "kg/m^3", "1250 kg/m^3"},
                    faults);
}

void add_notes(const Storey& storey, std::vector<Message>& said, std::vector<Message>& notes) {
  for (Message& note : said)
    notes.push_back(storey.index < 0
                        ? std::move(note)
                        : Message{"storey.says", {{"storey", storey.name}, {"said", note}}});
}

}  // namespace

double Storey::bed_mortar() const { return or_else(unit.mortar.bed, 0); }
double Storey::head_mortar() const { return or_else(unit.mortar.head, 0); }

std::string Storey::called() const {
  return "storey " + std::to_string(index) + (name.empty() ? "" : " (" + name + ")");
}

std::string Storey::path_of(const std::string& key) const {
  const bool is_own = std::find(own.begin(), own.end(), key) != own.end();
  return is_own ? storey_path(index, key) : "wall." + key;
}

std::vector<Storey> stated_storeys(const WallSpec& wall, const std::vector<StoreySpec>& storey) {
  std::vector<Storey> storeys;
  double foot = 0;
  for (std::size_t i = 0; i < storey.size(); ++i) {
    storeys.push_back(storey_of(wall, storey[i], static_cast<int>(i)));
    storeys.back().foot = foot;
    foot = storeys.back().top();
  }
  if (storey.empty()) storeys = {wall_itself(wall)};
  for (Storey& each : storeys) add_mortar(each.unit);
  return storeys;
}

std::vector<Storey> plan_storeys(const Shape& shape, bool cut_all, std::vector<Message>& notes,
                                 FaultList& faults) {
  check_names(shape.storey, faults);
  check_words(shape.storey, faults);
  std::vector<Storey> storeys = stated_storeys(shape.wall, shape.storey);
  int course = 0;
  for (Storey& storey : storeys) {
    if (cut_all) storey.fit = Fit::kCut;
    FaultList found;
    std::vector<Message> said;
    check_body(storey, found);
    storey.lattice = fit_lattice(storey, said, found);
    if (!mortar_fits(storey, found)) storey.lattice = {};
    const UnitSpec& unit = storey.unit;
    check_real(storey, "unit.real.length", unit.real.length, unit.length, storey.head_mortar(),
               found);
    check_real(storey, "unit.real.height", unit.real.height, unit.height, storey.bed_mortar(),
               found);
    storey.first_course = course;
    course += storey.lattice.courses.count;
    add_once(found, faults);
    add_notes(storey, said, notes);
  }
  if (!shape.storey.empty()) check_sum(shape.wall, storeys, faults);
  return storeys;
}

std::vector<Storey> level_storeys(const Shape& shape, double foot, FaultList& faults) {
  check_names(shape.storey, faults);
  std::vector<Storey> storeys = stated_storeys(shape.wall, shape.storey);
  if (shape.storey.empty()) return storeys;
  for (Storey& storey : storeys) {
    FaultList found;
    (void)is_positive({storey.path_of("thickness"), storey.thickness, "m", "0.31 m"}, found);
    (void)is_positive({storey.path_of("height"), storey.height, "m", "3.20 m"}, found);
    add_once(found, faults);
    storey.foot += foot;
  }
  return storeys;
}

const Storey& storey_at(const std::vector<Storey>& storeys, double y) {
  const auto above = std::upper_bound(storeys.begin(), storeys.end(), y,
                                      [](double at, const Storey& s) { return at < s.foot; });
  return above == storeys.begin() ? storeys.front() : *(above - 1);
}

long row_at(const std::vector<Storey>& storeys, double y) {
  constexpr double kOnLine = 1e-6;  // of a course
  const Storey& storey = storey_at(storeys, y + kOnLine * storeys.front().lattice.courses.step);
  const double rows = (y - storey.foot) / storey.lattice.courses.step;
  return storey.first_course + static_cast<long>(rows + kOnLine);
}

const Storey* find_storey(const std::vector<Storey>& storeys, const std::string& name,
                          const std::string& path, FaultList& faults) {
  std::vector<std::string> names;
  for (const Storey& storey : storeys) {
    if (storey.index >= 0 && storey.name == name) return &storey;
    if (storey.index >= 0) names.push_back(storey.name);
  }
  // a storey without a name may be the wanted one: its missing name is reported
  if (std::find(names.begin(), names.end(), "") != names.end()) return nullptr;
  add_fault(faults, path, "\"" + name + "\"",
            names.empty() ? "the model has no [[storey]]" : "there is no such storey",
            names.empty() ? "add [[storey]] with name = \"" + name + "\" and its height"
                          : name_advice(name, names));
  return nullptr;
}

}  // namespace wythe::geometry
