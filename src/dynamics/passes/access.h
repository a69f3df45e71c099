// How a Real number loads its lanes from the tables (tables.h) and stores them.
//
//   EntityLanes  lane k is entity k of a group of one wall
//   WallLanes    lane k is wall k: all share geometry, each has its own state
//
// An item is a group of neighbours, or one entity. Both kinds of lanes offer
//   shared(table, row)      one number for all walls         row: item * rows of the table + row
//   load(table, row), store(value, table, row)                 numbers of each wall
//   rows(rows, ids, item)                                    rows of four of the entities ids[item]
//   load_rows(rows, item), store_rows(...)                     rows of four of the item itself
//   of(table, rows, row, ids, item)                          one row of the entities ids[item]
//   wall_value(numbers, row)                                    one number for each wall (time step, law)
//   load_flag(flags, item), store_flag(flags, item, flag)             one flag for all lanes of a Real
//   history_lanes()                                          numbers of a row of history
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/pack.h"
#include "core/several.h"
#include "dynamics/passes/shuffle.h"
#include "dynamics/passes/tables.h"

namespace wythe::dynamics {

template <class Real>
struct Rows {
  Real c0, c1, c2, c3;
};

// Raw loads and stores.
template <class Real>
struct Lanes;

template <>
struct Lanes<double> {
  static constexpr int width = 1;
  WYTHE_INLINE static double load(const double* from) { return *from; }
  WYTHE_INLINE static void store(double value, double* to) { *to = value; }
  WYTHE_INLINE static Rows<double> load_rows(const double* rows, const std::int32_t* id) {
    const double* row = rows + 4 * static_cast<std::ptrdiff_t>(*id);
    return {row[0], row[1], row[2], row[3]};
  }
  WYTHE_INLINE static void store_rows(const Rows<double>& r, double* to) {
    to[0] = r.c0;
    to[1] = r.c1;
    to[2] = r.c2;
    to[3] = r.c3;
  }
};

template <class Arch>
struct Lanes<Pack<Arch>> {
  using Real = Pack<Arch>;
  using Vector = typename Real::Vector;
  static constexpr int width = Real::width;

  WYTHE_INLINE static Real load(const double* from) { return Real::load(from); }
  WYTHE_INLINE static void store(Real value, double* to) { value.store(to); }
  WYTHE_INLINE static Rows<Real> load_rows(const double* rows, const std::int32_t* id) {
    Vector row[4];
    shuffle::load_rows(rows, id, row);
    shuffle::transpose(row);
    return {real(row[0]), real(row[1]), real(row[2]), real(row[3])};
  }
  WYTHE_INLINE static void store_rows(const Rows<Real>& r, double* to) {
    Vector row[4] = {r.c0.lanes, r.c1.lanes, r.c2.lanes, r.c3.lanes};
    shuffle::transpose(row);
    shuffle::store_rows(row, to);
  }

 private:
  WYTHE_INLINE static Real real(Vector v) { return Real(typename Real::Batch(v)); }
};

template <class R>
struct EntityLanes {
  using Real = R;
  using L = Lanes<Real>;
  using Id = std::ptrdiff_t;
  static constexpr bool one_wall = true;
  static constexpr int parts = kGroup / L::width;  // Reals of a group
  static constexpr int sums = parts;               // Reals whose works are summed separately
  int lane = 0;                                    // the first lane that this Real takes

  WYTHE_INLINE static constexpr Id walls() { return 1; }
  WYTHE_INLINE static constexpr Id history_lanes() { return kGroup; }
  WYTHE_INLINE void select_part(int part) { lane = part * L::width; }

  WYTHE_INLINE Real shared(const double* table, Id row) const {
    return L::load(table + row * kGroup + lane);
  }
  WYTHE_INLINE Real load(const double* table, Id row) const { return shared(table, row); }
  WYTHE_INLINE void store(Real value, double* table, Id row) const {
    L::store(value, table + row * kGroup + lane);
  }
  WYTHE_INLINE Rows<Real> rows(const double* from, const std::int32_t* id, Id item) const {
    return L::load_rows(from, id + item * kGroup + lane);
  }
  WYTHE_INLINE void store_rows(const Rows<Real>& r, double* to, Id item) const {
    L::store_rows(r, to + 4 * (item * kGroup + lane));
  }
  WYTHE_INLINE Rows<Real> load_rows(const double* from, Id item) const {
    std::int32_t id[L::width];
    for (int k = 0; k < L::width; ++k) id[k] = k;
    return L::load_rows(from + 4 * (item * kGroup + lane), id);
  }
  WYTHE_INLINE Real of(const double* table, int rows, int row, const std::int32_t* id,
                       Id item) const {
    double lanes[L::width];
    for (int k = 0; k < L::width; ++k) {
      const std::int32_t e = id[item * kGroup + lane + k];
      lanes[k] = table[(static_cast<Id>(e / kGroup) * rows + row) * kGroup + e % kGroup];
    }
    return L::load(lanes);
  }
  WYTHE_INLINE Real wall_value(const double* numbers, Id row) const { return Real(numbers[row]); }
  WYTHE_INLINE Id flag(Id item) const { return item * parts + lane / L::width; }
  WYTHE_INLINE std::uint8_t load_flag(const std::uint8_t* flags, Id item) const {
    return flags[flag(item)];
  }
  WYTHE_INLINE void store_flag(std::uint8_t* flags, Id item, std::uint8_t now) const {
    flags[flag(item)] = now;
  }
  // The kGroup sums of a term, for Real number k.
  WYTHE_INLINE Real sum(const double* term, int k) const { return L::load(term + k * L::width); }
  WYTHE_INLINE void store_sum(Real s, double* term, int k) const {
    L::store(s, term + k * L::width);
  }
};

// `number` walls side by side, all of them in one Real.
template <class R, int number>
struct WallLanes {
  using Real = R;
  using L = Lanes<Real>;
  using Id = std::ptrdiff_t;
  static constexpr bool one_wall = false;
  static constexpr int parts = 1;
  static constexpr int sums = kGroup;

  WYTHE_INLINE Id walls() const { return number; }
  WYTHE_INLINE Id history_lanes() const { return walls(); }
  WYTHE_INLINE void select_part(int) {}
  WYTHE_INLINE Real shared(const double* table, Id row) const { return Real(table[row]); }
  WYTHE_INLINE Real load(const double* table, Id row) const {
    return L::load(table + row * walls());
  }
  WYTHE_INLINE void store(Real value, double* table, Id row) const {
    L::store(value, table + row * walls());
  }
  WYTHE_INLINE Rows<Real> row_of(const double* from, Id entity) const {
    const double* row = from + 4 * entity * walls();
    return {L::load(row), L::load(row + walls()), L::load(row + 2 * walls()),
            L::load(row + 3 * walls())};
  }
  WYTHE_INLINE Rows<Real> rows(const double* from, const std::int32_t* id, Id item) const {
    return row_of(from, id[item]);
  }
  WYTHE_INLINE Rows<Real> load_rows(const double* from, Id item) const {
    return row_of(from, item);
  }
  WYTHE_INLINE void store_rows(const Rows<Real>& r, double* to, Id item) const {
    double* row = to + 4 * item * walls();
    L::store(r.c0, row);
    L::store(r.c1, row + walls());
    L::store(r.c2, row + 2 * walls());
    L::store(r.c3, row + 3 * walls());
  }
  WYTHE_INLINE Real of(const double* table, int rows, int row, const std::int32_t* id,
                       Id item) const {
    return load(table, static_cast<Id>(id[item]) * rows + row);
  }
  WYTHE_INLINE Real wall_value(const double* numbers, Id row) const { return load(numbers, row); }
  WYTHE_INLINE Id flag(Id item) const { return item * (walls() / L::width); }
  WYTHE_INLINE std::uint8_t load_flag(const std::uint8_t* flags, Id item) const {
    return flags[flag(item)];
  }
  WYTHE_INLINE void store_flag(std::uint8_t* flags, Id item, std::uint8_t now) const {
    flags[flag(item)] = now;
  }
  WYTHE_INLINE Real sum(const double* term, int k) const { return L::load(term + k * walls()); }
  WYTHE_INLINE void store_sum(Real s, double* term, int k) const {
    L::store(s, term + k * walls());
  }
};

// The numbers of a law: strengths from one row of the table on, the others from
// another row on. Numbers that a path through the law does not need are not loaded.
template <class Access>
[[nodiscard]] WYTHE_INLINE contact::LawConstants<typename Access::Real> law_of(
    Access access, const double* law, std::ptrdiff_t strengths, std::ptrdiff_t others,
    const contact::LawChoice& choice) {
  using Real = typename Access::Real;
  contact::LawConstants<Real> m;
  for_each_part<kLawRows>([&](auto k) __attribute__((always_inline)) {
    constexpr int row = decltype(k)::value;
    constexpr auto member = contact::kConstants<Real>[row];
    m.*member = access.load(law, row < kStrengths ? strengths + row : others + row - kStrengths);
  });
  m.choice = choice;
  return m;
}

}  // namespace wythe::dynamics
