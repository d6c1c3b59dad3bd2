// `fix ID group wall/gran/bridge CONTACT primitive type T SHAPE [WORD VALUE]...`: a wall that
// grains touch, by the laws of dem_physics/contact; CONTACT is as in `pair_style gran/bridge`.
//
//   SHAPE  xplane|yplane|zplane C, or xcylinder|ycylinder|zcylinder R A B: radius and the centre in
//          the two axes that follow the cylinder's own (zcylinder: x and y; ycylinder: z and x)
//   T      the wall's material, a type of the scene
//
// f_ID[1..3] of the fix: the force on the wall [N].
#ifndef GASGRAIN_LAMMPS_FIX_WALL_GRAN_BRIDGE_H
#define GASGRAIN_LAMMPS_FIX_WALL_GRAN_BRIDGE_H

#include <string>
#include <vector>

#include "fix.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_words.h"
#include "fix_cfd_coupling/lammps/body_masses.h"
#include "fix_cfd_coupling/lammps/contact_host_lammps.h"

namespace LAMMPS_NS {

class FixWallGranBridge : public Fix, private gasgrain::contact::ContactObserver {
 public:
  FixWallGranBridge(LAMMPS* host, int narg, char** arg);
  ~FixWallGranBridge() override;

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void post_force(int vflag) override;
  double compute_vector(int n) override;
  double memory_usage() override;

  void grow_arrays(int nmax) override;
  void copy_arrays(int i, int j, int delflag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double* buffer) override;
  int unpack_exchange(int i, double* buffer) override;
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int nth) override;
  int size_restart(int i) override;
  int maxsize_restart() override;

  // For the fixes.
  [[nodiscard]] int type() const { return type_; }  // of the wall's material
  void reach_at_least(double times);
  [[nodiscard]] const gasgrain::contact::PrimitiveWall& shape() const { return shape_; }

 private:
  void read(std::vector<std::string> words);
  void read_shape(std::vector<std::string>& words);
  void find_near_grains();
  void acts(int i, int j, const gasgrain::contact::Triple& force,
            const gasgrain::contact::Triple& delta) override;

  gasgrain::LammpsContactHosts hosts_;
  gasgrain::contact::ContactChoice choice_;
  gasgrain::contact::PrimitiveWall shape_;
  gasgrain::contact::Reach reach_;
  int type_ = 0;
  int width_ = 0;            // of a row, its last value included; 0: no law has a history
  double** rows_ = nullptr;  // a row for each grain
  std::vector<int> near_;    // grains that may touch before the lists are made again
  gasgrain::BodyMasses bodies_;
  gasgrain::contact::Triple force_;  // on the wall, of this rank
};

}  // namespace LAMMPS_NS
#endif
