// Cost of the particle side of a coupled step: 36,500 spheres of 2.5 mm in the lower part of
// 36 x 6 x 220 cells of 4.17 x 3.33 x 4.55 mm, every method and law of the LISTs. One core.
#include <benchmark/benchmark.h>

#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

constexpr std::size_t particle_count = 36500;
constexpr double particle_radius = 1.25e-3;

struct SpoutedBed {
  BoxGrid grid;
  TileFrame frame;
  Cloud cloud;
  std::vector<ExchangeRecord> records{particle_count};
  std::vector<double> force;
  ParticleWeights weights;
  VectorField velocity;
  VectorField source;
  Array3<double> void_fraction;
  Array3<double> coefficient;

  explicit SpoutedBed(const VoidFractionMethod& method) {
    grid.hi = {36 * 4.17e-3, 6 * 3.33e-3, 220 * 4.55e-3};
    grid.cells = {36, 6, 220};
    frame = {grid, grid.all()};
    Random random(1);
    for (std::size_t p = 0; p < particle_count; ++p)
      cloud.add(random.vector(Vec3::Zero(), Vec3(grid.hi[0], grid.hi[1], 0.2 * grid.hi[2])),
                random.vector(1.0), particle_radius);
    force.resize(3 * particle_count);
    weights.find(cloud.view(), method, frame);
    velocity = make_vector_field(frame.tile);
    for (auto& component : velocity) random.fill(component, -1.0, 3.0);
    source = make_vector_field(frame.tile);
    void_fraction = Array3<double>(frame.tile);
    random.fill(void_fraction, 0.4, 0.95);
    coefficient = Array3<double>(frame.tile);
  }
};

void find_weights(benchmark::State& state, const VoidFractionMethod& method) {
  SpoutedBed bed(method);
  for (auto _ : state) bed.weights.find(bed.cloud.view(), method, bed.frame);
  state.counters["cells_per_particle"] =
      static_cast<double>(bed.weights.entries()) / static_cast<double>(particle_count);
}

void deposit(benchmark::State& state, const VoidFractionMethod& method) {
  SpoutedBed bed(method);
  for (auto _ : state) {
    deposit_solid_volume(bed.cloud.view(), bed.weights, bed.void_fraction);
    deposit_drag(bed.cloud.view(), bed.weights, bed.records.data(), bed.grid.cell_volume(), 1e-4,
                 bed.coefficient, bed.source);
  }
}

void sample(benchmark::State& state, const VoidFractionMethod& method) {
  SpoutedBed bed(method);
  const Effects effects = parse_effects({"drag", "koch_hill", "pressure_gradient"}, "bench");
  for (auto _ : state)
    benchmark::DoNotOptimize(set_records(bed.cloud.view(), bed.weights, effects,
                                         {&bed.velocity, &bed.velocity}, 1e-4, bed.records.data()));
}

void refresh(benchmark::State& state, const DragModel& law) {
  SpoutedBed bed(VoidFractionOffset{});
  for (auto _ : state)
    benchmark::DoNotOptimize(refresh_drag(bed.cloud.view(), bed.weights, law, {1.2, 1.8e-5},
                                          bed.void_fraction, bed.velocity, bed.records.data()));
}

// Once a DEM step, not once a coupling.
void forces(benchmark::State& state, const std::vector<std::string>& words) {
  SpoutedBed bed(VoidFractionOffset{});
  const Effects effects = parse_effects(words, "bench");
  for (auto _ : state)
    benchmark::DoNotOptimize(
        apply_forces(bed.cloud.view(), effects, bed.records.data(), bed.force.data(), 1e-6));
}

void register_all() {
  const auto add = [](const std::string& name, auto function, auto argument) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      function(state, argument);
    })->Unit(benchmark::kMillisecond);
  };
  for_each_choice<VoidFractionMethod>([&](auto method) {
    const std::string name(method.name);
    add("find_weights/" + name, find_weights, VoidFractionMethod(method));
    add("deposit_volume_and_drag/" + name, deposit, VoidFractionMethod(method));
    add("sample_velocity_and_pressure/" + name, sample, VoidFractionMethod(method));
  });
  for_each_choice<DragModel>(
      [&](auto law) { add("refresh_drag/" + std::string(law.name), refresh, DragModel(law)); });
  add("apply_forces/none", forces, std::vector<std::string>{});
  add("apply_forces/drag", forces, std::vector<std::string>{"drag", "koch_hill"});
  add("apply_forces/drag_and_pressure", forces,
      std::vector<std::string>{"drag", "koch_hill", "pressure_gradient"});
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  gasgrain::register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
