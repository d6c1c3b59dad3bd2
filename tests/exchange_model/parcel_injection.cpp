// Sources of parcels: their accounts, sizes, places and the words that set them up.
#include <gtest/gtest.h>

#include <algorithm>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/parcels/injection.h"

namespace gasgrain {
namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(' ', at)) != std::string::npos) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

InjectionSettings settings_of(const std::string& text) {
  return parse_injection(split(text), {"water", "oil"}, 2);
}

std::string refusal(const std::string& text) {
  try {
    settings_of(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

BoxGrid box() {
  BoxGrid grid;
  grid.hi = Vec3(0.1, 0.2, 0.4);
  grid.cells = {10, 20, 40};
  return grid;
}

const std::string nozzle =
    "at 0.05 0.1 0.3 direction 0 0 -2 nozzle_radius 2e-3 half_angle 10 speed 5 mass_flow 1e-3 ";
const std::string drops = "size lognormal 5e-5 0.4 liquid 1000 oil 0.25 water 0.75 ";

struct Sums {
  double flow = 0.0;
  std::vector<double> species{0.0, 0.0};
  double solids = 0.0;

  void add(const NewParcel& parcel) {
    for (int s = 0; s < 2; ++s) species[s] += parcel.particles * parcel.film_mass[s];
    solids += parcel.particles * parcel.solid_mass;
  }
};

TEST(injection, brings_the_mass_flow_times_the_time_in_every_way_to_divide_it) {
  for (const char* division : {"particles 300", "parcels_per_second 7000", "parcels_per_step 9"}) {
    const InjectionSettings settings = settings_of(nozzle + drops + division + " from 0.0105");
    Injector injector(settings, box());
    Sums sums;
    const double dt = 1e-3;
    double time = 0.0;
    std::size_t parcels = 0;
    for (int n = 0; n < 500; ++n) {
      time = n * dt;
      for (const NewParcel& parcel : injector.due(time, dt)) {
        sums.add(parcel);
        ++parcels;
      }
    }
    const double brought = 1e-3 * (500 * dt - 0.0105);
    const double injected = sums.species[0] + sums.species[1];
    EXPECT_NEAR((injected + injector.carried(500 * dt)) / brought, 1.0, 1e-12) << division;
    // What has not come in is less than the largest parcel.
    EXPECT_GE(injector.carried(500 * dt), -1e-9 * brought);
    EXPECT_LT(injector.carried(500 * dt), 1e-2 * brought);
    EXPECT_NEAR(injected / injector.account().flow, 1.0, 1e-12);
    EXPECT_NEAR(sums.species[1] / injected, 0.25, 1e-12);
    EXPECT_NEAR(injector.account().species[0] / sums.species[0], 1.0, 1e-12);
    EXPECT_NEAR(injector.account().solids / sums.solids, 1.0, 1e-12);
    EXPECT_EQ(injector.account().parcels, static_cast<double>(parcels));
    EXPECT_GT(parcels, 1000U);
  }
}

TEST(injection, ends_with_all_of_its_mass) {
  for (const char* division : {"particles 333", "parcels_per_second 777", "parcels_per_step 3"}) {
    Injector injector(settings_of(nozzle + drops + division + " from 0.01 to 0.0755"), box());
    Sums sums;
    for (int n = 0; n < 100; ++n)
      for (const NewParcel& parcel : injector.due(n * 1e-3, 1e-3)) sums.add(parcel);
    EXPECT_NEAR((sums.species[0] + sums.species[1]) / (1e-3 * 0.0655), 1.0, 1e-12) << division;
  }
}

TEST(injection, does_the_same_in_steps_of_another_size_and_after_a_restart) {
  const InjectionSettings settings = settings_of(nozzle + drops + "parcels_per_second 5000");
  const double end = 0.04;
  const auto run = [&](int steps, int restart_at) {
    Injector injector(settings, box());
    std::vector<NewParcel> all;
    const double dt = end / steps;
    for (int n = 0; n < steps; ++n) {
      if (n == restart_at) {
        Injector next(settings, box());
        next.set_state(injector.state());
        injector = next;
      }
      // To where they are at the end of the run.
      for (NewParcel parcel : injector.due(n * dt, dt)) {
        parcel.position += (end - (n + 1) * dt) * parcel.velocity;
        all.push_back(parcel);
      }
    }
    return all;
  };
  const auto coarse = run(10, -1);
  const auto fine = run(80, 33);
  ASSERT_EQ(coarse.size(), 200U);
  ASSERT_EQ(fine.size(), coarse.size());
  for (std::size_t p = 0; p < fine.size(); ++p) {
    EXPECT_EQ(fine[p].velocity, coarse[p].velocity);
    EXPECT_LT((fine[p].position - coarse[p].position).norm(), 1e-12);
    EXPECT_NEAR(fine[p].particles / coarse[p].particles, 1.0, 1e-9);
  }
  EXPECT_THROW(Injector(settings, box()).set_state({1.0, 2.0}), Error);
}

TEST(injection, spreads_parcels_along_their_way_within_the_nozzle_and_its_cone) {
  Injector injector(settings_of(nozzle + drops + "parcels_per_step 500"), box());
  std::vector<double> along;
  for (const NewParcel& parcel : injector.due(0.0, 2e-3)) {
    const Vec3 from = parcel.position - Vec3(0.05, 0.1, 0.3);
    EXPECT_NEAR(parcel.velocity.norm(), 5.0, 1e-12);
    EXPECT_GE(-parcel.velocity.z() / 5.0, std::cos(10.0 * M_PI / 180.0) - 1e-12);
    const double since = from.z() / parcel.velocity.z();
    EXPECT_LE((from - since * parcel.velocity).norm(), 2e-3 * (1.0 + 1e-9));
    along.push_back(since);
  }
  ASSERT_EQ(along.size(), 500U);
  // Evenly over the step: one after the other at the same distance.
  for (std::size_t p = 1; p < along.size(); ++p)
    EXPECT_NEAR(along[p - 1] - along[p], 2e-3 / 500, 1e-9);
}

TEST(injection, draws_sizes_by_their_share_of_the_mass) {
  const auto finer = [](const SizeDistribution& size, double radius) {
    int count = 0;
    for (int n = 0; n < 10000; ++n) count += size.quantile((n + 0.5) / 10000) <= radius;
    return count / 10000.0;
  };
  // The cuts move a share by 0.3 % at most.
  const auto lognormal = settings_of(nozzle + drops + "particles 1").size;
  EXPECT_NEAR(finer(lognormal, 5e-5), 0.5, 0.003);
  EXPECT_NEAR(finer(lognormal, 5e-5 * std::exp(0.4)), 0.8413, 0.003);
  const auto rosin =
      settings_of(nozzle + "size rosin_rammler 5e-5 2.5 solid 2500 particles 1").size;
  EXPECT_NEAR(finer(rosin, 5e-5), 1.0 - std::exp(-1.0), 0.003);
  EXPECT_NEAR(finer(rosin, 3e-5), 1.0 - std::exp(-std::pow(0.6, 2.5)), 0.003);
  const auto list = settings_of(nozzle + "size list 1e-4 1 2e-4 3 solid 2500 particles 1").size;
  EXPECT_NEAR(finer(list, 1e-4), 0.25, 1e-4);
  EXPECT_NEAR(finer(list, 2e-4), 1.0, 1e-12);
}

// A layer as thick as a step's way, of the fraction that is fed, even over the face.
TEST(injection, of_a_face_feeds_its_volume_fraction) {
  const InjectionSettings settings = settings_of(
      "face y_hi rectangle 0.02 0.08 0.1 0.3 fraction 0.2 speed 1 size constant 5e-5 solid 2500 "
      "parcels_per_step 4000");
  Injector injector(settings, box());
  EXPECT_NEAR(injector.mass_flow(), 0.2 * 2500.0 * 0.06 * 0.2, 1e-12);
  double volume = 0.0;
  std::vector<int> count(12, 0);
  for (const NewParcel& parcel : injector.due(0.0, 0.01)) {
    volume += parcel.particles * parcel.solid_volume;
    EXPECT_EQ(parcel.velocity, Vec3(0.0, -1.0, 0.0));
    EXPECT_GE(parcel.position.y(), 0.2 - 0.01 - 1e-12);
    EXPECT_LE(parcel.position.y(), 0.2 + 1e-12);
    const int i = static_cast<int>((parcel.position.x() - 0.02) / 0.02);
    const int k = static_cast<int>((parcel.position.z() - 0.1) / 0.05);
    ++count[static_cast<std::size_t>(std::clamp(i, 0, 2) * 4 + std::clamp(k, 0, 3))];
  }
  EXPECT_NEAR(volume / (0.06 * 0.2 * 0.01), 0.2, 1e-10);
  // 333 in each of 12 parts, where random places would scatter by 18.
  for (const int n : count) EXPECT_NEAR(n, 4000 / 12, 6);
}

TEST(injection, makes_droplets_on_a_vanishing_core) {
  Injector injector(settings_of(nozzle + "size constant 5e-5 liquid 800 oil 1 particles 100"),
                    box());
  const auto list = injector.due(0.0, 0.01);
  ASSERT_FALSE(list.empty());
  const double volume = 4.0 / 3.0 * M_PI * std::pow(5e-5, 3);
  EXPECT_NEAR(list[0].film_mass[1] / (800.0 * volume), 1.0, 1e-12);
  EXPECT_EQ(list[0].film_mass[0], 0.0);
  EXPECT_NEAR(list[0].solid_volume / (4.0 / 3.0 * M_PI * 1e-30), 1.0, 1e-12);
  EXPECT_NEAR(list[0].particles, 100.0, 1e-9);
}

TEST(injection, refuses_what_it_cannot_do_and_tells_all_at_once) {
  const std::string text = refusal(
      "at 0 0 0 direction 0 0 0 speeed 3 size lognormol 1e-4 0.2 liquid 1000 water 0.5 "
      "particles 10 parcels_per_second 3 type 7 fraction 0.2");
  for (const char* part : {"direction 0 0 0", "Did you mean \"speed\"",
                           "Did you mean \"lognormal\"", "add up to 0.5, not 1", "divided already",
                           "2 atom types", "belongs to a face", "mass_flow is missing"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  EXPECT_NE(refusal(nozzle + "size constant 5e-5 particles 10").find("what enters is not said"),
            std::string::npos);
  EXPECT_NE(refusal(nozzle + drops).find("parcels_per_step"), std::string::npos);
  EXPECT_NE(refusal(nozzle + drops + "particles 1 from 2 to 1").find("must be after"),
            std::string::npos);
  EXPECT_NE(refusal(nozzle + drops + "particles 1 core 4e-6 2500").find("hardly larger"),
            std::string::npos);
  EXPECT_THROW(Injector(settings_of("face x_lo rectangle 0 0.3 0 0.1 fraction 0.1 speed 1 "
                                    "size constant 1e-4 solid 1000 particles 1"),
                        box()),
               Error);
}

TEST(injection, is_refused_where_close_packing_is_below_the_feed) {
  const InjectionSettings feed =
      settings_of("face x_lo fraction 0.62 speed 1 size constant 1e-4 solid 1000 particles 1");
  ParcelSettings parcels;
  parcels.close_packing = 0.6;
  EXPECT_NE(feed_fault(parcels, feed).find("raise close_packing"), std::string::npos);
  parcels.close_packing = 0.63;
  EXPECT_EQ(feed_fault(parcels, feed), "");
}

}  // namespace
}  // namespace gasgrain
