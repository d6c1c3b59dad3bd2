#include "tools/study/scene_material.h"

#include "coupling/base/error.h"
#include "tools/advise_scene.h"

namespace gasgrain {

GrainMaterial scene_material(const std::filesystem::path& scene) {
  const AdviseScene read = read_scene(scene, {});
  const Contacts& contacts = read.contacts;
  GrainMaterial grain;
  grain.radius = 0.5 * read.grains.largest;
  grain.density = read.grains.density;
  grain.youngs = contacts.youngs;
  grain.poisson = contacts.poisson;
  grain.restitution = contacts.restitution;
  grain.friction = contacts.friction;
  if (contacts.characteristic_velocity > 0.0)
    grain.characteristic_velocity = contacts.characteristic_velocity;
  if (grain.radius <= 0.0 || grain.density <= 0.0 || grain.youngs <= 0.0)
    fail(
        "{}: this study needs the grains' size, density and Young's modulus, for example\n"
        "  fix sphere all particletemplate/sphere SEED atom_type 1 density constant 2500 radius "
        "constant 0.00125\n"
        "  fix youngs all property/global youngsModulus peratomtype 1e7",
        (scene / "in.liggghts").string());
  return grain;
}

}  // namespace gasgrain
