#include "tools/advise_numerics.h"

#include <algorithm>
#include <cmath>

#include "coupling/base/error.h"
#include "coupling/exchange/void_fraction/choose_method.h"
#include "coupling/exchange/void_fraction/read_method.h"
#include "fix_cfd_coupling/dem_physics/contact_time.h"

namespace gasgrain {
namespace {

NumberRow row_of(Dial dial, const char* name) {
  NumberRow row;
  row.dial = dial;
  row.name = name;
  return row;
}

// To two digits, down or up: as it would be written into a script.
double two_digits(double value, bool up) {
  if (value <= 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  const double count = value / unit;
  constexpr double round_off = 1e-9;
  return (up ? std::ceil(count - round_off) : std::floor(count + round_off)) * unit;
}

std::string within(double value, double low, double high) {
  return value >= low && value <= high ? "agrees" : "disagrees";
}

class NumberAdvice {
 public:
  NumberAdvice(const AdviseScene& scene, const Places& places, const NumericsWish& wish)
      : scene_(scene),
        contacts_(scene.contacts),
        places_(places),
        wish_(wish),
        diameter_(scene.grains.largest),
        speed_(wish.speed > 0.0 ? wish.speed : places.fastest) {}

  std::vector<NumberRow> all() {
    if (scene_.moves && !contacts_.normal.empty() && contacts_.youngs > 0.0 && speed_ > 0.0) {
      speed();
      stiffness();
      dem_step();
    }
    cell();
    method();
    interval();
    gas_step();
    sharing();
    return rows_;
  }

 private:
  [[nodiscard]] double pair_mass(double diameter) const {
    return 0.5 * scene_.grains.density * sphere_volume(0.5 * diameter);
  }
  [[nodiscard]] bool linear() const { return contacts_.normal.rfind("hooke", 0) == 0; }
  // k of a pair of two such grains: N/m^(3/2) of Hertz, N/m of the linear contact.
  [[nodiscard]] double stiffness_of(double youngs, double diameter) const {
    const double modulus =
        contact::effective_modulus(youngs, contacts_.poisson, youngs, contacts_.poisson);
    const double radius = 0.25 * diameter;
    if (!linear()) return contact::hertz_stiffness(modulus, radius);
    const double characteristic =
        contacts_.characteristic_velocity > 0.0 ? contacts_.characteristic_velocity : speed_;
    return contact::hooke_stiffness(modulus, radius, pair_mass(diameter), characteristic);
  }
  [[nodiscard]] double overlap(double youngs) const {
    const double k = stiffness_of(youngs, diameter_);
    const double mass = pair_mass(diameter_);
    return linear() ? contact::linear_greatest_overlap(k, mass, speed_)
                    : contact::hertz_greatest_overlap(k, mass, speed_);
  }
  // Greatest force over greatest overlap [N/m].
  [[nodiscard]] double spring(double youngs) const {
    const double k = stiffness_of(youngs, diameter_);
    return linear() ? k : k * std::sqrt(overlap(youngs));
  }
  [[nodiscard]] double contact_time(double youngs) const {
    const double d = scene_.grains.smallest;
    const double k = stiffness_of(youngs, d);
    return linear() ? contact::linear_duration(k, pair_mass(d), contacts_.restitution)
                    : contact::hertz_duration(k, pair_mass(d), speed_, contacts_.restitution);
  }

  void speed() {
    NumberRow row = row_of(Dial::none, "fastest grain");
    row.advised = fmt::format("{:.2g} m/s", speed_);
    row.reason = wish_.speed > 0.0
                     ? "as given by --speed"
                     : places_.fastest_reason + "; --speed V where it is known better";
    row.thesis = "below 10 m/s in fluidised beds (8.1.5.1)";
    row.verdict = within(speed_, 0.0, 10.0);
    rows_.push_back(row);
  }

  // Overlap goes as E^-0.4 of Hertz, and as E^-0.4 of the linear contact made from it.
  void stiffness() {
    const double now = overlap(contacts_.youngs) / diameter_;
    const double exact = contacts_.youngs * std::pow(now / wish_.overlap, 2.5);
    youngs_ = two_digits(exact, true);
    NumberRow row = row_of(Dial::youngs, "Young's modulus");
    row.now = fmt::format("{:.2g} Pa: {:.2g} % of d, {:.2g} N/m", contacts_.youngs, 100.0 * now,
                          spring(contacts_.youngs));
    row.advised = fmt::format("{:.2g} Pa: {:.2g} N/m", youngs_, spring(youngs_));
    row.reason = fmt::format("overlap of at most {:g} % of a diameter at {:.2g} m/s",
                             100.0 * wish_.overlap, speed_);
    row.thesis = "5e4 to 5e6 N/m (8.1.5.1)";
    row.verdict = within(spring(youngs_), 5e4, 5e6);
    if (row.verdict == "disagrees") {
      const double by_its_own =
          2.0 * pair_mass(diameter_) * speed_ * speed_ / (0.25 * diameter_ * diameter_);
      row.verdict += fmt::format(
          ": its eq 7.20, overlap of a radius without damping, gives {:.2g} N/m here, and its "
          "table 8.3 does not follow from it",
          by_its_own);
    }
    row.value = youngs_;
    constexpr double near = 2.0;  // a fifth of the overlap more or less
    row.change = exact > 1.1 * contacts_.youngs || exact * near < contacts_.youngs;
    if (!row.change) youngs_ = contacts_.youngs;
    rows_.push_back(row);
  }

  void dem_step() {
    const double time = contact_time(youngs_);
    const double step = two_digits(time / steps_a_contact, false);
    NumberRow row = row_of(Dial::dem_step, "DEM step");
    row.now = fmt::format("{:g} s: {:.2g} a contact", scene_.dt,
                          contact_time(contacts_.youngs) / scene_.dt);
    row.advised = fmt::format("{:g} s", step);
    row.reason = fmt::format(
        "a contact at {:.2g} m/s lasts {:.2g} s with this stiffness; {:g} "
        "steps in it",
        speed_, time, steps_a_contact);
    row.thesis = "eq 7.17, 1 / omega: 3 steps a contact";
    row.verdict = "disagrees: of its own force law that is a third of a contact";
    row.value = step;
    constexpr double near = 0.75;  // not worth a change: 15 steps
    row.change = step < near * scene_.dt || step > 1.5 * scene_.dt;
    rows_.push_back(row);
  }

  void cell() {
    const Vec3 h = scene_.gas.grid.spacing();
    const double least = h.minCoeff() / diameter_;
    const double most = h.maxCoeff() / diameter_;
    const Vec3 size = scene_.gas.grid.hi - scene_.gas.grid.lo;
    NumberRow row = row_of(Dial::none, "fluid cell");
    row.now = fmt::format("{:.2g} to {:.2g} d", least, most);
    row.advised = row.now;
    row.reason =
        "between d / 5, finer than which no method was measured, and what resolves the flow";
    std::vector<std::string> faults;
    if (least < 1.0 / most_cells_across) {
      faults.push_back("finer than d / 5: coarser cells would do");
      row.advised = fmt::format("{:.2g} m or more", diameter_ / most_cells_across);
    }
    if (places_.nozzle_width > 0.0 && h.maxCoeff() > places_.nozzle_width)
      faults.push_back(
          fmt::format("wider than the nozzle of {:.2g} m, whose jet then starts as wide as a cell",
                      places_.nozzle_width));
    // Between walls; a periodic slice is as thin as its scene wants it.
    constexpr double cells_across = 3.0;
    for (int d = 0; d < 3; ++d)
      if (scene_.gas.grid.cells[d] > 1 && !scene_.gas.grid.periodic[d] &&
          h[d] * cells_across > size[d] * (1.0 + 1e-9))
        faults.push_back(fmt::format("less than 3 cells along {}", "xyz"[d]));
    for (const auto& fault : faults) row.reason += "; " + fault;
    const double block = std::pow(2.5 * diameter_, 3) / scene_.gas.grid.cell_volume();
    row.thesis = fmt::format(
        "2 to 3 d, or 4 to 10 fluid cells in a particle cell of 2 to 3 d (8.1.3); here {:.2g} in "
        "one "
        "of 2.5 d",
        block);
    row.verdict =
        (least >= 2.0 && most <= 3.0) || (block >= 4.0 && block <= 10.0) ? "agrees" : "disagrees";
    if (row.verdict == "disagrees")
      row.verdict +=
          ": the kernel's void fraction is the same from 0.2 d to 3 d "
          "(docs/exchange.md), so that the flow decides";
    row.change = !faults.empty();
    rows_.push_back(row);
  }

  void method() {
    const Effects& effects = scene_.couple.effects;
    const MethodChoice choice =
        choose_method(0.5 * scene_.grains.smallest, 0.5 * diameter_, scene_.gas.grid);
    NumberRow row = row_of(Dial::method, "void fraction");
    row.now = NamedMethod{effects.method, effects.choose_method}.text();
    row.advised = NamedMethod{choice.method, false}.text();
    row.reason = choice.reason.substr(choice.reason.find(": ") + 2) +
                 ". It has the least spread of eps in a packing";
    row.thesis = "offset, on a particle grid of 2 to 3 d where cells are finer (8.1.2, 8.1.3)";
    row.verdict =
        "disagrees: offset is nearer to the exact share of a cell, but keeps the packing's own "
        "spread, which drag laws do not want (docs/exchange.md)";
    row.change = !effects.choose_method && row.now != row.advised;
    rows_.push_back(row);
  }

  void interval() {
    const double h = scene_.gas.grid.spacing().minCoeff();
    const double speed = places_.bed_speed > 0.0 ? places_.bed_speed : speed_;
    double longest = speed > 0.0 ? 0.5 * h / speed : scene_.interval();
    std::string reason =
        speed > 0.0
            ? fmt::format("a grain at {:.2g} m/s crosses half a cell in {:.2g} s", speed, longest)
            : std::string("grains do not move");
    // In a bed that is hardly denser than the fluid, the time in which a grain follows the flow.
    const Scales& bed = places_.list.front().scales;
    constexpr double light = 5.0;  // times the fluid's density
    if (bed.solid_density < light * bed.gas_density && bed.drag > 0.0) {
      const double follows = 0.2 * bed.mass() * bed.slip / bed.drag;
      if (follows < longest)
        reason =
            fmt::format("well below the {:.2g} s in which a grain follows the flow", 5.0 * follows);
      longest = std::min(longest, follows);
    }
    const double advised = two_digits(std::max(longest, scene_.dt), false);
    interval_ = scene_.interval();
    NumberRow row = row_of(Dial::interval, "coupling interval");
    row.now = fmt::format("{:.2g} s", scene_.interval());
    row.advised = fmt::format("{:.2g} s", advised);
    row.reason = reason;
    row.thesis = "the fluid step, 1 to 5 ms (8.1.5.2)";
    row.value = advised;
    constexpr double slack = 1.25;
    row.change =
        speed > 0.0 && (scene_.interval() > slack * longest || scene_.interval() * 4.0 < longest);
    if (row.change) interval_ = advised;
    row.verdict = within(interval_, 1e-3, 5e-3);
    if (row.verdict == "disagrees") row.verdict += ": it goes with cell and speed, not with a time";
    rows_.push_back(row);
  }

  void gas_step() {
    NumberRow row = row_of(Dial::gas_step, "fluid step");
    row.now = fmt::format("{:.2g} s, Courant {:g}", scene_.gas.step, scene_.gas.courant_max);
    row.advised = fmt::format("{:.2g} s", interval_);
    row.reason =
        "the coupling interval: the gas cuts it by its Courant number, and a longer one is "
        "never used";
    const double u = places_.list.back().scales.gas_speed;
    if (u > 0.0)
      row.reason += fmt::format("; Courant number {:.2g} at {:.2g} m/s",
                                u * interval_ / scene_.gas.grid.spacing().minCoeff(), u);
    row.thesis = "1 to 5 ms (8.1.5.2)";
    row.verdict = within(interval_, 1e-3, 5e-3);
    row.value = interval_;
    row.change = scene_.gas.step < 0.99 * interval_ && scene_.gas.step > 0.0 &&
                 scene_.gas.step * 4.0 < interval_;
    rows_.push_back(row);
  }

  void sharing() {
    NumberRow row = row_of(Dial::none, "momentum sharing");
    row.now = std::string(name_of(scene_.couple.effects.sharing));
    row.advised = std::string(SharingScheme3::name);
    row.reason = "alone obeys the third law with each grain's own velocity";
    row.thesis = "the third of Feng and Yu's schemes (7.2)";
    row.verdict = "agrees";
    rows_.push_back(row);
  }

  const AdviseScene& scene_;
  const Contacts& contacts_;
  const Places& places_;
  const NumericsWish& wish_;
  double diameter_;
  double speed_;
  double youngs_ = 0.0;
  double interval_ = 0.0;
  std::vector<NumberRow> rows_;
};

}  // namespace

std::vector<NumberRow> number_rows(const AdviseScene& scene, const Places& places,
                                   const NumericsWish& wish) {
  return NumberAdvice(scene, places, wish).all();
}

}  // namespace gasgrain
