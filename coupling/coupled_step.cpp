#include "coupling/coupled_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "coupling/base/error.h"
#include "coupling/exchange/void_fraction/choose_method.h"
#include "coupling/run_watch.h"

namespace gasgrain {
namespace {

GasHello meet(GasPartner& partner, const Effects& effects, const DemScene& scene) {
  DemHello hello;
  put_text(hello.version, GASGRAIN_VERSION);
  for (int d = 0; d < 3; ++d) {
    hello.box_lo[d] = scene.box_lo[d];
    hello.box_hi[d] = scene.box_hi[d];
  }
  hello.periodic = scene.periodic;
  hello.interval = scene.interval;
  hello.time = scene.time;
  hello.lent = effects.lent().bits();
  hello.taken = effects.taken().bits();
  const GasHello gas = partner.greet(hello);
  const std::string faults = pairing_faults(hello, gas);
  if (!faults.empty()) throw Error(faults);
  return gas;
}

BoxGrid grid_of(const GasHello& gas) {
  BoxGrid grid;
  for (int d = 0; d < 3; ++d) {
    grid.lo[d] = gas.grid_lo[d];
    grid.hi[d] = gas.grid_hi[d];
    grid.periodic[d] = gas.periodic[d] != 0;
  }
  grid.cells = gas.cells;
  return grid;
}

}  // namespace

CoupledStep::CoupledStep(const Communicator& local, std::unique_ptr<GasPartner> partner,
                         const Effects& effects, const DemScene& scene)
    : local_(local),
      partner_(std::move(partner)),
      effects_(effects),
      overlapped_(scene.overlapped),
      gas_(meet(*partner_, effects, scene)),
      properties_{gas_.density, gas_.viscosity, gas_.whole_pressure_gradient != 0},
      frame_{grid_of(gas_), {}},
      forces_(effects, properties_),
      ledger_(effects),
      cost_deposit_(costs_.task("coupling: void fraction")),
      cost_transport_(costs_.task("coupling: transport")),
      cost_wait_(costs_.task("coupling: waiting for the gas")),
      cost_sample_(costs_.task("coupling: sampling")),
      cost_look_(costs_.task("coupling: looking for faults")) {
  make_tasks();
}

// What is off has none.
void CoupledStep::make_tasks() {
  if (effects_.drag) cost_drag_ = costs_.task("coupling: drag law");
  if (effects_.any_reacts()) cost_charge_ = costs_.task("coupling: drag of the gas");
  for (const std::string& name : effects_.names())
    cost_forces_.push_back(costs_.task("coupling: force " + name));
  cost_forces_.push_back(costs_.task("coupling: forces, every step"));
}

// At the first coupling that has particles. What grains come later, greater ones too, finds the
// method and its diameter as they are.
void CoupledStep::settle_method(const ParticleView& particles, const DemRegion& region) {
  if (method_settled_ || region.largest_radius <= 0.0) return;
  method_settled_ = true;
  if (effects_.choose_method) {
    double smallest = region.largest_radius;
    for (std::size_t p = 0; p < particles.count; ++p)
      smallest = std::min(smallest, particles.radius[p]);
    const MethodChoice choice =
        choose_method(local_.min(smallest), region.largest_radius, frame_.grid);
    effects_.method = choice.method;
    if (local_.is_root()) fmt::print("{}\n", choice.reason);
  }
  effects_.method = with_diameter(effects_.method, 2.0 * region.largest_radius);
}

IndexBox CoupledStep::tile_of(const DemRegion& region) const {
  const BoxGrid& grid = frame_.grid;
  Int3 reach = stencil_reach(effects_.method, region.largest_radius, grid);
  // Overlapped, particles are met again where they were an interval ago.
  if (overlapped_)
    for (int& cells : reach) ++cells;
  IndexBox tile;
  for (int d = 0; d < 3; ++d) {
    tile.lo[d] = grid.cell_of(region.lo[d] - region.drift, d) - reach[d];
    tile.hi[d] = grid.cell_of(region.hi[d] + region.drift, d) + 1 + reach[d];
    if (grid.periodic[d]) continue;
    tile.lo[d] = std::clamp(tile.lo[d], 0, grid.cells[d] - 1);
    tile.hi[d] = std::clamp(tile.hi[d], tile.lo[d] + 1, grid.cells[d]);
  }
  return tile;
}

void CoupledStep::make_tile(const IndexBox& tile) {
  frame_.tile = tile;
  fields_ = FieldStore(effects_.lent().united(effects_.taken()), tile);
  bytes_ += transport_.take_bytes();
  transport_.finish_sends();
  transport_ = partner_->connect(frame_.grid, tile);
}

// Carry that left with removed particles: what was taken and expected on all ranks less what the
// particles that are still there know of. (Particles that changed ranks cancel in the sum of
// ranks.)
void CoupledStep::settle(const ParticleView& particles, const ExchangeRecords& records) {
  const Vec3 outstanding = outstanding_carry(particles, records);
  ledger_.add_left(forces_.applied().reacting - expected_in_interval_ - outstanding);
  ledger_.add_taken(forces_.applied());
  forces_.clear();
  expected_in_interval_ = -outstanding;
}

void CoupledStep::begin(const ParticleView& particles, const DemRegion& region,
                        ExchangeRecords& records, double interval, long step, double time) {
  complete(particles, records);
  settle(particles, records);
  settle_method(particles, region);
  const IndexBox tile = tile_of(region);
  const bool fresh = local_.max(tile != frame_.tile || !met_before_ ? 1.0 : 0.0) > 0.0;
  met_before_ = true;

  Command command;
  command.kind = CommandKind::couple;
  command.fresh = fresh ? 1 : 0;
  command.step = step;
  command.time = time;
  command.interval = interval_ = interval;
  partner_->send_command(command);
  if (fresh) make_tile(tile);
  deposit(particles);
  exchange_solids(fresh);
  charge_gas(particles, records);
  look_at_interval(particles, records);
  answer_to_come_ = true;
  {
    const Stopwatch watch(costs_, cost_wait_);
    partner_->drag_is_sent();
  }
  if (!overlapped_) {
    receive_answer();
  } else {
    for (std::size_t p = 0; p < particles.count; ++p) {
      records.at(p, records.layout().position) = particles.x(p);
      records.at(p, records.layout().velocity) = particles.v(p);
    }
  }
  const Stopwatch watch(costs_, cost_sample_);
  std::vector<double> seconds;
  ledger_.add_work(set_gas_at_particles(particles, weights_, effects_, properties_, fields_,
                                        interval_, records, &seconds));
  for (std::size_t n = 0; n < seconds.size(); ++n) {
    costs_.charge(cost_forces_[n], seconds[n]);
    costs_.charge(cost_sample_, -seconds[n]);
  }
  if (overlapped_) return;
  book_expected(particles, effects_, interval_, records);
  expected_in_interval_ = -outstanding_carry(particles, records);
}

void CoupledStep::deposit(const ParticleView& particles) {
  const Stopwatch watch(costs_, cost_deposit_);
  weights_.find(particles, effects_.method, frame_);
  clamps_.beyond_walls += static_cast<long>(weights_.beyond_walls());
  for (Array3<double>* field : fields_.components(effects_.taken())) field->fill(0.0);
  deposit_solids(particles, weights_, effects_, fields_);
}

// Where the tile is new the gas lends what it last had.
void CoupledStep::exchange_solids(bool fresh) {
  {
    const Stopwatch watch(costs_, cost_transport_);
    transport_.send(fields_.components(effects_.taken().common(taken_early)), solids_tag);
  }
  {
    const Stopwatch watch(costs_, cost_wait_);
    partner_->solids_are_sent();
  }
  const Stopwatch watch(costs_, cost_transport_);
  const FieldSet lent = effects_.lent();
  const FieldList back = fields_.components(fresh ? lent : lent.common(lent_early));
  if (!back.empty()) transport_.receive(back, lent_tag);
}

void CoupledStep::charge_gas(const ParticleView& particles, ExchangeRecords& records) {
  if (!effects_.any_reacts()) return;
  if (effects_.drag) {
    const Stopwatch watch(costs_, cost_drag_);
    const DragRefresh met =
        refresh_drag(particles, weights_, effects_, properties_, fields_, records);
    clamps_.too_dense += static_cast<long>(met.too_dense);
    clamps_.disturbance_cut += static_cast<long>(met.disturbance_cut);
  }
  {
    const Stopwatch watch(costs_, cost_charge_);
    deposit_drag(particles, weights_, effects_, frame_.grid.cell_volume(), interval_, fields_,
                 records);
  }
  const Stopwatch watch(costs_, cost_transport_);
  transport_.send(fields_.components(effects_.taken().without(taken_early)), drag_tag);
}

void CoupledStep::look_at_interval(const ParticleView& particles, const ExchangeRecords& records) {
  const Stopwatch watch(costs_, cost_look_);
  IntervalGas gas{gas_.density, frame_.grid};
  // Without own drag K is not that of a grain's motion.
  if (effects_.drag && effects_.own_drag())
    gas.void_fraction = &fields_.scalar(GasField::void_fraction);
  gas.interval = overlapped_ ? 2.0 * interval_ : interval_;
  interval_need_ = gasgrain::interval_need(particles, records, gas);
}

void CoupledStep::receive_answer() {
  const Stopwatch watch(costs_, cost_wait_);
  const FieldList late = fields_.components(effects_.lent().without(lent_early));
  if (!late.empty()) transport_.receive(late, lent_tag);
  report_ = partner_->receive_report();
  answer_to_come_ = false;
  share_fault(local_, report_.fault != 0 ? report_.fault_text.data() : "");
  if (local_.is_root())
    ledger_.add_given(
        Vec3(report_.drag_impulse[0], report_.drag_impulse[1], report_.drag_impulse[2]));
}

void CoupledStep::complete(const ParticleView& particles, ExchangeRecords& records) {
  if (!answer_to_come_) return;
  receive_answer();
  if (!effects_.any_reacts()) return;
  const Stopwatch watch(costs_, cost_sample_);
  book_where_charged(particles, records);
}

// The gas answered for particles where they were at the coupling; some of them are on other ranks
// now, or gone. What the cells were charged with counts for all of them.
void CoupledStep::book_where_charged(const ParticleView& particles, ExchangeRecords& records) {
  const RecordLayout& layout = records.layout();
  std::vector<double> positions(3 * particles.count);
  std::vector<double> velocities(3 * particles.count);
  for (std::size_t p = 0; p < particles.count; ++p)
    for (int d = 0; d < 3; ++d) {
      double x = records.at(p, layout.position)[d];
      // Of the images of where it was, that beside where it is.
      const double period = frame_.grid.hi[d] - frame_.grid.lo[d];
      if (frame_.grid.periodic[d]) x += period * std::round((particles.x(p)[d] - x) / period);
      positions[3 * p + d] = x;
      velocities[3 * p + d] = records.at(p, layout.velocity)[d];
    }
  ParticleView then = particles;
  then.position = positions.data();
  then.velocity = velocities.data();
  weights_.find(then, effects_.method, frame_);
  book_expected(then, weights_, effects_, fields_, interval_, records);
  // In scheme 1 the gas is not charged with what is owed.
  const bool charged_with_carry = !effects_.by_mean_velocity() || !effects_.own_drag();
  expected_in_interval_ =
      charged_to_gas() + (charged_with_carry ? expected_in_interval_ : Vec3::Zero());
}

// V sum (K u - S) interval over the tile [N s].
Vec3 CoupledStep::charged_to_gas() const {
  Vec3 sum = Vec3::Zero();
  const VectorField& source = fields_.vector(GasField::drag_source);
  for (int d = 0; d < 3; ++d) {
    for (const double s : source[d]) sum[d] -= s;
    if (!effects_.drag) continue;
    const Array3<double>& K = fields_.scalar(GasField::drag_coefficient);
    const Array3<double>& u = fields_.vector(GasField::velocity)[d];
    for (std::size_t n = 0; n < K.size(); ++n) sum[d] += K[n] * u[n];
  }
  return sum * frame_.grid.cell_volume() * interval_;
}

void CoupledStep::apply(const ParticleView& particles, ExchangeRecords& records,
                        const HostForces& host, double dt, double share) {
  const WallClock clock;
  forces_.apply(particles, records, host, dt, share);
  const double seconds = clock.seconds();
  for (std::size_t n = 0; n < cost_forces_.size(); ++n)
    costs_.charge(cost_forces_[n], seconds * forces_.costs().share(n));
}

CoupledStep::Clamps CoupledStep::take_clamps() {
  return std::exchange(clamps_, Clamps{});
}

long CoupledStep::take_bytes() {
  return std::exchange(bytes_, 0) + transport_.take_bytes();
}

void CoupledStep::checkpoint(long step) {
  Command command;
  command.kind = CommandKind::checkpoint;
  command.step = step;
  partner_->send_command(command);
  partner_->receive_report();
}

std::string CoupledStep::autopsy(long step) {
  Command command;
  command.kind = CommandKind::autopsy;
  command.step = step;
  partner_->send_command(command);
  return partner_->receive_report().fault_text.data();
}

std::string CoupledStep::finish() {
  transport_.finish_sends();
  return partner_->finish();
}

Ledger CoupledStep::whole_ledger(const ParticleView& particles,
                                 const ExchangeRecords& records) const {
  Ledger whole = ledger_;
  const Vec3 outstanding = outstanding_carry(particles, records);
  whole.set_outstanding(outstanding);
  whole.add_taken(forces_.applied());
  // Of grains removed since the last coupling.
  whole.add_left(forces_.applied().reacting - expected_in_interval_ - outstanding);
  std::vector<double> values = whole.values();
  local_.sum_in_place(values);
  whole.set_values(values);
  return whole;
}

void CoupledStep::resume(const ParticleView& particles, const ExchangeRecords& records,
                         const std::vector<double>& ledger_values, const Report& last) {
  if (local_.is_root()) ledger_.set_values(ledger_values);
  report_ = last;
  expected_in_interval_ = -outstanding_carry(particles, records);
}

}  // namespace gasgrain
