// A step of the gas alone on the grid of a spouted bed, 36 x 6 x 220 cells, with a bubbly field of
// void fraction and drag that drifts from step to step, warm. Counters: milliseconds a step by task
// and iterations of the pressure solver.
#include <benchmark/benchmark.h>
#include <mpi.h>

#include <cmath>
#include <random>

#include "gas_solver/gas_step.h"

namespace gasgrain {
namespace {

constexpr double step_length = 0.5e-3;
constexpr double bed_height = 0.4;
constexpr double packed = 0.42;
constexpr double bed_drag = 4000;  // [kg/(m3 s)] of a packed bed of 2.5 mm grains at a few m/s

GasInput spouted_bed(PressureMethod method) {
  GasInput input;
  input.grid.lo = Vec3::Zero();
  input.grid.hi = Vec3(0.15, 0.02, 1.0);
  input.grid.cells = {36, 6, 220};
  input.step = step_length;
  input.courant_max = 1000;  // one step an interval, whatever the jet
  input.sides[side_of(2, true)] = &outlet;
  input.pressure = method;
  InflowPatch jet;
  jet.side = side_of(2, false);
  jet.outline.bounds = {{0.071, 0.006}, {0.079, 0.014}};
  jet.velocity = 80;
  input.inflows = {jet};
  return input;
}

struct Bubble {
  Vec3 center;
  double radius;
};

// Void fraction with bubbles that rise at 0.5 m/s, and Ergun-like drag.
void bubbly(const GasSolver& gas, double time, Array3<double>& eps, Array3<double>& drag) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Bubble> bubbles;
  for (int n = 0; n < 25; ++n)
    bubbles.push_back(
        {{0.15 * unit(random), 0.01, std::fmod(bed_height * unit(random) + 0.5 * time, bed_height)},
         0.008 + 0.02 * unit(random)});
  const Vec3 h = gas.grid().spacing();
  for_each_cell(gas.own(), [&](int i, int j, int k) {
    const Vec3 x = h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
    double solids = x[2] < bed_height ? 1 - packed : 0.0;
    for (const Bubble& b : bubbles)
      if ((x - b.center).norm() < b.radius) solids *= 0.02;
    solids *= 0.9 + 0.1 * unit(random);
    eps(i, j, k) = 1 - solids;
    drag(i, j, k) = bed_drag * std::pow(solids / (1 - packed), 2) / (1 - solids) * packed;
  });
}

void gas_step(benchmark::State& bench, PressureMethod method) {
  GasSolver gas(spouted_bed(method), Communicator(MPI_COMM_SELF));
  Array3<double> eps(gas.own());
  Array3<double> drag(gas.own());
  const CellVector source{Array3<double>(gas.own()), Array3<double>(gas.own()),
                          Array3<double>(gas.own())};
  const auto advance = [&] {
    bubbly(gas, gas.time(), eps, drag);
    gas.set_void_fraction(eps);
    gas.set_drag(drag, source);
    return gas.advance(step_length);
  };
  for (int n = 0; n < 5; ++n) advance();
  const double momentum = gas.costs().seconds("momentum");
  const double pressure = gas.costs().seconds("pressure");
  const double means = gas.costs().seconds("means");
  const double measures = gas.costs().seconds("measures");
  double iterations = 0;
  double courant = 0;
  for (auto _ : bench) {
    bench.PauseTiming();
    bubbly(gas, gas.time(), eps, drag);
    bench.ResumeTiming();
    gas.set_void_fraction(eps);
    gas.set_drag(drag, source);
    const GasReport report = gas.advance(step_length);
    iterations += report.pressure_iterations;
    courant = report.courant_max;
  }
  const auto per_step = [&](const char* task, double before) {
    return 1e3 * (gas.costs().seconds(task) - before) / static_cast<double>(bench.iterations());
  };
  bench.counters["momentum_ms"] = per_step("momentum", momentum);
  bench.counters["pressure_ms"] = per_step("pressure", pressure);
  bench.counters["means_ms"] = per_step("means", means);
  bench.counters["measures_ms"] = per_step("measures", measures);
  bench.counters["iterations"] = iterations / static_cast<double>(bench.iterations());
  bench.counters["courant"] = courant;
}

BENCHMARK_CAPTURE(gas_step, hypre, PressureMethod::hypre)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(30)
    ->Repetitions(3);

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  MPI_Finalize();
}
