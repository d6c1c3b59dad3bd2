// Grains and gas coupled in one process and without a host, for the hard cases: the product's
// coupled step, exchange and gas solver; grains that no contact touches, moved by
//   v += dt F / m,  x += dt v.
#pragma once

#include <memory>

#include "coupling/coupled_step.h"
#include "gas_solver/coupling_port.h"
#include "tests/exchange_cloud.h"
#include "tests/gas_cases.h"

namespace gasgrain::stability {

using gas_cases::self;

inline constexpr Sides all_periodic{&periodic_side, &periodic_side, &periodic_side,
                                    &periodic_side, &periodic_side, &periodic_side};

// Does the gas's work when the particles' side has sent what it needs.
class GasInProcess : public GasPartner {
 public:
  explicit GasInProcess(const GasInput& input) : solver_(input, self()), port_(solver_, input, "") {
    MPI_Comm_dup(MPI_COMM_SELF, &channel_);
  }
  ~GasInProcess() override { MPI_Comm_free(&channel_); }
  GasInProcess(const GasInProcess&) = delete;
  GasInProcess& operator=(const GasInProcess&) = delete;

  GasHello greet(const DemHello& mine) override {
    port_.meet(mine);
    return port_.hello();
  }
  void send_command(const Command& command) override {
    if (command.kind == CommandKind::couple) port_.begin(command);
  }
  RouteTransport connect(const BoxGrid& grid, const IndexBox& tile) override {
    port_.route({tile}, channel_, Sends::started);
    return {channel_, make_routes(grid, tile, {solver_.own()}, false), false, Sends::started};
  }
  void solids_are_sent() override { port_.take_solids(); }
  void drag_is_sent() override { report_ = port_.report_of(port_.advance()); }
  Report receive_report() override {
    port_.finish_sends();
    return report_;
  }
  std::string finish() override { return {}; }
  [[nodiscard]] GasSolver& solver() { return solver_; }

 private:
  GasSolver solver_;
  CouplingPort port_;
  Report report_;
  MPI_Comm channel_ = MPI_COMM_NULL;  // so that messages of one bed do not meet those of another
};

inline std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

struct Pace {
  double interval = 1e-4;  // from one coupling to the next [s]
  int steps = 1;           // of the grains in it
  bool overlapped = false;
};

class CoupledBed {
 public:
  // `effects`: as on the couple/gas line.
  CoupledBed(const GasInput& input, const std::string& effects, const Pace& pace, Cloud grains)
      : cloud(std::move(grains)),
        pace_(pace),
        effects_(parse_effects(words_of(effects), "test")),
        input_(input),
        partner_(new GasInProcess(input)),
        coupled_(self(), std::unique_ptr<GasPartner>(partner_), effects_, scene()),
        records_(effects_.layout(pace.overlapped)) {
    records_.resize(cloud.radius.size());
  }
  // Takes an answer that is still on its way, unless the bed has failed.
  ~CoupledBed() {
    try {
      if (!advancing_) coupled_.complete(cloud.view(), records_);
    } catch (const Error&) {
    }
  }
  CoupledBed(const CoupledBed&) = delete;
  CoupledBed& operator=(const CoupledBed&) = delete;

  // To be changed between couplings as a test likes; neither of grains that come and go.
  Cloud cloud;
  Vec3 weight = Vec3::Zero();  // acceleration of the grains [m/s2]
  bool held = false;           // the grains feel their forces but keep their velocities

  // A coupling and the grains' steps until the next one.
  void advance() {
    advancing_ = true;
    wrap();
    DemRegion region;
    region.lo = coupled_.grid().lo;
    region.hi = coupled_.grid().hi;
    for (const double r : cloud.radius) region.largest_radius = std::max(region.largest_radius, r);
    coupled_.begin(cloud.view(), region, records_, pace_.interval, coupling_,
                   static_cast<double>(coupling_) * pace_.interval);
    ++coupling_;
    const double dt = pace_.interval / pace_.steps;
    for (int step = 0; step < pace_.steps; ++step) take_step(dt);
    advancing_ = false;
  }

  [[nodiscard]] const Report& report() const { return coupled_.report(); }
  [[nodiscard]] const GasSolver& gas() const { return partner_->solver(); }
  [[nodiscard]] const ExchangeRecords& records() const { return records_; }
  CoupledStep::Clamps take_clamps() { return coupled_.take_clamps(); }
  // The forces of the gas in the last step [N], three a grain.
  [[nodiscard]] const std::vector<double>& forces() const { return force_; }

  [[nodiscard]] Ledger ledger() {
    coupled_.complete(cloud.view(), records_);
    return coupled_.whole_ledger(cloud.view(), records_);
  }
  [[nodiscard]] Vec3 grain_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t p = 0; p < cloud.radius.size(); ++p) sum += cloud.mass[p] * cloud.view().v(p);
    return sum;
  }
  [[nodiscard]] double grain_energy() const {
    double sum = 0;
    for (std::size_t p = 0; p < cloud.radius.size(); ++p)
      sum += 0.5 * cloud.mass[p] * cloud.view().v(p).squaredNorm();
    return sum;
  }
  [[nodiscard]] double fastest_grain() const {
    double speed = 0;
    for (std::size_t p = 0; p < cloud.radius.size(); ++p)
      speed = std::max(speed, cloud.view().v(p).norm());
    return speed;
  }

 private:
  void take_step(double dt) {
    const std::size_t count = cloud.radius.size();
    force_.assign(3 * count, 0.0);
    for (std::size_t p = 0; p < count; ++p)
      for (int d = 0; d < 3; ++d) force_[3 * p + d] = cloud.mass[p] * weight[d];
    torque_.assign(3 * count, 0.0);
    coupled_.apply(cloud.view(), records_, {force_.data(), torque_.data()}, dt, 1.0);
    for (std::size_t n = 0; n < 3 * count; ++n) {
      if (!held) cloud.velocity[n] += dt * force_[n] / cloud.mass[n / 3];
      cloud.position[n] += dt * cloud.velocity[n];
      force_[n] -= cloud.mass[n / 3] * weight[n % 3];
    }
  }
  void wrap() {
    const BoxGrid& grid = coupled_.grid();
    for (std::size_t n = 0; n < cloud.position.size(); ++n) {
      const int d = static_cast<int>(n % 3);
      const double length = grid.hi[d] - grid.lo[d];
      if (grid.periodic[d])
        cloud.position[n] -= length * std::floor((cloud.position[n] - grid.lo[d]) / length);
    }
  }
  [[nodiscard]] DemScene scene() const {
    DemScene scene;
    scene.box_lo = input_.grid.lo;
    scene.box_hi = input_.grid.hi;
    for (int d = 0; d < 3; ++d) scene.periodic[d] = input_.sides[2 * d] == &periodic_side ? 1 : 0;
    scene.interval = pace_.interval;
    scene.overlapped = pace_.overlapped;
    return scene;
  }

  Pace pace_;
  Effects effects_;
  GasInput input_;
  GasInProcess* partner_;
  CoupledStep coupled_;
  ExchangeRecords records_;
  long coupling_ = 0;
  bool advancing_ = false;
  std::vector<double> force_, torque_;
};

// Of the gas in the cells: sum of rho eps u V over the faces [kg m/s], at constant density.
inline Vec3 gas_momentum(const GasSolver& gas, double density) {
  Vec3 sum = Vec3::Zero();
  const Array3<double> eps = gas.void_fraction();
  const CellVector u = gas.cell_velocity();
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    for (int d = 0; d < 3; ++d)
      sum[d] += density * gas.grid().cell_volume() * eps(i, j, k) * u[d](i, j, k);
  });
  return sum;
}

inline double least_void_fraction(const GasSolver& gas) {
  const Array3<double> eps = gas.void_fraction();
  return *std::min_element(eps.begin(), eps.end());
}

// Equal grains at the centres of n x n x n cubes that fill the box.
inline Cloud lattice(const BoxGrid& grid, int n, double radius, double density, const Vec3& v) {
  Cloud cloud;
  const Vec3 h = (grid.hi - grid.lo) / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        cloud.add(grid.lo + h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5)), v, radius,
                  density * sphere_volume(radius));
  return cloud;
}

}  // namespace gasgrain::stability
