// Cost of the particle side of a coupled step: 36,500 spheres of 2.5 mm in the lower part of
// 36 x 6 x 220 cells of 4.17 x 3.33 x 4.55 mm, every method and law of the LISTs. One core.
#include <benchmark/benchmark.h>

#include "coupling/exchange/applied_forces.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

constexpr std::size_t particle_count = 36500;
constexpr double particle_radius = 1.25e-3;

struct SpoutedBed {
  BoxGrid grid;
  TileFrame frame;
  Cloud cloud;
  Effects effects;
  ExchangeRecords records;
  std::vector<double> force;
  std::vector<double> torque;
  ParticleWeights weights;
  FieldStore fields;

  explicit SpoutedBed(const std::vector<std::string>& words)
      : effects(parse_effects(words, "bench")), records(effects.layout(false)) {
    grid.hi = {36 * 4.17e-3, 6 * 3.33e-3, 220 * 4.55e-3};
    grid.cells = {36, 6, 220};
    frame = {grid, grid.all()};
    Random random(1);
    for (std::size_t p = 0; p < particle_count; ++p)
      cloud.add(random.vector(Vec3::Zero(), Vec3(grid.hi[0], grid.hi[1], 0.2 * grid.hi[2])),
                random.vector(1.0), particle_radius);
    force.resize(3 * particle_count);
    torque.resize(3 * particle_count);
    records.resize(particle_count);
    weights.find(cloud.view(), effects.method, frame);
    fields = FieldStore(effects.lent().united(effects.taken()), frame.tile);
    for (Array3<double>* field : fields.components(effects.lent())) random.fill(*field, -1.0, 3.0);
    if (fields.has(GasField::void_fraction))
      random.fill(fields.scalar(GasField::void_fraction), 0.4, 0.95);
  }
};

constexpr GasProperties air{1.2, 1.8e-5};

std::vector<std::string> usual(std::string_view method) {
  return {"void_fraction", std::string(method), "drag", "koch_hill", "pressure_gradient"};
}

void find_weights(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  for (auto _ : state) bed.weights.find(bed.cloud.view(), bed.effects.method, bed.frame);
  state.counters["cells_per_particle"] =
      static_cast<double>(bed.weights.entries()) / static_cast<double>(particle_count);
}

void deposit(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  for (auto _ : state) {
    deposit_solids(bed.cloud.view(), bed.weights, bed.effects, bed.fields);
    deposit_drag(bed.cloud.view(), bed.weights, bed.effects, bed.grid.cell_volume(), 1e-4,
                 bed.fields, bed.records);
  }
}

void sample(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  for (auto _ : state) {
    book_expected(bed.cloud.view(), bed.weights, bed.effects, bed.fields, 1e-4, bed.records);
    benchmark::DoNotOptimize(set_gas_at_particles(bed.cloud.view(), bed.weights, bed.effects, air,
                                                  bed.fields, 1e-4, bed.records));
  }
}

void refresh(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        refresh_drag(bed.cloud.view(), bed.weights, bed.effects, air, bed.fields, bed.records));
}

// Once a DEM step, not once a coupling.
void forces(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  if (bed.effects.drag)
    refresh_drag(bed.cloud.view(), bed.weights, bed.effects, air, bed.fields, bed.records);
  set_gas_at_particles(bed.cloud.view(), bed.weights, bed.effects, air, bed.fields, 1e-4,
                       bed.records);
  ForceLoop loop(bed.effects, air);
  for (auto _ : state)
    loop.apply(bed.cloud.view(), bed.records, {bed.force.data(), bed.torque.data()}, 1e-6, 1.0);
}

// All that a DEM rank does at a coupling but talk: to be held against 100 DEM steps.
void coupled_step(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  const ParticleView view = bed.cloud.view();
  for (auto _ : state) {
    bed.weights.find(view, bed.effects.method, bed.frame);
    for (Array3<double>* field : bed.fields.components(bed.effects.taken())) field->fill(0.0);
    deposit_solids(view, bed.weights, bed.effects, bed.fields);
    benchmark::DoNotOptimize(
        refresh_drag(view, bed.weights, bed.effects, air, bed.fields, bed.records));
    deposit_drag(view, bed.weights, bed.effects, bed.grid.cell_volume(), 1e-4, bed.fields,
                 bed.records);
    benchmark::DoNotOptimize(
        set_gas_at_particles(view, bed.weights, bed.effects, air, bed.fields, 1e-4, bed.records));
    book_expected(view, bed.effects, 1e-4, bed.records);
  }
}

// The forces of the DEM steps between two couplings.
void forces_of_100_steps(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(words);
  refresh_drag(bed.cloud.view(), bed.weights, bed.effects, air, bed.fields, bed.records);
  set_gas_at_particles(bed.cloud.view(), bed.weights, bed.effects, air, bed.fields, 1e-4,
                       bed.records);
  ForceLoop loop(bed.effects, air);
  for (auto _ : state)
    for (int step = 0; step < 100; ++step)
      loop.apply(bed.cloud.view(), bed.records, {bed.force.data(), bed.torque.data()}, 1e-6, 1.0);
}

void register_all() {
  const auto add = [](const std::string& name, auto function, auto argument) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      function(state, argument);
    })->Unit(benchmark::kMillisecond);
  };
  for (const std::string& name : choice_names<VoidFractionMethod>()) {
    add("find_weights/" + name, find_weights, usual(name));
    add("deposit_volume_and_drag/" + name, deposit, usual(name));
    add("sample_velocity_and_pressure/" + name, sample, usual(name));
    add("coupled_step/" + name, coupled_step, usual(name));
  }
  add("forces_of_100_steps/drag_and_pressure_gradient", forces_of_100_steps, usual("offset"));
  for (const std::string& law : choice_names<DragModel>())
    add("refresh_drag/" + law, refresh,
        std::vector<std::string>{"void_fraction", "offset", "drag", law});
  add("apply_forces/none", forces, std::vector<std::string>{});
  add("apply_forces/drag", forces, std::vector<std::string>{"drag", "koch_hill"});
  for (const std::string& force : choice_names<Force>())
    add("apply_forces/drag_and_" + force, forces,
        std::vector<std::string>{"drag", "koch_hill", force});
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  gasgrain::register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
