// A fixed cloud of particles and a few steps of a small gas, for counting what they cost. Compiled
// twice, with all effects and with those of one scene (CMakeLists.txt).
//   driver loops GAS_TOML WORDS...     particle_loop() and gas_steps() are to be counted
//   driver coupled GAS_TOML WORDS...   prints what a coupled run stores, and sends
#include <fmt/format.h>
#include <mpi.h>

#include <cstdlib>
#include <filesystem>
#include <new>

#include "coupling/coupled_step.h"
#include "coupling/transport/inner_gas.h"
#include "gas_solver/gas_step.h"
#include "tests/exchange_cloud.h"

namespace {

// Bytes of operator new that are in use. Its caller's size is kept before each piece.
constexpr std::size_t header = alignof(std::max_align_t);
std::size_t bytes_in_use = 0;
std::size_t bytes_at_peak = 0;

}  // namespace

void* operator new(std::size_t size) {
  auto* piece = static_cast<char*>(std::malloc(size + header));
  if (piece == nullptr) throw std::bad_alloc();
  *reinterpret_cast<std::size_t*>(piece) = size;
  bytes_in_use += size;
  bytes_at_peak = std::max(bytes_at_peak, bytes_in_use);
  return piece + header;
}
void operator delete(void* place) noexcept {
  if (place == nullptr) return;
  char* piece = static_cast<char*>(place) - header;
  bytes_in_use -= *reinterpret_cast<std::size_t*>(piece);
  std::free(piece);
}
void operator delete(void* place, std::size_t) noexcept {
  operator delete(place);
}

namespace gasgrain {

constexpr double dt = 1e-5;
constexpr int steps = 20;  // from one coupling to the next
constexpr int couplings = 3;
constexpr std::size_t particles = 4000;

struct Bed {
  Bed(const GasInput& input, const std::vector<std::string>& words)
      : grid(input.grid), effects(parse_effects(words, "driver")), records(effects.layout(false)) {
    Random random{5};
    cloud = random_cloud(grid, particles, random);
    records.resize(particles);
    force.assign(3 * particles, 0.0);
    torque.assign(3 * particles, 0.0);
  }
  HostForces host() {
    std::fill(force.begin(), force.end(), 0.0);
    return {force.data(), torque.data()};
  }

  BoxGrid grid;
  Effects effects;
  ExchangeRecords records;
  Cloud cloud;
  std::vector<double> force;
  std::vector<double> torque;
};

// What coupled_step.h does with particles, but for the messages.
__attribute__((noinline)) void particle_loop(Bed& bed, FieldStore& fields, const TileFrame& frame,
                                             const GasProperties& air, ForceLoop& loop) {
  const ParticleView view = bed.cloud.view();
  const double interval = steps * dt;
  ParticleWeights weights;
  for (int n = 0; n < couplings; ++n) {
    weights.find(view, bed.effects.method, frame);
    deposit_solids(view, weights, bed.effects, fields);
    if (bed.effects.drag) refresh_drag(view, weights, bed.effects, air, fields, bed.records);
    if (bed.effects.any_reacts())
      deposit_drag(view, weights, bed.effects, bed.grid.cell_volume(), interval, fields,
                   bed.records);
    set_gas_at_particles(view, weights, bed.effects, air, fields, interval, bed.records);
    book_expected(view, bed.effects, interval, bed.records);
    for (int step = 0; step < steps; ++step) loop.apply(view, bed.records, bed.host(), dt, 1.0);
  }
}

void count_particles(const GasInput& input, const std::vector<std::string>& words) {
  Bed bed(input, words);
  const GasProperties air{input.density, input.viscosity};
  const TileFrame frame = whole_frame(bed.grid, bed.effects.method);
  FieldStore fields(bed.effects.lent().united(bed.effects.taken()), frame.tile);
  Random random{6};
  for (Array3<double>* field : fields.components(bed.effects.lent())) random.fill(*field, 0.5, 0.9);
  ForceLoop loop(bed.effects, air);
  particle_loop(bed, fields, frame, air, loop);
}

__attribute__((noinline)) void gas_steps(GasSolver& gas) {
  for (int n = 0; n < couplings; ++n) gas.advance(steps * dt);
}

__attribute__((noinline)) void count_gas(const GasInput& input) {
  GasSolver gas(input, Communicator(MPI_COMM_SELF));
  Array3<double> eps(gas.own());
  Array3<double> K(gas.own());
  CellVector source{Array3<double>(gas.own()), Array3<double>(gas.own()),
                    Array3<double>(gas.own())};
  Random random{7};
  random.fill(eps, 0.5, 0.9);
  random.fill(K, 10.0, 100.0);
  gas.set_void_fraction(eps);
  gas.set_drag(K, source);
  gas_steps(gas);
}

void tell_coupled(const GasInput& input, const std::string& gas_toml,
                  const std::vector<std::string>& words) {
  Bed bed(input, words);
  const Communicator self(MPI_COMM_SELF);
  const std::string out = std::filesystem::path(gas_toml).parent_path() / "out";
  DemScene scene;
  scene.box_lo = bed.grid.lo;
  scene.box_hi = bed.grid.hi;
  scene.interval = steps * dt;
  CoupledStep coupled(self, make_inner_gas({gas_toml, out, ""}, self), bed.effects, scene);
  const DemRegion region{bed.grid.lo, bed.grid.hi, 1e-4, cloud_radius};
  const ParticleView view = bed.cloud.view();
  for (int n = 0; n < couplings; ++n) {
    coupled.begin(view, region, bed.records, scene.interval, n * steps, n * scene.interval);
    for (int step = 0; step < steps; ++step) coupled.apply(view, bed.records, bed.host(), dt, 1.0);
  }
  fmt::print("{{\"record\": {}, \"wire\": {}, \"peak\": {}}}\n",
             bed.records.layout().size * sizeof(double), coupled.take_bytes(), bytes_at_peak);
  coupled.finish();
}

}  // namespace gasgrain

int main(int argc, char** argv) {
  if (argc < 3) return 1;
  MPI_Init(&argc, &argv);
  const std::string mode = argv[1];
  try {
    const gasgrain::GasInput input = gasgrain::read_gas_input(argv[2], false);
    const std::vector<std::string> words(argv + 3, argv + argc);
    if (mode == "loops") {
      gasgrain::count_particles(input, words);
      gasgrain::count_gas(input);
    } else {
      gasgrain::tell_coupled(input, argv[2], words);
    }
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return 0;
}
