// What a scene says about a source of parcels: the words of `fix ID all parcels/inject KEYWORD
// VALUE...`. One source a fix: a nozzle, or a face.
//
// Nozzle:
//   at X Y Z                centre of its opening [m]
//   nozzle_radius R         of the opening, a disc across the direction [m] (default 0: a point)
//   direction X Y Z         of any length
//   half_angle A            of the cone of directions [degrees], even in solid angle (default 0)
//   mass_flow M             [kg/s], of the liquid or of the solids
// Face:
//   face SIDE               x_lo x_hi y_lo y_hi z_lo z_hi; parcels go inwards, along its normal
//   rectangle A B C D       part of it, low and high coordinates along its two axes in the order
//                           x y z: A <= first <= B, C <= second <= D [m] (default: all)
//   fraction T              volume fraction of the particles fed; the mass flow follows
// Both:
//   speed U                 [m/s]
//   size LAW VALUES         size_distribution.h; radii of particles [m]
//   solid RHO               solid particles of this density [kg/m3]
//   liquid RHO NAME X ...   droplets of this density [kg/m3] with the mass fractions X of species,
//                           which add up to 1, on a vanishing solid core
//   core R RHO              of a droplet: radius [m], density [kg/m3] (default 1e-10 2500: 1e-4 um
//                           as in O'Rourke et al. 2009)
//   particles N | parcels_per_second N | parcels_per_step N    how the mass is divided
//   from T  to T            [s] (default: always)
//   type N                  of the host's atoms (default 1)
//   seed N                  (default 1)
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "coupling/base/box_grid.h"
#include "fix_cfd_coupling/dem_physics/parcels/parcel_settings.h"
#include "fix_cfd_coupling/dem_physics/parcels/size_distribution.h"

namespace gasgrain {

enum class ParcelsBy { particles, second, step };

struct InjectionSettings {
  // A nozzle, where face_axis < 0.
  Vec3 at = Vec3::Zero();
  double nozzle_radius = 0.0;
  Vec3 direction = Vec3::UnitX();  // of length 1
  double half_angle = 0.0;         // [rad]
  // A face.
  int face_axis = -1;
  bool face_high = false;
  std::optional<std::array<double, 4>> rectangle;  // low, high of the first axis, of the second
  double fraction = 0.0;

  double speed = 0.0;
  double mass_flow = 0.0;  // [kg/s]; of a face: from the box (Injector)
  SizeDistribution size;
  bool liquid = false;
  double density = 0.0;               // of the solid or the liquid [kg/m3]
  std::vector<double> mass_fraction;  // of each species of the scene
  double core_radius = 1e-10;
  double core_density = 2500.0;
  ParcelsBy by = ParcelsBy::particles;
  double number = 0.0;  // particles a parcel, parcels a second or a step
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  int type = 1;
  std::uint64_t seed = 1;

  [[nodiscard]] bool of_face() const { return face_axis >= 0; }
};

// Throws Error with all faults at once. species: names of the scene's liquids; types: of atoms.
InjectionSettings parse_injection(const std::vector<std::string>& words,
                                  const std::vector<std::string>& species, int types);

// What is wrong with a feed among these parcels, with its remedy; empty when it can be.
std::string feed_fault(const ParcelSettings& parcels, const InjectionSettings& injection);

}  // namespace gasgrain
