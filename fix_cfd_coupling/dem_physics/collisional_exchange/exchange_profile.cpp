#include "fix_cfd_coupling/dem_physics/collisional_exchange/exchange_profile.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "coupling/base/error.h"
#include "coupling/base/word_reader.h"
#include "fix_cfd_coupling/dem_physics/collisional_exchange/liquid_spread.h"

namespace gasgrain {
namespace {

// Of a cell at close packing, where collisions are without number.
constexpr double greatest_rate = 1e12;  // [1/s]

class Reader : WordReader {
 public:
  explicit Reader(const std::vector<std::string>& words) : WordReader(words) {}

  ProfileSettings read() {
    const auto axis = word("profile", "the line's axis x, y or z");
    const std::vector<std::string> axes{"x", "y", "z"};
    const auto found = std::find(axes.begin(), axes.end(), axis.value_or(""));
    if (found == axes.end())
      fault("profile: the axis of its line must be x, y or z.");
    else
      settings_.axis = static_cast<int>(found - axes.begin());
    settings_.first = number("profile", -1e6, 1e6, "first of the other two coordinates, m");
    settings_.second = number("profile", -1e6, 1e6, "second of the other two coordinates, m");
    read_keywords({{"from", [&] { settings_.from = number("from", 0.0, 1e9, "s of the run"); }},
                   {"file", [&] { settings_.file = word("file", "its name").value_or(""); }}});
    if (settings_.file.empty()) fault("profile: 'file NAME' is missing.");
    throw_faults("fix collisional_exchange");
    return settings_;
  }

 private:
  ProfileSettings settings_;
};

// The other two, in their order.
std::array<int, 2> others(int axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

}  // namespace

std::optional<ProfileSettings> take_profile(std::vector<std::string>& words) {
  const auto at = std::find(words.begin(), words.end(), "profile");
  if (at == words.end()) return std::nullopt;
  // It takes the rest of the line.
  const std::vector<std::string> rest(at + 1, words.end());
  words.erase(at, words.end());
  return Reader(rest).read();
}

ExchangeProfile::ExchangeProfile(const ProfileSettings& settings, const BoxGrid& grid)
    : settings_(settings), grid_(grid), cell_{0, 0, 0} {
  const auto [a, b] = others(settings.axis);
  cell_[a] = grid.cell_of(settings.first, a);
  cell_[b] = grid.cell_of(settings.second, b);
  if (!grid.all().contains(cell_[0], cell_[1], cell_[2]))
    fail("fix collisional_exchange: the line of 'profile' at {:g}, {:g} m is outside of the box.",
         settings.first, settings.second);
  sums_.assign(static_cast<std::size_t>(grid.cells[settings.axis]) * columns, 0.0);
}

void ExchangeProfile::add(const ExchangeView& view, const ExchangeCells& cells,
                          const TileFrame& frame, double time, const SumOverRanks& sum) {
  if (time < settings_.from) return;
  liquid_spread(view, cells, sum, eta_);
  const int axis = settings_.axis;
  const auto [a, b] = others(axis);
  const IndexBox& tile = frame.tile;
  if (cell_[a] < tile.lo[a] || cell_[a] >= tile.hi[a] || cell_[b] < tile.lo[b] ||
      cell_[b] >= tile.hi[b])
    return;
  // The place in the tile of each cell of the line, and back.
  Int3 at = cell_;
  const int first = std::max(0, tile.lo[axis]);
  const int last = std::min(grid_.cells[axis], tile.hi[axis]);
  const auto row = [&](int n) { return sums_.data() + static_cast<std::size_t>(n) * columns; };
  for (int n = first; n < last; ++n) {
    at[axis] = n;
    const auto cell = static_cast<std::size_t>(cells.rms_velocity.offset(at[0], at[1], at[2]));
    if (cells.particle_fraction[cell] == 0.0) continue;
    const double tau = cells.collision_time[cell];
    double* values = row(n);
    values[holders] += 1.0;
    values[equilibrium] += cells.equilibrium_velocity[axis][cell];
    values[rms] += cells.rms_velocity[cell];
    values[rate] += tau > 1.0 / greatest_rate ? 1.0 / tau : greatest_rate;
    values[spread] += eta_[cell];
    values[fraction] += cells.particle_fraction[cell];
  }
  at[axis] = first;
  const std::ptrdiff_t begin = eta_.offset(at[0], at[1], at[2]);
  const std::ptrdiff_t stride = eta_.stride(axis);
  const std::size_t species = cells.species_mass.size();
  for (std::size_t p = 0; p < view.count; ++p) {
    const std::ptrdiff_t along = static_cast<std::ptrdiff_t>(view.cell[p]) - begin;
    if (view.cell[p] == no_cell || along < 0 || along % stride != 0) continue;
    const auto n = first + static_cast<int>(along / stride);
    at[axis] = n;
    if (n >= last || eta_.offset(at[0], at[1], at[2]) != static_cast<std::ptrdiff_t>(view.cell[p]))
      continue;
    double liquid = 0.0;
    for (std::size_t i = 0; i < species; ++i) liquid += view.film_mass[p * species + i];
    if (view.particles != nullptr) liquid *= view.particles[p];
    row(n)[liquid_mass] += liquid;
    row(n)[liquid_momentum] += liquid * view.velocity[3 * p + static_cast<std::size_t>(axis)];
  }
}

void ExchangeProfile::write(const Communicator& ranks) const {
  std::vector<double> sums = sums_;
  ranks.sum_in_place(sums);
  if (!ranks.is_root()) return;
  std::ofstream file(settings_.file);
  file << "position_m,liquid_velocity_m_s,equilibrium_velocity_m_s,rms_velocity_m_s,"
          "collision_time_s,eta,particle_fraction\n";
  const double h = grid_.spacing()[settings_.axis];
  for (int n = 0; n < grid_.cells[settings_.axis]; ++n) {
    const double* values = sums.data() + static_cast<std::size_t>(n) * columns;
    const double times = values[holders];
    const auto mean = [&](Column column) { return times > 0.0 ? values[column] / times : 0.0; };
    file << fmt::format(
        "{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
        grid_.lo[settings_.axis] + (n + 0.5) * h,
        values[liquid_mass] > 0.0 ? values[liquid_momentum] / values[liquid_mass] : 0.0,
        mean(equilibrium), mean(rms), times > 0.0 ? 1.0 / mean(rate) : 0.0, mean(spread),
        mean(fraction));
  }
  file.flush();
  if (!file)
    fail("{} cannot be written: is the folder there, and the disk not full?", settings_.file);
}

}  // namespace gasgrain
