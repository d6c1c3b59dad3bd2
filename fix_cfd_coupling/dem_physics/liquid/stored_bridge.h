// What a contact remembers of its liquid bridge. The host keeps it with the contact, moves it with
// the grains and writes it to restarts, as `size` doubles.
//
//   volume   of liquid in the bridge [m3]; 0: there is none; `asked`: one forms with the next step
//   lean     (g_i - g_j) / (g_i + g_j) of the liquid that i and j gave, -1 to 1; its sign changes
//            when the host swaps i and j
//   rupture  gap at which it breaks [m]
//   pull, damping_normal, damping_tangential
//            at contact, where most bridges of a bed are: capillary force [N], viscous coefficients
//            at the minimum separation [N s/m]. They follow from the volume, which a bridge keeps,
//            and cost a law's logarithms and roots once, not every step.
//
// A bridge forms in two steps, so that what grains give at once never passes what they have: it is
// asked for in one and granted in the next (grain_films.h).
#pragma once

namespace gasgrain::liquid {

struct StoredBridge {
  double volume;
  double lean;
  double rupture;
  double pull, damping_normal, damping_tangential;

  static constexpr int size = 6;
  static constexpr double asked = -1.0;

  [[nodiscard]] bool absent() const { return volume == 0.0; }
  [[nodiscard]] bool is_asked() const { return volume == asked; }
  [[nodiscard]] bool stands() const { return volume > 0.0; }
  void clear() { *this = {}; }
};

// Where the host keeps it.
inline StoredBridge& stored_bridge(double* at) {
  static_assert(sizeof(StoredBridge) == StoredBridge::size * sizeof(double));
  return *reinterpret_cast<StoredBridge*>(at);
}

// Liquid that i, and that j, gave [m3].
inline double given_by_i(const StoredBridge& b) {
  return b.volume * (0.5 + 0.5 * b.lean);
}
inline double given_by_j(const StoredBridge& b) {
  return b.volume * (0.5 - 0.5 * b.lean);
}

}  // namespace gasgrain::liquid
