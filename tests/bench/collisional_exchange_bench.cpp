// What the collisional exchange costs a parcel and step, on one rank: `us_a_parcel`, processor
// time.
//
//   build/bench/collisional_exchange_bench [--benchmark_filter=REGEX]
//
// 20 parcels a cell, their cells in the order of the parcels, or as a host has them after a while,
// in no order. Each step begins with the same parcels, put back out of the time, so that there is
// always something to exchange.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

#include "fix_cfd_coupling/dem_physics/collisional_exchange/collisional_exchange.h"

namespace gasgrain {
namespace {

constexpr int parcels_a_cell = 20;

struct Parcels {
  std::vector<double> particles, solid_mass, solid_volume, film_mass, velocity, temperature;
  std::vector<std::uint32_t> cell;

  Parcels(const IndexBox& tile, std::size_t species, bool in_order) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const std::size_t count = tile.size() * parcels_a_cell;
    for (std::size_t p = 0; p < count; ++p) {
      particles.push_back(1e3);
      solid_volume.push_back(5e-13 * (0.5 + share(random)));
      solid_mass.push_back(1e3 * solid_volume.back());
      for (std::size_t i = 0; i < species; ++i)
        film_mass.push_back(0.1 * share(random) * solid_mass.back());
      for (int d = 0; d < 3; ++d) velocity.push_back(share(random));
      temperature.push_back(300.0 + 50.0 * share(random));
      cell.push_back(static_cast<std::uint32_t>(p / parcels_a_cell));
    }
    if (!in_order) std::shuffle(cell.begin(), cell.end(), random);
  }

  ExchangeView view() {
    ExchangeView v;
    v.count = cell.size();
    v.particles = particles.data();
    v.solid_mass = solid_mass.data();
    v.solid_volume = solid_volume.data();
    v.film_mass = film_mass.data();
    v.velocity = velocity.data();
    v.film_temperature = temperature.data();
    v.cell = cell.data();
    return v;
  }
};

void a_step(benchmark::State& state) {
  const auto species = static_cast<std::size_t>(state.range(0));
  const bool warm = state.range(1) != 0;
  const int cells = static_cast<int>(state.range(3));
  ExchangeSettings settings;
  for (std::size_t i = 0; i < species; ++i)
    settings.species.push_back({"liquid", 1000.0, {{4000.0, 0.5}, 250.0, 400.0}});
  if (warm) settings.film_temperature = 300.0;
  CollisionalExchange exchange(settings);
  const IndexBox tile{{0, 0, 0}, {cells, cells, cells}};
  const Parcels at_first(tile, species, state.range(2) != 0);
  Parcels parcels = at_first;
  constexpr double cell_volume = 1e-7;  // theta_s 0.1
  for (auto _ : state) {
    state.PauseTiming();
    parcels = at_first;
    state.ResumeTiming();
    exchange.step(parcels.view(), tile, cell_volume, 1e-4, [](const auto&) {});
  }
  state.counters["us_a_parcel"] = benchmark::Counter(
      1e-6 * static_cast<double>(parcels.cell.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// species, with temperatures, cells in order, cells along each side
BENCHMARK(a_step)
    ->ArgNames({"species", "warm", "in_order", "cells"})
    ->Args({0, 0, 1, 20})
    ->Args({1, 0, 1, 20})
    ->Args({1, 0, 0, 20})
    ->Args({1, 1, 1, 20})
    ->Args({3, 0, 1, 20})
    ->Args({3, 1, 1, 20})
    ->Args({1, 0, 0, 40})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gasgrain

BENCHMARK_MAIN();
