// One grain that hits a wall and comes back, computed by the DEM program with the scene's own
// contact model: what stiffness and DEM step do to a single collision, against its analytic
// solution.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/study/study_point.h"

namespace gasgrain {

// Of grains and walls alike, as the scene has them.
struct GrainMaterial {
  double radius = 0.0;                   // m
  double density = 0.0;                  // kg/m3
  double youngs = 0.0;                   // Pa
  double poisson = 0.0;                  // 1
  double restitution = 0.0;              // 1
  double friction = 0.0;                 // 1
  double characteristic_velocity = 1.0;  // m/s, of `hooke`

  [[nodiscard]] double mass() const;  // kg
};

// The spring [N/m] that stores as much energy as the grain-grain contact of these moduli at
// `speed` [m/s]: LIGGGHTS's hooke with that characteristic velocity. A Hertzian contact has no
// stiffness of its own; this is what linear ones are compared with.
double linear_stiffness(const GrainMaterial& material, double speed);

// Duration [s] of a head-on collision of two grains at `speed` (dem_physics/contact_time.h).
// `contact`: the words after `model`; nothing when its first is neither hertz nor hooke.
std::optional<double> contact_duration(const GrainMaterial& material, const std::string& contact,
                                       double speed);

// Greatest errors over starts at eight phases of a DEM step.
struct BounceErrors {
  double restitution = 0.0;     // |e - e_exact| / e_exact
  double contact_time = 0.0;    // |t - t_exact| / t_exact
  double energy = 0.0;          // |E_after - E_before| / E_before of the same grain without damping
  double contact_time_s = 0.0;  // computed, mean
};

// Grains hit a wall at `speed` [m/s] with DEM step `step` [s]. Works in `folder`, which is made.
// Nothing for contact models without an analytic solution here. Throws Error when the DEM program
// fails, with its own words.
std::optional<BounceErrors> measure_bounce(const GrainMaterial& material,
                                           const std::string& contact, double step, double speed,
                                           const std::filesystem::path& folder);

// The speed [m/s] of the bounces of a study, and of its linear stiffness.
constexpr double study_impact_speed = 1.0;

// Adds restitution_error, contact_time_error, energy_drift and contact_time_s [s] of such a bounce;
// nothing where there is no analytic solution.
void add_bounce_figures(const GrainMaterial& material, const std::string& contact, double step,
                        const std::filesystem::path& folder, Figures& figures);

}  // namespace gasgrain
