// The volumetric rate of momentum between big and small grains in cubes about each big one, window
// by window: as the DEM has it and as Syamlal's formula makes it of the cube's means.
//
//   F_DEM = -(1/V) (mean over the window of the force on the big grains in V)     Shah's eq. 11
//   F_Sy  = syamlal_drag of the window's means of fractions and velocities        eq. 10
//   omega = F_DEM . F_Sy / |F_Sy|^2                                               eq. 12
//
// Source: S. Shah, P. Jalali, Powder Technol. 363 (2020) 584.
// Units: rates [N/m3], of what the small phase gains; fractions of the cube's whole volume.
// Assumptions: what pushes a big grain is the small ones; the cube lies within the domain.
// Deviations: eq. 11 prints the number of contacts in the divisor too, which would make it the mean
//   force of a contact; the sum of all contacts is taken. Omega is the component along F_Sy.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "tools/analyse/control_volume.h"
#include "tools/analyse/run_facts.h"
#include "tools/analyse/syamlal_drag.h"

namespace gasgrain {

// The grains of a frame, parted. `position` is m, `force` N.
struct Phases {
  long step = 0;
  std::vector<MovingGrain> big;
  std::vector<MovingGrain> small;
};

struct DragRate {
  double time_s = 0.0;  // end of the window
  int big_id = 0;
  double size = 0.0;  // of the cube, in d_s + d_b
  double side = 0.0;  // m
  SolidPhase s;
  SolidPhase b;
  Vec3 dem = Vec3::Zero();      // N/m3; NaN when the dumps have no force
  Vec3 syamlal = Vec3::Zero();  // N/m3

  // Not finite when Syamlal's rate is 0, or the dumps have no force.
  [[nodiscard]] double omega() const;
};

// Frames go in by their step; full windows come out.
class DragRates {
 public:
  // `small_diameter` [m] is d_s in a cube's side; a window lasts `steps` DEM steps.
  DragRates(RunFacts facts, std::vector<double> sizes, double small_diameter, long steps);

  // A frame stands for the steps since the last one, `spacing` of them.
  void add(const Phases& phases, long spacing);
  // By size, big grain and time.
  [[nodiscard]] std::vector<DragRate> rates() const;
  // Steps of windows that the run left unfinished.
  [[nodiscard]] long left_over() const;

 private:
  struct Sum {
    long steps = 0;
    double side = 0.0;
    PhaseContent small;  // times steps
    PhaseContent big;
    double big_diameter = 0.0;
  };
  [[nodiscard]] DragRate rate(double size, int id, long window, const Sum& sum) const;

  RunFacts facts_;
  std::vector<double> sizes_;
  double small_diameter_;
  long window_steps_;
  std::map<std::tuple<std::size_t, int, long>, Sum> sums_;  // by size, id, window
};

}  // namespace gasgrain
