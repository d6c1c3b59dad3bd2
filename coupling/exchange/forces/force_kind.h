// When a force is evaluated, and by which function of its struct.
#pragma once

#include <cstdint>

namespace gasgrain {

enum class ForceKind : std::uint8_t {
  // Of the gas alone; holds for a coupling interval.
  //   static Vec3 force(const GasProperties&, const GasAtParticle&, double radius)     [N]
  steady,
  // Of the particle's present motion; evaluated at every DEM step.
  //   Vec3 force(const GasProperties&, const GasAtParticle&, const GrainState&) const  [N]
  motion,
  // As motion, but a torque about the particle's centre.
  //   Vec3 torque(const GasProperties&, const GasAtParticle&, const GrainState&) const [N m]
  torque,
  // Of the particle's acceleration a: m_a (Du/Dt - a), implicit in a.
  //   static double added_mass(const GasProperties&, double radius)                    [kg]
  added_mass,
  // As added_mass, and of the past accelerations: both through an object of its type Memory, which
  // knows the step, and a state of plain doubles a particle (basset_kernel.h).
  history,
};

}  // namespace gasgrain
