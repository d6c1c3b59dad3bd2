// What the void-fraction methods of the LIST are worth: Markdown tables of their error against the
// exact one, and of their time, over the size of cells l against the particles' diameter d.
//
//   void_fraction_bench [--csv FILE] [--phi SHARE...] [--seed N]
//
// Equal spheres in a random packing without walls, 20 d on a side, periodic: spheres at random
// points are pushed apart until none overlap. The grid is laid over it at several random places, so
// that large cells, too, are counted in hundreds. Errors are eps - eps_exact over all cells; the
// spread is the standard deviation of eps about its mean. A method whose eps falls below zero
// cannot do cells so small. Time is that of the processor, for weights and deposit, the least of
// several runs, over the number of particles: part of that of kernel and particle_grid goes with
// the number of cells.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <memory>

#include "tests/random_packing.h"

namespace gasgrain {
namespace {

constexpr double side = 20.0;  // of the packing, in diameters
constexpr std::array<int, 16> cells_along_side{100, 80, 60, 50, 40, 30, 25, 20,
                                               15,  13, 10, 8,  6,  4,  3,  2};
constexpr int enough_cells = 2000;
constexpr int most_placements = 25;
constexpr int least_runs = 8;  // of a method, on a size of cells, in a sweep
constexpr int sweeps = 5;      // spread in time: the processor is slower for seconds on end

struct Row {
  std::string_view method;
  double phi;
  double cell_size;  // in diameters
  double rms_error;
  double greatest_error;
  double spread;
  double least;
  double share_below_zero;  // of the cells
  double cells_per_particle;
  double time;  // of a particle, s
};

BoxGrid periodic_grid(int along) {
  BoxGrid grid;
  grid.hi = Vec3::Constant(side);
  grid.cells = {along, along, along};
  grid.periodic = {true, true, true};
  return grid;
}

Cloud moved_cloud(const std::vector<Vec3>& points, const Vec3& shift) {
  Cloud cloud;
  for (const Vec3& x : points) cloud.add(wrapped_into(x + shift, side), Vec3::Zero(), 0.5);
  return cloud;
}

// What a stencil put beyond a periodic side belongs to the cell at the other.
std::vector<double> void_fraction(const Array3<double>& solids, const BoxGrid& grid) {
  const int n = grid.cells[0];
  std::vector<double> eps(grid.all().size(), 1.0);
  const auto wrap = [&](int i) { return static_cast<std::size_t>(((i % n) + n) % n); };
  const IndexBox& box = solids.box();
  for (int k = box.lo[2]; k < box.hi[2]; ++k)
    for (int j = box.lo[1]; j < box.hi[1]; ++j)
      for (int i = box.lo[0]; i < box.hi[0]; ++i)
        eps[wrap(i) + n * (wrap(j) + n * wrap(k))] -= solids(i, j, k) / grid.cell_volume();
  return eps;
}

double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Row measure(const VoidFractionMethod& method, double phi, int along,
            const std::vector<Vec3>& points, unsigned seed) {
  const BoxGrid grid = periodic_grid(along);
  const TileFrame frame{grid, grid.all().grown(stencil_reach(method, 0.5, grid)[0] + 1)};
  const int exact_halo = stencil_reach(VoidFractionExact{}, 0.5, grid)[0] + 1;
  const TileFrame exact_frame{grid, grid.all().grown(exact_halo)};
  const int placements =
      std::clamp(enough_cells / static_cast<int>(grid.all().size()), 1, most_placements);

  Row row{name_of(method), phi, side / along, 0, 0, 0, 1, 0, 0, 1e300};
  Random random(seed);
  ParticleWeights weights;
  Array3<double> solids(frame.tile);
  Array3<double> exact_solids(exact_frame.tile);
  const double mean =
      1.0 - static_cast<double>(points.size()) * sphere_volume(0.5) / (side * side * side);
  double cells = 0.0;
  for (int placement = 0; placement < placements; ++placement) {
    const Cloud cloud = moved_cloud(points, random.vector(Vec3::Zero(), Vec3::Constant(side)));
    weights.find(cloud.view(), VoidFractionExact{}, exact_frame);
    std::fill(exact_solids.begin(), exact_solids.end(), 0.0);
    deposit_solid_volume(cloud.view(), weights, exact_solids);
    const std::vector<double> exact = void_fraction(exact_solids, grid);

    for (int repeat = 0; repeat < std::max(3, least_runs / placements); ++repeat) {
      std::fill(solids.begin(), solids.end(), 0.0);
      const double start = seconds();
      weights.find(cloud.view(), method, frame);
      deposit_solid_volume(cloud.view(), weights, solids);
      row.time = std::min(row.time, (seconds() - start) / static_cast<double>(points.size()));
    }
    row.cells_per_particle =
        static_cast<double>(weights.entries()) / static_cast<double>(points.size());
    const std::vector<double> eps = void_fraction(solids, grid);
    for (std::size_t n = 0; n < eps.size(); ++n) {
      const double error = eps[n] - exact[n];
      row.rms_error += error * error;
      row.greatest_error = std::max(row.greatest_error, std::abs(error));
      row.spread += (eps[n] - mean) * (eps[n] - mean);
      row.least = std::min(row.least, eps[n]);
      row.share_below_zero += eps[n] < -1e-12 ? 1.0 : 0.0;
    }
    cells += static_cast<double>(eps.size());
  }
  row.rms_error = std::sqrt(row.rms_error / cells);
  row.spread = std::sqrt(row.spread / cells);
  row.share_below_zero /= cells;
  return row;
}

void write_csv(std::FILE* file, const std::vector<Row>& rows) {
  for (const Row& row : rows)
    fmt::print(file, "{},{},{:.4g},{:.3e},{:.3e},{:.4g},{:.4g},{:.3g},{:.4g},{:.4g}\n", row.method,
               row.phi, row.cell_size, row.rms_error, row.greatest_error, row.spread, row.least,
               row.share_below_zero, row.cells_per_particle, row.time * 1e9);
}

std::string error_entry(const Row& row) {
  std::string text = fmt::format("{:.2g} ({:.2g})", row.rms_error, row.greatest_error);
  if (row.share_below_zero > 0.0)
    text += fmt::format("; eps < 0 in {:.2g} %", 100.0 * row.share_below_zero);
  return text;
}

std::string spread_entry(const Row& row) {
  return fmt::format("{:.2g} ({:.2g})", row.spread, std::abs(row.least) < 1e-12 ? 0.0 : row.least);
}

std::string time_entry(const Row& row) {
  return fmt::format("{:.0f}", row.time * 1e9);
}

// A row a size of cells, a column a method.
template <class Entry>
void print_table(const std::string& title, const std::vector<Row>& rows, Entry&& entry,
                 bool with_exact) {
  std::vector<std::string> names = choice_names<VoidFractionMethod>();
  if (!with_exact)
    names.erase(std::find(names.begin(), names.end(), std::string(VoidFractionExact::name)));
  fmt::print("phi = {}: {}\n\n| l / d |", rows.front().phi, title);
  for (const auto& name : names) fmt::print(" `{}` |", name);
  fmt::print("\n|---|");
  for (std::size_t n = 0; n < names.size(); ++n) fmt::print("---|");
  for (const int along : cells_along_side) {
    fmt::print("\n| {:.2g} |", side / along);
    for (const auto& name : names) {
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
        return r.method == name && r.cell_size == side / along;
      });
      fmt::print(" {} |", entry(*row));
    }
  }
  fmt::print("\n\n");
}

void print_markdown(const std::vector<Row>& rows) {
  print_table("rms error (greatest error)", rows, error_entry, false);
  print_table("spread of eps (least eps)", rows, spread_entry, true);
  print_table("ns for a particle", rows, time_entry, true);
}

}  // namespace
}  // namespace gasgrain

int main(int argc, char** argv) {
  using namespace gasgrain;
  CLI::App app{"error against the exact void fraction, and time, of every method"};
  std::string csv;
  std::vector<double> shares{0.58, 0.2};
  unsigned seed = 1;
  app.add_option("--csv", csv, "file for comma-separated values of the same figures, and more");
  app.add_option("--phi", shares, "solid shares of the packings")->check(CLI::Range(0.001, 0.61));
  app.add_option("--seed", seed, "of the random packing");
  CLI11_PARSE(app, argc, argv);
  try {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
        csv.empty() ? nullptr : std::fopen(csv.c_str(), "w"), &std::fclose);
    if (!csv.empty() && !file) fail("{} cannot be written: is there such a folder?", csv);
    if (file)
      fmt::print(file.get(),
                 "method,phi,cell_by_diameter,rms_error,greatest_error,spread,least_eps,"
                 "share_below_zero,cells_per_particle,ns_per_particle\n");
    for (const double phi : shares) {
      Random random(seed);
      const std::vector<Vec3> points = random_packing(phi, side, random);
      std::vector<Row> rows;
      for (int sweep = 0; sweep < sweeps; ++sweep) {
        std::size_t n = 0;
        for (const int along : cells_along_side)
          for_each_choice<VoidFractionMethod>([&](auto method) {
            const Row row = measure(VoidFractionMethod(method), phi, along, points, seed + 1);
            if (sweep == 0)
              rows.push_back(row);
            else
              rows[n].time = std::min(rows[n].time, row.time);
            ++n;
          });
      }
      print_markdown(rows);
      if (file) write_csv(file.get(), rows);
    }
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
