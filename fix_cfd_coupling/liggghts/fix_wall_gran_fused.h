// The host's `fix wall/gran`, which beside `pair_style gran/bridge` takes the contacts with a plane
// or a cylinder through the pair style's own loop.
//
// The host's fix stays underneath: it reads the words, finds the grains near to the wall, and keeps
// their history. Its own models go on to serve meshes, cohesion, and whatever somebody wants to
// know of single contacts; once, at the first run, it says why.
#ifndef GASGRAIN_LIGGGHTS_FIX_WALL_GRAN_FUSED_H
#define GASGRAIN_LIGGGHTS_FIX_WALL_GRAN_FUSED_H

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fix_cfd_coupling/liggghts/compiled_contact.h"
// --
#include "fix_wall_gran.h"

namespace LAMMPS_NS {

class [[gnu::visibility("default")]] FixWallGranFused final : public FixWallGran {
 public:
  FixWallGranFused(LAMMPS * host, int narg, char** arg);

  void init() override;

  // Whether the wall finds grains that get new pairs by themselves (neighbor_sorted.h).
  [[nodiscard]] bool follows_renewed_lists() const;

 protected:
  void pre_force(int vflag) override;
  void post_force_primitive(int vflag) override;

 private:
  void read(const std::vector<std::string>& words);
  [[nodiscard]] bool is_beside_own_loop() const;
  // Why the host's models are needed at this wall; empty: they are not.
  [[nodiscard]] std::string needs_host() const;

  void take_near_grains();

  std::unique_ptr<gasgrain::CompiledContact> contact_;  // null: these words are not compiled
  gasgrain::contact::PrimitiveWall shape_;
  std::optional<std::string> said_;  // of needs_host()
  // Grains near to the wall: the host's, then those that came later; and whether each of them
  // touches, or may have touched before it was found.
  std::vector<int> near_, in_use_;
  std::vector<char> is_near_;  // by grain
};

}  // namespace LAMMPS_NS
#endif
