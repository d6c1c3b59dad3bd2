#include "coupling/coupled_step.h"

#include <algorithm>
#include <utility>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

GasHello meet(const Communicator& local, MPI_Comm partner, const Effects& effects,
              const DemScene& scene) {
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
  const GasHello gas = greet_gas(local, partner, hello);
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

void append(FieldList& list, VectorField& field) {
  for (auto& component : field) list.push_back(&component);
}

}  // namespace

CoupledStep::CoupledStep(const Communicator& local, MPI_Comm partner, const Effects& effects,
                         const DemScene& scene)
    : local_(local),
      partner_(partner),
      effects_(effects),
      gas_(meet(local, partner, effects, scene)),
      frame_{grid_of(gas_), {}},
      ledger_(effects),
      cost_deposit_(costs_.task("coupling: void fraction")),
      cost_drag_(costs_.task("coupling: drag law")),
      cost_transport_(costs_.task("coupling: transport")),
      cost_wait_(costs_.task("coupling: waiting for the gas")),
      cost_sample_(costs_.task("coupling: sampling")),
      cost_forces_(costs_.task("coupling: forces")) {}

IndexBox CoupledStep::tile_of(const DemRegion& region) const {
  const BoxGrid& grid = frame_.grid;
  const int reach = stencil_reach(effects_.method, region.largest_radius, grid);
  IndexBox tile;
  for (int d = 0; d < 3; ++d) {
    tile.lo[d] = grid.cell_of(region.lo[d] - region.drift, d) - reach;
    tile.hi[d] = grid.cell_of(region.hi[d] + region.drift, d) + 1 + reach;
    if (grid.periodic[d]) continue;
    tile.lo[d] = std::clamp(tile.lo[d], 0, grid.cells[d] - 1);
    tile.hi[d] = std::clamp(tile.hi[d], tile.lo[d] + 1, grid.cells[d]);
  }
  return tile;
}

void CoupledStep::make_tile(const IndexBox& tile) {
  frame_.tile = tile;
  solid_volume_ = Array3<double>(tile);
  void_fraction_ = Array3<double>(tile, 1.0);
  const FieldSet used = effects_.lent().united(effects_.taken());
  if (used.has(GasField::drag_coefficient)) drag_coefficient_ = Array3<double>(tile);
  if (used.has(GasField::drag_source)) drag_source_ = make_vector_field(tile);
  if (used.has(GasField::velocity)) velocity_ = make_vector_field(tile);
  if (used.has(GasField::pressure_gradient)) pressure_gradient_ = make_vector_field(tile);
  transport_ = RouteTransport(
      partner_, make_routes(frame_.grid, tile, swap_boxes(partner_, tile), false), false);
}

FieldList CoupledStep::lent_fields() {
  FieldList list;
  if (effects_.lent().has(GasField::velocity)) append(list, velocity_);
  if (effects_.lent().has(GasField::pressure_gradient)) append(list, pressure_gradient_);
  return list;
}

// Carry that left with removed particles: what was taken and expected on all ranks less what the
// particles that are still there know of. (Particles that changed ranks cancel in the sum of
// ranks.)
void CoupledStep::settle(const ParticleView& particles, const ExchangeRecord* records) {
  ledger_.add_left(taken_in_interval_ - expected_in_interval_ -
                   outstanding_carry(particles.count, records));
  taken_in_interval_.setZero();
  expected_in_interval_.setZero();
}

Report CoupledStep::begin(const ParticleView& particles, const DemRegion& region,
                          ExchangeRecord* records, double interval, long step, double time) {
  const IndexBox tile = tile_of(region);
  const bool fresh = local_.max(tile != frame_.tile || !met_before_ ? 1.0 : 0.0) > 0.0;
  met_before_ = true;
  settle(particles, records);

  Command command;
  command.kind = CommandKind::couple;
  command.fresh = fresh ? 1 : 0;
  command.step = step;
  command.time = time;
  command.interval = interval;
  send_command(local_, partner_, command);
  if (fresh) make_tile(tile);
  {
    const Stopwatch watch(costs_, cost_deposit_);
    weights_.find(particles, effects_.method, frame_);
    clamps_.beyond_walls += static_cast<long>(weights_.beyond_walls());
    solid_volume_.fill(0.0);
    deposit_solid_volume(particles, weights_, solid_volume_);
  }
  {
    const Stopwatch watch(costs_, cost_transport_);
    transport_.send({&solid_volume_}, solids_tag);
    FieldList back;
    if (effects_.lent().has(GasField::void_fraction)) back.push_back(&void_fraction_);
    if (fresh && effects_.lent().has(GasField::velocity)) append(back, velocity_);
    if (!back.empty()) transport_.receive(back, lent_tag);
  }
  if (effects_.drag) {
    {
      const Stopwatch watch(costs_, cost_drag_);
      const DragRefresh met = refresh_drag(
          particles, weights_, *effects_.drag,
          GasProperties{gas_.density, gas_.viscosity, gas_.whole_pressure_gradient != 0},
          void_fraction_, velocity_, records);
      clamps_.too_dense += static_cast<long>(met.too_dense);
      drag_coefficient_.fill(0.0);
      for (auto& component : drag_source_) component.fill(0.0);
      deposit_drag(particles, weights_, records, frame_.grid.cell_volume(), interval,
                   drag_coefficient_, drag_source_);
    }
    const Stopwatch watch(costs_, cost_transport_);
    FieldList taken{&drag_coefficient_};
    append(taken, drag_source_);
    transport_.send(taken, drag_tag);
  }
  Report report;
  {
    const Stopwatch watch(costs_, cost_wait_);
    const FieldList lent = lent_fields();
    if (!lent.empty()) transport_.receive(lent, lent_tag);
    report = receive_report(local_, partner_);
  }
  const Stopwatch watch(costs_, cost_sample_);
  const LentFields lent{
      effects_.lent().has(GasField::velocity) ? &velocity_ : nullptr,
      effects_.lent().has(GasField::pressure_gradient) ? &pressure_gradient_ : nullptr};
  ledger_.add_steady_work(set_records(particles, weights_, effects_, lent, interval, records));
  expected_in_interval_ = -outstanding_carry(particles.count, records);
  if (local_.is_root())
    ledger_.add_given(Vec3(report.drag_impulse[0], report.drag_impulse[1], report.drag_impulse[2]));
  return report;
}

void CoupledStep::apply(const ParticleView& particles, ExchangeRecord* records, double* force,
                        double dt) {
  const Stopwatch watch(costs_, cost_forces_);
  const AppliedDrag applied = apply_forces(particles, effects_, records, force, dt);
  taken_in_interval_ += applied.impulse;
  ledger_.add_taken(applied);
}

CoupledStep::Clamps CoupledStep::take_clamps() {
  return std::exchange(clamps_, Clamps{});
}

void CoupledStep::checkpoint(long step) {
  Command command;
  command.kind = CommandKind::checkpoint;
  command.step = step;
  send_command(local_, partner_, command);
  receive_report(local_, partner_);
}

void CoupledStep::finish() {
  send_command(local_, partner_, Command{});
}

Ledger CoupledStep::whole_ledger(const ParticleView& particles,
                                 const ExchangeRecord* records) const {
  Ledger whole = ledger_;
  const Vec3 outstanding = outstanding_carry(particles.count, records);
  whole.set_outstanding(outstanding);
  // Of grains removed since the last coupling.
  whole.add_left(taken_in_interval_ - expected_in_interval_ - outstanding);
  std::vector<double> values = whole.values();
  local_.sum_in_place(values);
  whole.set_values(values);
  return whole;
}

void CoupledStep::resume(const ParticleView& particles, const ExchangeRecord* records,
                         const std::vector<double>& ledger_values) {
  if (local_.is_root()) ledger_.set_values(ledger_values);
  expected_in_interval_ = -outstanding_carry(particles.count, records);
}

}  // namespace gasgrain
