// What a coupling costs beside the DEM and the gas: a Markdown table over numbers of ranks.
//
//   mpirun -np 8 --oversubscribe --bind-to none --mca mpi_yield_when_idle 1
//   build/bench/coupling_bench
//     [--method NAME] [--particles N] [--cells N] [--couplings N] [--rounds N] [--pause MS]
//
// DEM ranks run the real CoupledStep, gas ranks a stand-in that has no flow: it takes what is
// deposited by the real transport and answers at once with given fields. A gas rank has a cube of
// `cells` along each side, in which are `particles` particles; they are shared by the DEM ranks
// there. Cases with more ranks than the launch has are left out; the ranks that a case does not
// need sleep. Cases are run in turn, again and again, since the machine may be shared. With a pause
// the gas ranks have waited long when the command comes, as they have after DEM steps, and look for
// it less often.
//
// ms are wall time, of the slowest rank at each coupling, then the median over couplings. On fewer
// cores than ranks they say little; processor time then says more: it knows no waiting. That of
// all-reduces, in which Open MPI spins, is left out.
// Messages are those that ranks send each other by themselves, counted where MPI_Isend is called.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>

#include "coupling/coupled_step.h"
#include "coupling/exchange/bed_measures.h"
#include "tests/exchange_cloud.h"

namespace {

struct Sent {
  long messages = 0;
  long bytes = 0;
};
Sent sent;
double all_reduce_ms = 0.0;  // processor time

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

// These take the place of the library's, which leaves the names with a P for this.
extern "C" int MPI_Isend(const void* buffer, int count, MPI_Datatype type, int to, int tag,
                         MPI_Comm comm, MPI_Request* request) {
  int size = 0;
  PMPI_Type_size(type, &size);
  ++sent.messages;
  sent.bytes += static_cast<long>(size) * count;
  return PMPI_Isend(buffer, count, type, to, tag, comm, request);
}

extern "C" int MPI_Allreduce(const void* mine, void* all, int count, MPI_Datatype type, MPI_Op op,
                             MPI_Comm comm) {
  const double before = processor_ms();
  const int result = PMPI_Allreduce(mine, all, count, type, op, comm);
  all_reduce_ms += processor_ms() - before;
  return result;
}

namespace gasgrain {
namespace {

constexpr double radius = 1.25e-3;    // [m]
constexpr double cell_size = 3.2e-3;  // [m]
constexpr double skin = 0.5e-3;       // [m]
constexpr double interval = 1e-3;     // [s]
constexpr int warm_up = 3;            // couplings that are not counted, the first one is fresh

struct Case {
  Int3 dem;  // ranks along each axis
  Int3 gas;

  static int count(const Int3& ranks) { return ranks[0] * ranks[1] * ranks[2]; }
  [[nodiscard]] int ranks() const { return count(dem) + count(gas); }
};

const std::vector<Case> cases{
    {{1, 1, 1}, {1, 1, 1}}, {{2, 1, 1}, {2, 1, 1}}, {{2, 2, 1}, {2, 2, 1}}, {{2, 2, 2}, {2, 2, 2}},
    {{2, 1, 1}, {1, 1, 1}}, {{3, 1, 1}, {1, 1, 1}}, {{2, 2, 1}, {1, 1, 1}},
};

struct Options {
  std::string method = "offset";
  int particles = 36500;
  int cells = 36;
  int couplings = 20;
  int rounds = 3;
  int pause = 0;  // of the DEM ranks before a coupling, instead of their steps [ms]
};

// What a rank measures at a coupling, [ms] and counts; of a case the greatest over the ranks.
enum Measure {
  void_fraction,
  drag_law,
  transport,
  waiting,
  sampling,
  history,
  whole,
  processor_dem,
  processor_gas,
  messages_dem,
  messages_gas,
  megabytes_dem,
  megabytes_gas,
  field_megabytes_dem,
  measures
};
using Row = std::array<double, measures>;

constexpr std::array<const char*, 5> task_names{
    "coupling: void fraction", "coupling: drag law", "coupling: transport",
    "coupling: waiting for the gas", "coupling: sampling"};

BoxGrid grid_of(const Case& which, const Options& options) {
  BoxGrid grid;
  for (int d = 0; d < 3; ++d) grid.cells[d] = options.cells * which.gas[d];
  grid.hi = cell_size * Vec3(grid.cells[0], grid.cells[1], grid.cells[2]);
  return grid;
}

IndexBox box_of(const BoxGrid& grid, const Int3& ranks, int rank) {
  const Int3 at{rank % ranks[0], rank / ranks[0] % ranks[1], rank / ranks[0] / ranks[1]};
  IndexBox box;
  for (int d = 0; d < 3; ++d) {
    box.lo[d] = grid.cells[d] * at[d] / ranks[d];
    box.hi[d] = grid.cells[d] * (at[d] + 1) / ranks[d];
  }
  return box;
}

double wall_ms() {
  return 1e3 * MPI_Wtime();
}

void count_sent(Row& row, Measure messages, Measure megabytes) {
  row[messages] = static_cast<double>(sent.messages);
  row[megabytes] = 1e-6 * static_cast<double>(sent.bytes);
  sent = {};
}

// Ranks of a program meet without spinning, so that none takes a core from those it waits for.
void meet_asleep(const Communicator& ranks) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(ranks.handle(), &request);
  wait_sleeping(request);
}

// The gas's side of the protocol, as in gas_solver/coupling_port.cpp, without a gas.
class GasWithoutFlow {
 public:
  GasWithoutFlow(const Communicator& local, MPI_Comm partner, const BoxGrid& grid,
                 const IndexBox& own)
      : local_(local), partner_(partner), grid_(grid), own_(own) {
    GasHello hello;
    put_text(hello.input_file, "coupling_bench");
    for (int d = 0; d < 3; ++d) hello.grid_hi[d] = grid.hi[d];
    hello.cells = grid.cells;
    hello.density = 1.2;
    hello.viscosity = 1.8e-5;
    for (const auto& field : gas_field_list)
      (field.lent ? hello.lends : hello.takes) |= FieldSet().add(field.field).bits();
    const DemHello dem = greet_dem(local, partner, hello);
    lent_ = FieldSet(dem.lent);
    taken_ = FieldSet(dem.taken);
    fields_ = FieldStore(lent_.united(taken_), own);
    for (Array3<double>* field : fields_.components(lent_)) field->fill(1.0);
  }

  std::vector<Row> serve() {
    std::vector<Row> rows;
    sent = {};
    double before = processor_ms();
    while (true) {
      const Command command = receive_command(local_, partner_);
      if (command.kind == CommandKind::finish) {
        send_text(local_, partner_, "");
        return rows;
      }
      couple(command.fresh != 0);
      Row row{};
      const double now = processor_ms();
      row[processor_gas] = now - before;
      before = now;
      count_sent(row, messages_gas, megabytes_gas);
      rows.push_back(row);
    }
  }

 private:
  void couple(bool fresh) {
    if (fresh)
      transport_ = RouteTransport(partner_,
                                  make_routes(grid_, own_, swap_boxes(partner_, own_), true), true);
    receive(taken_.common(taken_early), solids_tag);
    const Array3<double>& solids = fields_.scalar(GasField::solid_volume);
    Array3<double>& eps = fields_.scalar(GasField::void_fraction);
    for (std::size_t n = 0; n < eps.size(); ++n) eps[n] = 1.0 - solids[n] / grid_.cell_volume();
    transport_.send(fields_.components(fresh ? lent_ : lent_.common(lent_early)), lent_tag);
    receive(taken_.without(taken_early), drag_tag);
    transport_.send(fields_.components(lent_.without(lent_early)), lent_tag);
    send_report(local_, partner_, Report{});
  }

  void receive(FieldSet which, int tag) {
    const FieldList fields = fields_.components(which);
    for (Array3<double>* field : fields) field->fill(0.0);
    transport_.receive(fields, tag);
  }

  Communicator local_;
  MPI_Comm partner_;
  BoxGrid grid_;
  IndexBox own_;
  FieldSet lent_;
  FieldSet taken_;
  FieldStore fields_;
  RouteTransport transport_;
};

std::vector<Row> run_dem(const Communicator& local, MPI_Comm partner, const Case& which,
                         const Options& options) {
  const BoxGrid grid = grid_of(which, options);
  const IndexBox box = box_of(grid, which.dem, local.rank());
  DemRegion region;
  for (int d = 0; d < 3; ++d) {
    region.lo[d] = grid.lo[d] + cell_size * box.lo[d];
    region.hi[d] = grid.lo[d] + cell_size * box.hi[d];
  }
  region.drift = skin;
  region.largest_radius = radius;
  Random random(1 + local.rank());
  Cloud cloud;
  const int particles = options.particles * Case::count(which.gas) / Case::count(which.dem);
  for (int p = 0; p < particles; ++p)
    cloud.add(random.vector(region.lo, region.hi), random.vector(1.0), radius);
  const ParticleView view = cloud.view();

  const Effects effects = parse_effects(
      {"void_fraction", options.method, "drag", "koch_hill", "pressure_gradient"}, "bench");
  DemScene scene;
  scene.box_hi = grid.hi;
  scene.interval = interval;
  CoupledStep coupled(local, make_remote_gas(local, partner), effects, scene);
  ExchangeRecords records(effects.layout(false));
  records.resize(view.count);

  std::vector<Row> rows;
  sent = {};
  for (long step = 0; step < warm_up + options.couplings; ++step) {
    std::this_thread::sleep_for(std::chrono::milliseconds(options.pause));
    meet_asleep(local);
    std::array<double, task_names.size()> before{};
    for (std::size_t n = 0; n < task_names.size(); ++n)
      before[n] = coupled.costs().seconds(task_names[n]);
    const double processor = processor_ms() - all_reduce_ms;
    const double start = wall_ms();
    coupled.begin(view, region, records, interval, step, interval * static_cast<double>(step));
    Row row{};
    row[whole] = wall_ms() - start;
    row[processor_dem] = processor_ms() - all_reduce_ms - processor;
    for (std::size_t n = 0; n < task_names.size(); ++n)
      row[n] = 1e3 * (coupled.costs().seconds(task_names[n]) - before[n]);
    count_sent(row, messages_dem, megabytes_dem);
    row[field_megabytes_dem] = 1e-6 * static_cast<double>(coupled.take_bytes());

    // What the host's adaptor sums over the DEM ranks for a line of history.
    meet_asleep(local);
    const double record = wall_ms();
    BedMeasures bed(2, grid.lo[2], grid.hi[2]);
    bed.add(view);
    local.sum_in_place(bed.values());
    static_cast<void>(coupled.whole_ledger(view, records));
    row[history] = wall_ms() - record;
    rows.push_back(row);
  }
  coupled.finish();
  return rows;
}

// Of each coupling the greatest of all ranks; nothing on ranks that the case does not need.
std::vector<Row> run_case(const Communicator& world, const Case& which, const Options& options) {
  const int dem = Case::count(which.dem);
  const bool is_gas = world.rank() >= dem;
  const bool needed = world.rank() < which.ranks();
  MPI_Comm handle = MPI_COMM_NULL;
  MPI_Comm_split(world.handle(), needed ? (is_gas ? 1 : 0) : MPI_UNDEFINED, world.rank(), &handle);
  std::vector<Row> rows(warm_up + options.couplings, Row{});
  if (needed) {
    const Communicator local(handle);
    MPI_Comm partner = MPI_COMM_NULL;
    MPI_Intercomm_create(handle, 0, world.handle(), is_gas ? 0 : dem, 1, &partner);
    const BoxGrid grid = grid_of(which, options);
    rows = is_gas
               ? GasWithoutFlow(local, partner, grid, box_of(grid, which.gas, local.rank())).serve()
               : run_dem(local, partner, which, options);
    MPI_Comm_free(&partner);
    MPI_Comm_free(&handle);
  }
  meet_asleep(world);
  MPI_Allreduce(MPI_IN_PLACE, rows.data(), static_cast<int>(rows.size() * measures), MPI_DOUBLE,
                MPI_MAX, world.handle());
  rows.erase(rows.begin(), rows.begin() + warm_up);
  return rows;
}

double median(const std::vector<Row>& rows, Measure which) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row[which]);
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

void print_table(const std::vector<Case>& run, const std::vector<std::vector<Row>>& results) {
  fmt::print(
      "| DEM + gas ranks | void fraction | drag law | transport | waiting | sampling | whole "
      "coupling | 1 + 1 by this | history |\n|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t n = 0; n < run.size(); ++n) {
    fmt::print("| {} + {} |", Case::count(run[n].dem), Case::count(run[n].gas));
    for (const Measure m : {void_fraction, drag_law, transport, waiting, sampling, whole})
      fmt::print(" {:.2f} |", median(results[n], m));
    fmt::print(" {:.2f} | {:.2f} |\n", median(results[0], whole) / median(results[n], whole),
               median(results[n], history));
  }
  fmt::print(
      "\n| DEM + gas ranks | processor, DEM rank, ms | 1 + 1 by this | processor, gas rank, ms | 1 "
      "+ "
      "1 by this | messages sent by a DEM rank | by a gas rank | MB sent by a DEM rank | by a gas "
      "rank | MB of fields, DEM rank, both ways |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t n = 0; n < run.size(); ++n) {
    fmt::print("| {} + {} |", Case::count(run[n].dem), Case::count(run[n].gas));
    for (const Measure m : {processor_dem, processor_gas})
      fmt::print(" {:.1f} | {:.2f} |", median(results[n], m),
                 median(results[0], m) / median(results[n], m));
    fmt::print(" {:.0f} | {:.0f} |", median(results[n], messages_dem),
               median(results[n], messages_gas));
    for (const Measure m : {megabytes_dem, megabytes_gas, field_megabytes_dem})
      fmt::print(" {:.3f} |", median(results[n], m));
    fmt::print("\n");
  }
}

void run_all(const Options& options) {
  const Communicator world(MPI_COMM_WORLD);
  std::vector<Case> run;
  for (const Case& which : cases)
    if (which.ranks() <= world.size()) run.push_back(which);
  if (run.empty()) fail("the bench needs two ranks at least: mpirun -np 2 coupling_bench");
  std::vector<std::vector<Row>> results(run.size());
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t n = 0; n < run.size(); ++n) {
      const std::vector<Row> rows = run_case(world, run[n], options);
      results[n].insert(results[n].end(), rows.begin(), rows.end());
    }
  if (!world.is_root()) return;
  fmt::print("{}, {} particles and {}^3 cells a gas rank, ms a coupling, median of {}\n\n",
             options.method, options.particles, options.cells, options.rounds * options.couplings);
  print_table(run, results);
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  using namespace gasgrain;
  MPI_Init(&argc, &argv);
  CLI::App app{"cost of a coupling beside the DEM and the gas, over numbers of ranks"};
  Options options;
  app.add_option("--method", options.method, "void-fraction method");
  app.add_option("--particles", options.particles, "a gas rank")->check(CLI::PositiveNumber);
  app.add_option("--cells", options.cells, "along each side of a gas rank's cube")
      ->check(CLI::Range(4, 512));
  app.add_option("--couplings", options.couplings, "of a case in a round")
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", options.rounds, "through all cases")->check(CLI::PositiveNumber);
  app.add_option("--pause", options.pause, "of the DEM ranks before each coupling, ms")
      ->check(CLI::NonNegativeNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    run_all(options);
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return 0;
}
