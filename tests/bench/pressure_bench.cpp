// The pressure solvers against each other: a Markdown table of iterations, time and memory against
// contrast (the greatest coefficient by the least) and cells, on the grid of a spouted bed, 6 : 1 :
// 36, with an outlet at its top. Bubbles rise through a bed whose packing scatters by 10 %; each
// solve is of the next step, from 0 until the residual is 1e-8 of the source's in the 2-norm.
//
//   pressure_bench [--quick] [--cells N...] [--solves N] [--contrasts C...]   on any number of
//   ranks
//
// A contrast of 1 is one coefficient everywhere, which FFTW solves directly. A method that needs
// too many iterations is left out on the larger grids. Progress goes to stderr.
//
// Times are processor times: of what else the machine does only the caches and the memory that it
// takes are in them (and a rank's waiting for others, since MPI spins). The methods take turns step
// by step, every second step backwards, so that this falls on all of them alike. Steps go on until
// even the fastest method has been measured for a fifth of a second: solves of 2 ms need many to be
// told apart. "By the best's" is told twice: the
// median over steps of a method's time by the best one's of the same step, which a few disturbed
// steps do not move, and the ratio of the sums, which has what a method's trials cost. The best is
// the one with the least median, "auto" aside.
#include <fmt/format.h>
#include <malloc.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <numeric>
#include <random>

#include "gas_solver/pressure/pressure_solver.h"

namespace gasgrain {
namespace {

constexpr double relative_tolerance = 1e-8;
constexpr double packed = 0.42;
constexpr double bed_share = 0.4;  // of the height
constexpr int bubble_count = 25;
constexpr int warm_up = 2;              // steps
constexpr double least_measured = 200;  // of the fastest method of a row [ms]
constexpr int most_solves = 1000;
constexpr int too_many_iterations = 80;
constexpr Sides sides{&wall_no_slip, &wall_no_slip, &wall_no_slip,
                      &wall_no_slip, &wall_no_slip, &outlet};

struct Bed {
  const char* name;
  double contrast;
  int bubbles;
};

struct Method {
  const char* name;
  PressureMethod method;
};
constexpr std::array<Method, 4> methods{{{"fftw", PressureMethod::fftw},
                                         {"multigrid", PressureMethod::multigrid},
                                         {"hypre", PressureMethod::hypre},
                                         {"auto", PressureMethod::automatic}}};

constexpr std::array<Bed, 6> beds{{{"1", 1, 0},
                                   {"24, no bubbles", 24, 0},
                                   {"650, no bubbles", 650, 0},
                                   {"24", 24, bubble_count},
                                   {"650", 650, bubble_count},
                                   {"10000", 10000, bubble_count}}};

double processor_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

BoxGrid spouted_bed(double cells) {
  const double unit = std::cbrt(cells / (6.0 * 36.0));
  BoxGrid grid;
  grid.hi = Vec3(0.15, 0.025, 0.9);
  grid.cells = {2 * static_cast<int>(std::lround(3 * unit)), static_cast<int>(std::lround(unit)),
                4 * static_cast<int>(std::lround(9 * unit))};
  return grid;
}

// A number in [0, 1) of the cell alone, so that ranks agree on it.
double scatter(int i, int j, int k) {
  std::uint64_t h = static_cast<std::uint64_t>(i) * 73856093U ^
                    static_cast<std::uint64_t>(j) * 19349663U ^
                    static_cast<std::uint64_t>(k) * 83492791U;
  h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
  h = (h ^ (h >> 12)) * 0x297a2d39U;
  return static_cast<double>((h ^ (h >> 15)) & 0xffffffU) / 0x1000000;
}

// Coefficients eps w / h2 with w = eps / (eps + K), in units in which rho / dt is 1, at the step's
// number `step`: bubbles rise by a thousandth of the bed a step, and its packing changes
// slowly.
void set_bed(const Domain& domain, const Bed& bed, int step, PressureSystem& system) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Vec3 h = domain.grid().spacing();
  const Vec3& size = domain.grid().hi;
  const double bed_height = bed_share * size[2];
  std::vector<std::pair<Vec3, double>> bubbles;
  for (int n = 0; n < bed.bubbles; ++n) {
    const double x = unit(random);
    const double z = std::fmod(unit(random) + 0.001 * step, 1.0);
    bubbles.emplace_back(Vec3(x * size[0], 0.5 * size[1], z * bed_height),
                         size[0] * (0.05 + 0.13 * unit(random)));
  }
  const double bed_drag = bed.contrast == 1 ? 0.0 : packed * packed * bed.contrast - packed;
  Array3<double> eps(domain.box(), 1.0);
  Array3<double> drag(domain.box(), 0.0);
  if (bed.contrast > 1)
    for_each_cell(domain.box(), [&](int i, int j, int k) {
      const Vec3 x = h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
      if (x[2] > bed_height) return;
      for (const auto& [centre, radius] : bubbles)
        if ((x - centre).norm() < radius) return;
      const double loose = 0.5 + 0.5 * std::sin(2 * M_PI * (scatter(i, j, k) + 0.01 * step));
      const double solids = (1 - packed) * (1 - 0.1 * loose);
      eps(i, j, k) = 1 - solids;
      drag(i, j, k) = bed_drag * std::pow(solids / (1 - packed), 2);
    });
  for (int d = 0; d < 3; ++d) {
    Array3<double>& c = system.face_coefficient[d];
    const std::ptrdiff_t s = c.stride(d);
    IndexBox faces = domain.own();
    ++faces.hi[d];
    for_each_cell(faces, [&](int i, int j, int k) {
      const auto o = c.offset(i, j, k);
      const double e = 0.5 * (eps[o - s] + eps[o]);
      const double k_f = 0.5 * (drag[o - s] + drag[o]);
      c[o] = domain.grid().cell_volume() / (h[d] * h[d]) * e * e / (e + k_f);
    });
    for (const bool high : {false, true}) {
      const double open = system.sides[side_of(d, high)]->normal_velocity_given ? 0.0 : 2.0;
      for_each_cell(domain.side_faces(side_of(d, high)),
                    [&](int i, int j, int k) { c(i, j, k) *= open; });
    }
  }
  // A jet at the middle of the bottom, and what moving grains displace.
  for_each_cell(domain.own(), [&](int i, int j, int k) {
    const Vec3 x = h.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
    double& source = system.source(i, j, k);
    source = x[2] < bed_height ? scatter(k + step, i, j) - 0.5 : 0.0;
    if (k == 0 && std::abs(x[0] - 0.5 * size[0]) < 0.1 * size[0]) source += 10;
  });
}

double norm(const Domain& domain, const Array3<double>& cells) {
  double sum = 0;
  for (const double value : cells) sum += value * value;
  return std::sqrt(domain.comm().sum(sum));
}

double bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// A solver with its own system.
class Contender {
 public:
  Contender(const Domain& domain, PressureMethod method)
      : domain_(domain), system_(domain, sides), solver_(domain, method) {}

  void solve(const Bed& bed, int step) {
    set_bed(domain_, bed, step, system_);
    const double tolerance = relative_tolerance * norm(domain_, system_.source);
    MPI_Barrier(domain_.comm().handle());
    const double start = processor_seconds();
    const int iterations = solver_.solve(system_, tolerance);
    const double seconds = processor_seconds() - start;
    if (step < warm_up) return;
    times_.push_back(1e3 * domain_.comm().max(seconds));
    iterations_ += iterations;
  }
  [[nodiscard]] double iterations() const {
    return iterations_ / static_cast<double>(times_.size());
  }
  // A time a step, the same on all ranks [ms].
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] double sum() const { return std::accumulate(times_.begin(), times_.end(), 0.0); }

 private:
  const Domain& domain_;
  PressureSystem system_;
  PressureSolver solver_;
  std::vector<double> times_;
  double iterations_ = 0;
};

// The median over steps of one's time by another's.
double ratio(const Contender& one, const Contender& other) {
  std::vector<double> ratios;
  for (std::size_t n = 0; n < one.times().size(); ++n)
    ratios.push_back(one.times()[n] / other.times()[n]);
  return median(std::move(ratios));
}

using Contenders = std::array<std::unique_ptr<Contender>, methods.size()>;  // null: left out

// Whether `solves` steps have been measured, and enough of the fastest method.
bool measured(const Contenders& all, int solves) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t done = 0;
  for (const auto& one : all) {
    if (!one) continue;
    done = one->times().size();
    least = std::min(least, one->sum());
  }
  if (done < static_cast<std::size_t>(solves)) return false;
  return least >= least_measured || done >= most_solves;
}

// Bytes a cell of a system and its solver after two solves, alone in memory.
double memory(const Domain& domain, const Bed& bed, PressureMethod method) {
  const double before = bytes_in_use();
  Contender alone(domain, method);
  alone.solve(bed, 0);
  alone.solve(bed, 1);
  return domain.comm().sum(bytes_in_use() - before) /
         static_cast<double>(domain.grid().all().size());
}

struct Point {
  double cells;
  double time;
};

void run(const std::vector<double>& sizes, int solves, const std::vector<std::string>& contrasts) {
  const Communicator comm(MPI_COMM_WORLD);
  const auto say = [&](std::FILE* where, const std::string& text) {
    if (!comm.is_root()) return;
    fmt::print(where, "{}", text);
    std::fflush(where);
  };
  say(stdout,
      fmt::format("at least {} solves and {} ms each on {} rank(s), to {} of the source\n\n",
                  solves, least_measured, comm.size(), relative_tolerance));
  say(stdout,
      "| contrast | cells | method | solves | iterations | ms a solve | ns an iteration and cell | "
      "bytes a cell | time by the best's: median | of sums | time ~ N^ |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Bed& bed : beds) {
    if (!contrasts.empty() &&
        std::find(contrasts.begin(), contrasts.end(), bed.name) == contrasts.end())
      continue;
    std::array<std::vector<Point>, methods.size()> points;
    std::array<bool, methods.size()> hopeless{};
    for (const double size : sizes) {
      const Domain domain(spouted_bed(size), comm);
      const auto cells = static_cast<double>(domain.grid().all().size());
      std::array<double, methods.size()> bytes{};
      for (std::size_t m = 0; m < methods.size(); ++m)
        if (!hopeless[m]) bytes[m] = memory(domain, bed, methods[m].method);
      Contenders all;
      for (std::size_t m = 0; m < methods.size(); ++m)
        if (!hopeless[m]) all[m] = std::make_unique<Contender>(domain, methods[m].method);
      for (int step = 0; !measured(all, solves); ++step) {
        say(stderr,
            fmt::format("\rcontrast {}, {:.0f} cells, step {} ", bed.name, cells, step + 1));
        for (std::size_t n = 0; n < methods.size(); ++n)
          if (auto& one = all[step % 2 == 0 ? n : methods.size() - 1 - n]) one->solve(bed, step);
      }
      say(stderr, "\r\033[K");
      const Contender* best = nullptr;
      for (std::size_t m = 0; m < methods.size(); ++m)
        if (all[m] && methods[m].method != PressureMethod::automatic &&
            (best == nullptr || median(all[m]->times()) < median(best->times())))
          best = all[m].get();
      for (std::size_t m = 0; m < methods.size(); ++m) {
        if (!all[m]) {
          say(stdout, fmt::format("| {} | {:.0f} | {} | | over {} | | | | | | |\n", bed.name, cells,
                                  methods[m].name, too_many_iterations));
          continue;
        }
        const double ms = median(all[m]->times());
        const double iterations = all[m]->iterations();
        points[m].push_back({cells, ms});
        const Point& first = points[m].front();
        const std::string exponent =
            points[m].size() == 1
                ? ""
                : fmt::format("{:.2f}", std::log(ms / first.time) / std::log(cells / first.cells));
        say(stdout,
            fmt::format("| {} | {:.0f} | {} | {} | {:.1f} | {:.2f} | {:.1f} | {:.0f} | "
                        "{:.3f} | {:.3f} | {} |\n",
                        bed.name, cells, methods[m].name, all[m]->times().size(), iterations, ms,
                        1e6 * ms / cells / std::max(1.0, iterations), bytes[m],
                        ratio(*all[m], *best), all[m]->sum() / best->sum(), exponent));
        hopeless[m] = iterations > too_many_iterations;
      }
    }
  }
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  std::vector<double> sizes{5e4, 4e5, 2e6};
  int solves = 9;
  CLI::App app(
      "Pressure solvers against each other: iterations, time and memory, as a Markdown table");
  app.add_flag_callback(
      "--quick", [&] { sizes = {5e4}; }, "the smallest grid only");
  app.add_option("--cells", sizes, "cells of the grids")->capture_default_str();
  app.add_option("--solves", solves, "at least, of which the median is told")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  std::vector<std::string> contrasts;
  std::vector<std::string> names;
  for (const gasgrain::Bed& bed : gasgrain::beds) names.emplace_back(bed.name);
  app.add_option("--contrasts", contrasts, "these alone")->check(CLI::IsMember(names));
  CLI11_PARSE(app, argc, argv);
  gasgrain::run(sizes, solves, contrasts);
  MPI_Finalize();
  return 0;
}
