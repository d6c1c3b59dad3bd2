#include "tools/advise_places.h"

#include <algorithm>
#include <cmath>

#include "coupling/exchange/particle_weights.h"
#include "coupling/exchange/void_fraction/choose_method.h"

namespace gasgrain {
namespace {

constexpr double packed_void_fraction = 0.42;  // of spheres, loosely
constexpr double jet_void_fraction = 0.95;

double section_of(const BoxGrid& grid, int side) {
  const Vec3 size = grid.hi - grid.lo;
  return size.prod() / size[side / 2];
}

// The standard deviation of a grain's weights in the middle of the box, the grid's share included.
double bell_of(const AdviseScene& scene) {
  TileFrame frame{scene.gas.grid, scene.gas.grid.all()};
  const double radius = 0.5 * scene.grains.largest;
  const VoidFractionMethod method = method_of(scene);
  const Int3 reach = stencil_reach(method, radius, frame.grid);
  for (int d = 0; d < 3; ++d)
    if (frame.grid.periodic[d]) {
      frame.tile.lo[d] -= reach[d] + 1;
      frame.tile.hi[d] += reach[d] + 1;
    }
  const Vec3 middle = 0.5 * (frame.grid.lo + frame.grid.hi);
  const Vec3 rest = Vec3::Zero();
  ParticleView one;
  one.count = 1;
  one.position = middle.data();
  one.velocity = rest.data();
  one.radius = &radius;
  ParticleWeights weights;
  weights.find(one, method, frame);
  const Footprint footprint = weights.footprint(0);
  const Vec3 h2 = footprint.h.cwiseProduct(footprint.h);
  return std::sqrt((footprint.variance + h2 / 32.0 + h2 / 12.0).sum() / 3.0);
}

class PlaceFinder {
 public:
  explicit PlaceFinder(const AdviseScene& scene)
      : scene_(scene),
        gas_{gas_density(scene.gas), scene.gas.viscosity, scene.gas.model == GasModel::b},
        law_(scene.couple.effects.drag.value_or(DragErgunWenYu{})) {}

  Places find() {
    set_common();
    find_flow();
    find_bed();
    if (places_.nozzle_speed > 0.0) find_jet();
    find_fastest();
    // What the fastest grains do counts in the jet, or where there is nothing else.
    for (Place& place : places_.list) {
      const bool in_jet = &place != &places_.list.front();
      const double speed = in_jet ? places_.fastest : places_.bed_speed;
      place.scales.speed = speed;
      place.scales.spin = scene_.rotates ? speed / place.scales.diameter : 0.0;
      place.scales.speed_scatter = speed;
    }
    return places_;
  }

 private:
  // Drag at the scales' void fraction and slip [N].
  [[nodiscard]] double drag(const Scales& at) const {
    return std::visit(
        [&](const auto& law) {
          using Law = std::decay_t<decltype(law)>;
          return Law::coefficient(gas_, std::max(at.void_fraction, least_drag_void_fraction),
                                  at.slip, at.diameter) *
                 at.slip;
        },
        law_);
  }
  // The slip at which the gas carries a grain: drag and pressure gradient, drag / eps.
  [[nodiscard]] double carrying_slip(Scales at) const {
    const double load = at.weight() - at.gas_density * at.volume() * at.gravity;
    if (load <= 0.0) return 0.0;
    double low = 0.0;
    double high = 1e-6;
    const auto carries = [&](double slip) {
      at.slip = slip;
      return drag(at) / at.void_fraction >= load;
    };
    constexpr double fastest_gas = 1e5;  // [m/s]
    while (high < fastest_gas && !carries(high)) high *= 2.0;
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high);
      (carries(middle) ? high : low) = middle;
    }
    return high;
  }

  void set_common() {
    const Vec3 size = scene_.gas.grid.hi - scene_.gas.grid.lo;
    common_.diameter = scene_.grains.largest;
    common_.smallest_diameter = scene_.grains.smallest;
    common_.sauter_diameter = scene_.grains.sauter;
    common_.solid_density = scene_.grains.density;
    common_.gravity = scene_.gravity;
    common_.friction = scene_.contacts.friction;
    common_.gas_density = gas_.density;
    common_.viscosity = gas_.viscosity;
    common_.gas_pressure = scene_.gas.reference_pressure;
    common_.cell = std::cbrt(scene_.gas.grid.cell_volume());
    common_.interval = scene_.interval();
    common_.depth = scene_.gas.grid.cells[1] == 1 ? size[1] : 0.0;
    common_.smagorinsky_constant = scene_.gas.turbulence.smagorinsky_constant;
    common_.bell = bell_of(scene_);
    const double section = size[0] * size[1];
    common_.bed_height = std::min(
        scene_.grains.count * common_.volume() / ((1.0 - packed_void_fraction) * section), size[2]);
    places_.bed_height = common_.bed_height;
    if (const auto* lorentz = lorentz_of(scene_.couple.effects)) {
      common_.charge = std::abs(lorentz->charge);
      common_.electric = lorentz->electric.norm();
      common_.magnetic = lorentz->magnetic.norm();
    }
  }
  static const ForceLorentz* lorentz_of(const Effects& effects) {
    for (const Force& force : effects.forces)
      if (const auto* found = std::get_if<ForceLorentz>(&force)) return found;
    return nullptr;
  }

  void find_flow() {
    for (const InflowPatch& patch : scene_.gas.inflows) {
      const double speed = patch.full_velocity(gas_.density);
      const double area = patch.outline.area();
      const double section = section_of(scene_.gas.grid, patch.side);
      places_.superficial += speed * area / section;
      constexpr double wide = 0.5;  // of the section: no jet but the whole flow
      if (area < wide * section && speed > places_.nozzle_speed) {
        places_.nozzle_speed = speed;
        places_.nozzle_width = std::sqrt(4.0 * area / pi);
      }
    }
  }

  void find_bed() {
    Scales bed = common_;
    const bool blown = places_.superficial > 0.0;
    bed.void_fraction = blown ? packed_void_fraction : 1.0;
    const double carried = carrying_slip(bed);
    if (blown) places_.minimum_fluidisation = carried * bed.void_fraction;
    const bool fluidised = scene_.moves && places_.superficial >= places_.minimum_fluidisation;
    bed.slip = blown && !fluidised ? places_.superficial / bed.void_fraction : carried;
    bed.drag = drag(bed);
    const Vec3 size = scene_.gas.grid.hi - scene_.gas.grid.lo;
    bed.gas_length = std::max({0.5 * size.minCoeff(), bed.cell, 2.5 * bed.diameter});
    bed.pressure_gradient = bed.gas_density * bed.gravity;
    if (blown) bed.pressure_gradient += bed.solids() * bed.drag / bed.void_fraction / bed.volume();
    bed.pressure_drop = blown ? bed.pressure_gradient * bed.bed_height : 0.0;
    bed.grain_acceleration = scene_.moves ? bed.gravity : 0.0;
    add(bed, "bed", bed.slip, bed.gas_length);
    if (scene_.moves && (fluidised || places_.nozzle_speed > 0.0))
      places_.bed_speed = std::sqrt(2.0 * bed.gravity * places_.bed_height);
  }

  void find_jet() {
    constexpr double core = 5.8;  // lengths D over which it keeps its speed; and its decay
    constexpr double spreading = 0.094;
    Scales jet = common_;
    const double D = places_.nozzle_width;
    const double x = std::max(core * D, 0.5 * places_.bed_height);
    jet.void_fraction = jet_void_fraction;
    jet.slip = places_.nozzle_speed * core * D / x;
    jet.drag = drag(jet);
    jet.gas_length = std::max(spreading * x, 0.5 * D);
    jet.pressure_drop = places_.list.front().scales.pressure_drop;
    jet.grain_acceleration = scene_.moves ? ratio(jet.drag, jet.mass()) + jet.gravity : 0.0;
    jet.pressure_gradient = places_.list.front().scales.pressure_gradient;
    add(jet, "jet", jet.slip, x);
  }

  // along: the length over which the gas changes on its own way [m]
  void add(Scales at, const char* name, double u, double along) {
    at.gas_speed = u;
    at.vorticity = u / at.gas_length;
    at.gas_acceleration = u * u / along;
    at.viscous_force = at.viscosity * u / (at.gas_length * at.gas_length);
    at.pressure_gradient = std::max(at.pressure_gradient, at.gas_density * at.gas_acceleration);
    places_.list.push_back({name, at});
  }

  void find_fastest() {
    if (!scene_.moves) {
      places_.fastest_reason = "no integrator moves the grains";
      return;
    }
    const auto take = [&](double speed, const std::string& reason) {
      if (speed <= places_.fastest) return;
      places_.fastest = speed;
      places_.fastest_reason = reason;
    };
    take(places_.bed_speed, "of a grain thrown as high as the bed is deep");
    const double drop = std::max(0.0, scene_.grains.top - places_.bed_height);
    take(std::sqrt(scene_.grains.thrown * scene_.grains.thrown + 2.0 * scene_.gravity * drop),
         "of the fall from where grains are put in");
    if (places_.nozzle_speed > 0.0) {
      Scales nozzle = common_;
      nozzle.void_fraction = jet_void_fraction;
      nozzle.slip = places_.nozzle_speed;
      const double free_path = nozzle.diameter / (6.0 * (1.0 - jet_void_fraction));
      const double a = std::max(0.0, drag(nozzle) / nozzle.mass() - nozzle.gravity);
      take(std::min(places_.nozzle_speed, std::sqrt(2.0 * a * free_path)),
           "of a grain that the nozzle blows over a free path of 3.3 diameters");
    }
  }

  const AdviseScene& scene_;
  GasProperties gas_;
  DragModel law_;
  Scales common_;
  Places places_;
};

}  // namespace

Places places_of(const AdviseScene& scene) {
  return PlaceFinder(scene).find();
}

double gas_density(const GasInput& gas) {
  if (gas.law == GasLaw::constant_density) return gas.density;
  return gas.reference_pressure * gas.molar_mass / (gas_constant * gas.temperature);
}

VoidFractionMethod method_of(const AdviseScene& scene) {
  const Effects& effects = scene.couple.effects;
  const double largest = 0.5 * scene.grains.largest;
  if (!effects.choose_method) return with_diameter(effects.method, scene.grains.largest);
  return with_diameter(choose_method(0.5 * scene.grains.smallest, largest, scene.gas.grid).method,
                       scene.grains.largest);
}

}  // namespace gasgrain
