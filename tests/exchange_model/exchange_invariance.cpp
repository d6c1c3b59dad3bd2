// What must not matter to the collisional exchange: the frame, the order of the parcels, how many
// parcels stand for the same particles, and where the zero of the enthalpies is.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "tests/exchange_model/exchange_cases.h"

namespace gasgrain {
namespace {

constexpr int cells = 4;
constexpr std::size_t species = 2;
constexpr double dt = 5e-3;  // [s], of the order of the films' time scale

Parcels parcels_at_first() {
  return random_parcels(cells, 30, species, 41);
}

Parcels stepped(Parcels parcels, const ExchangeSettings& settings = settings_of(species, true)) {
  CollisionalExchange exchange(settings);
  exchange.step(parcels.view(), row_of_cells(cells), cell_volume, dt, on_one_rank);
  return parcels;
}

Parcels with_velocities(Parcels parcels, const Eigen::Matrix3d& turn, const Vec3& shift) {
  for (std::size_t p = 0; p < parcels.count(); ++p) {
    Eigen::Map<Vec3> u(parcels.velocity.data() + 3 * p);
    u = (turn * u + shift).eval();
  }
  return parcels;
}

// tolerance: of velocities [m/s], and of films and temperatures relative to themselves.
void expect_same(const Parcels& is, const Parcels& expected, double tolerance) {
  ASSERT_EQ(is.count(), expected.count());
  for (std::size_t k = 0; k < is.velocity.size(); ++k)
    EXPECT_NEAR(is.velocity[k], expected.velocity[k], tolerance);
  for (std::size_t f = 0; f < is.film_mass.size(); ++f)
    EXPECT_NEAR(is.film_mass[f], expected.film_mass[f], tolerance * expected.film_mass[f]);
  for (std::size_t p = 0; p < is.count(); ++p)
    EXPECT_NEAR(is.film_temperature[p], expected.film_temperature[p],
                tolerance * expected.film_temperature[p]);
}

TEST(exchange_invariance, a_moving_frame_adds_its_velocity_and_changes_nothing_else) {
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  const Vec3 frame(100.0, -30.0, 7.0);
  const Parcels is = stepped(with_velocities(parcels_at_first(), same, frame));
  // Velocities of 100 m/s are known to 1e-14 m/s.
  expect_same(is, with_velocities(stepped(parcels_at_first()), same, frame), 1e-12);
}

TEST(exchange_invariance, turned_velocities_give_turned_velocities_and_the_same_films) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Parcels is = stepped(with_velocities(parcels_at_first(), turn, Vec3::Zero()));
  expect_same(is, with_velocities(stepped(parcels_at_first()), turn, Vec3::Zero()), 1e-13);
}

TEST(exchange_invariance, the_order_of_the_parcels_does_not_matter) {
  const Parcels first = parcels_at_first();
  std::vector<std::size_t> order(first.count());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  const Parcels in_order = stepped(first);
  Parcels shuffled, expected;
  shuffled.species = expected.species = species;
  for (const std::size_t p : order) {
    shuffled.add_from(first, p, first.particles[p]);
    expected.add_from(in_order, p, first.particles[p]);
  }
  expect_same(stepped(shuffled), expected, 1e-13);
}

TEST(exchange_invariance, a_parcel_is_as_many_particles_of_the_same_properties) {
  Parcels few = random_parcels(cells, 10, species, 42);
  Parcels many;
  many.species = species;
  std::vector<std::size_t> parcel_of;
  double theta = 0.0;
  for (std::size_t p = 0; p < few.count(); ++p) {
    few.particles[p] = 1.0 + static_cast<double>(p % 7);
    theta += few.particles[p] * few.solid_volume[p];
  }
  for (std::size_t p = 0; p < few.count(); ++p)
    for (int k = 0; k < few.particles[p]; ++k) {
      many.add_from(few, p, 1.0);
      parcel_of.push_back(p);
    }
  const double volume = theta / cells / 0.2;  // so few particles in a cell so small
  const auto step = [&](Parcels& parcels, bool with_numbers) {
    ExchangeView view = parcels.view();
    if (!with_numbers) view.particles = nullptr;
    CollisionalExchange exchange(settings_of(species, true));
    return exchange.step(view, row_of_cells(cells), volume, dt, on_one_rank);
  };
  const ExchangeReport of_few = step(few, true);
  const ExchangeReport of_many = step(many, false);
  Parcels expected;
  expected.species = species;
  for (const std::size_t p : parcel_of) expected.add_from(few, p, 1.0);
  expect_same(many, expected, 1e-13);
  EXPECT_NEAR(of_few.liquid_moved, of_many.liquid_moved, 1e-12 * of_many.liquid_moved);
  EXPECT_NEAR(of_few.energy_lost, of_many.energy_lost, 1e-12 * of_many.energy_lost);
}

TEST(exchange_invariance, cells_do_not_know_of_each_other) {
  const Parcels first = parcels_at_first();
  const Parcels together = stepped(first);
  for (std::uint32_t c = 0; c < cells; ++c) {
    Parcels alone, expected;
    alone.species = expected.species = species;
    for (std::size_t p = 0; p < first.count(); ++p)
      if (first.cell[p] == c) {
        alone.add_from(first, p, first.particles[p]);
        expected.add_from(together, p, first.particles[p]);
      }
    expect_same(stepped(alone), expected, 0.0);
  }
}

TEST(exchange_invariance, an_exchange_that_has_worked_before_steps_as_a_new_one) {
  const ExchangeSettings settings = settings_of(species, true);
  CollisionalExchange used(settings);
  Parcels other = random_parcels(9, 30, species, 43, 0.8);
  used.step(other.view(), row_of_cells(9), cell_volume, 1.0, on_one_rank);
  Parcels parcels = parcels_at_first();
  used.step(parcels.view(), row_of_cells(cells), cell_volume, dt, on_one_rank);
  expect_same(parcels, stepped(parcels_at_first()), 0.0);
}

}  // namespace
}  // namespace gasgrain
