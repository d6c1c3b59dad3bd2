// `pair_style gran/bridge`: contacts of grains by the laws of dem_physics/contact, in LIGGGHTS's
// words or with the law of LAMMPS's own gran/hertz/history and gran/hooke/history
// (dem_physics/contact/contact_words.h has both forms).
//
// This class holds no physics: it gives the stack of laws LAMMPS's arrays, neighbour list and
// history, and tells LAMMPS how far the laws reach.
#ifndef GASGRAIN_LAMMPS_PAIR_GRAN_BRIDGE_H
#define GASGRAIN_LAMMPS_PAIR_GRAN_BRIDGE_H

#include <map>
#include <string>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/contact_words.h"
#include "fix_cfd_coupling/lammps/body_masses.h"
#include "fix_cfd_coupling/lammps/contact_host_lammps.h"
#include "pair.h"

namespace LAMMPS_NS {

class FixGranBridgeHistory;

class PairGranBridge : public Pair, private gasgrain::contact::ContactObserver {
 public:
  explicit PairGranBridge(LAMMPS* host);
  ~PairGranBridge() override;

  void settings(int narg, char** arg) override;
  void coeff(int narg, char** arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  void compute(int eflag, int vflag) override;
  double single(int i, int j, int itype, int jtype, double rsq, double factor_coul,
                double factor_lj, double& fforce) override;

  void transfer_history(double* from, double* to) override;
  void write_restart(FILE* file) override;
  void read_restart(FILE* file) override;
  void write_restart_settings(FILE* file) override;
  void read_restart_settings(FILE* file) override;
  int pack_forward_comm(int n, int* list, double* buffer, int pbc_flag, int* pbc) override;
  void unpack_forward_comm(int n, int first, double* buffer) override;
  double atom2cut(int i) override;
  double radii2cut(double r1, double r2) override;

  // For the laws and the fixes. Bodies are to be shown up to so many times r_i + r_j apart.
  void reach_at_least(double times);
  void send_to_ghosts(double* values);
  [[nodiscard]] const gasgrain::contact::StackName& models() const { return choice_.name; }
  // Properties that stand among the words, of all types alike.
  [[nodiscard]] const std::map<std::string, double>& properties() const {
    return choice_.properties;
  }
  // Where the neighbour list's pairs keep their history; null where no law has one.
  [[nodiscard]] FixGranBridgeHistory* history_fix() const { return fix_history_; }
  [[nodiscard]] int history_width() const { return static_cast<int>(history_.size()); }

 private:
  void allocate();
  void set_words(const std::vector<std::string>& words);
  void connect_laws();
  void find_largest_radii();
  void make_history_fix();
  [[nodiscard]] gasgrain::contact::ContactRows rows() const;
  void acts(int i, int j, const gasgrain::contact::Triple& force,
            const gasgrain::contact::Triple& delta) override;

  std::vector<std::string> words_;
  std::string history_id_;
  gasgrain::LammpsContactHosts hosts_;
  gasgrain::contact::ContactChoice choice_;
  std::vector<gasgrain::contact::HistoryValue> history_values_;
  std::vector<double> history_;  // factor of each value where i and j swap
  gasgrain::contact::Reach reach_;
  gasgrain::BodyMasses bodies_;
  int frozen_ = 0;  // bit of the group of fix freeze
  // By type, of grains that move and of frozen ones.
  std::vector<double> largest_moving_, largest_frozen_;
  FixGranBridgeHistory* fix_history_ = nullptr;
  double* to_ghosts_ = nullptr;  // what is being sent
};

}  // namespace LAMMPS_NS
#endif
