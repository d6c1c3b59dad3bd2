// A step of the gas alone in a spouted bed with a bubbly field of void fraction and drag that
// drifts from step to step, warm, on grids of 4.8e4, 3.8e5 and 2.0e6 cells; the step shrinks as the
// cells do, so that the Courant number stays. Counters: milliseconds a step by task, nanoseconds a
// cell and step, iterations of the pressure solver, memory a cell (resident, of the whole solver,
// libraries included). Then choices of gas.toml against the default on the smallest grid.
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <mpi.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <random>

#include "gas_solver/gas_step.h"

namespace gasgrain {
namespace {

constexpr double step_on_smallest = 0.5e-3;
constexpr double bed_height = 0.4;
constexpr double packed = 0.42;
constexpr double bed_drag = 4000;  // [kg/(m3 s)] of a packed bed of 2.5 mm grains at a few m/s

// Of the grid's n-th refinement.
constexpr Int3 grids[] = {{36, 6, 220}, {72, 12, 440}, {126, 21, 770}};

double step_length(int grid) {
  return step_on_smallest * grids[0][2] / grids[grid][2];
}

GasInput spouted_bed(int grid) {
  GasInput input;
  input.grid.lo = Vec3::Zero();
  input.grid.hi = Vec3(0.15, 0.02, 1.0);
  input.grid.cells = grids[grid];
  input.step = step_length(grid);
  input.courant_max = 1000;  // one step an interval, whatever the jet
  input.sides[side_of(2, true)] = &outlet;
  InflowPatch jet;
  jet.side = side_of(2, false);
  // Two by two cells of the coarsest grid: on all of them some faces are covered in full.
  jet.outline.bounds = {{0.15 * 17 / 36, 0.02 * 2 / 6}, {0.15 * 19 / 36, 0.02 * 4 / 6}};
  jet.velocity = 40;
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

// Memory that this process holds [bytes].
double resident() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  long total = 0;
  long pages = 0;
  file >> total >> pages;
  return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void gas_step(benchmark::State& bench, int grid, const std::function<void(GasInput&)>& choose) {
  const double before = resident();
  GasInput input = spouted_bed(grid);
  choose(input);
  GasSolver gas(input, Communicator(MPI_COMM_SELF));
  Array3<double> eps(gas.own());
  Array3<double> drag(gas.own());
  const CellVector source = make_vector(gas.own());
  const double length = step_length(grid);
  const auto advance = [&] {
    bubbly(gas, gas.time(), eps, drag);
    gas.set_void_fraction(eps);
    gas.set_drag(drag, source);
    return gas.advance(length);
  };
  for (int n = 0; n < 5; ++n) advance();
  const double cells = static_cast<double>(gas.own().size());
  constexpr double fields_of_the_bench = 5 * sizeof(double);
  bench.counters["bytes_per_cell"] = (resident() - before) / cells - fields_of_the_bench;
  const std::array<const char*, 5> tasks{"turbulence", "momentum", "pressure", "means", "measures"};
  std::array<double, 5> seconds{};
  for (std::size_t n = 0; n < tasks.size(); ++n) seconds[n] = gas.costs().seconds(tasks[n]);
  double iterations = 0;
  double courant = 0;
  double wall = 0;
  for (auto _ : bench) {
    bubbly(gas, gas.time(), eps, drag);
    const double start = MPI_Wtime();
    gas.set_void_fraction(eps);
    gas.set_drag(drag, source);
    const GasReport report = gas.advance(length);
    wall += MPI_Wtime() - start;
    bench.SetIterationTime(MPI_Wtime() - start);
    iterations += report.pressure_iterations;
    courant = report.courant_max;
  }
  const double steps = static_cast<double>(bench.iterations());
  for (std::size_t n = 0; n < tasks.size(); ++n)
    bench.counters[std::string(tasks[n]) + "_ms"] =
        1e3 * (gas.costs().seconds(tasks[n]) - seconds[n]) / steps;
  bench.counters["ns_per_cell"] = 1e9 * wall / steps / cells;
  bench.counters["iterations"] = iterations / steps;
  bench.counters["courant"] = courant;
}

void nothing(GasInput&) {}

// What the libraries allocate once is not memory of cells.
void load_libraries() {
  GasInput input = spouted_bed(0);
  input.grid.cells = {6, 4, 8};
  GasSolver gas(input, Communicator(MPI_COMM_SELF));
  Array3<double> eps(gas.own());
  Array3<double> drag(gas.own());
  for (int n = 0; n < 3; ++n) {
    bubbly(gas, gas.time(), eps, drag);
    gas.set_void_fraction(eps);
    gas.set_drag(drag, make_vector(gas.own()));
    gas.advance(step_on_smallest);
  }
}

void add(const char* name, int grid, int steps, const std::function<void(GasInput&)>& choose) {
  benchmark::RegisterBenchmark(name,
                               [=](benchmark::State& bench) { gas_step(bench, grid, choose); })
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(steps);
}

void add_all() {
  add("cells/48e3", 0, 60, nothing);
  add("cells/380e3", 1, 10, nothing);
  add("cells/2037e3", 2, 4, nothing);
  add("default", 0, 60, nothing);
  add("convection=upwind", 0, 60, [](GasInput& g) { g.convection = Convection::upwind; });
  add("convection=central", 0, 60, [](GasInput& g) { g.convection = Convection::central; });
  add("convection=quick", 0, 60, [](GasInput& g) { g.convection = Convection::quick; });
  add("scheme=crank_nicolson", 0, 60, [](GasInput& g) { g.scheme = TimeScheme::crank_nicolson; });
  add("pressure_velocity=simplec", 0, 20, [](GasInput& g) {
    g.pressure_velocity = PressureVelocity::simplec;
    g.relax_velocity = 0.9;
    g.relax_pressure = 1;
    g.outer_tolerance = 1e-3;
  });
  add("law=ideal_gas", 0, 60, [](GasInput& g) { g.law = GasLaw::ideal_gas; });
  add("model=B", 0, 60, [](GasInput& g) { g.model = GasModel::b; });
  add("turbulence=smagorinsky", 0, 60,
      [](GasInput& g) { g.turbulence.model = TurbulenceModel::smagorinsky; });
  add("turbulence=k_epsilon", 0, 60,
      [](GasInput& g) { g.turbulence.model = TurbulenceModel::k_epsilon; });
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  gasgrain::load_libraries();
  gasgrain::add_all();
  benchmark::RunSpecifiedBenchmarks();
  MPI_Finalize();
}
