// The audit of a run, coupling/audit.h, on fields whose gradients are known.
#include "coupling/audit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "coupling/audit_report.h"
#include "coupling/exchange/effect_sizes/sizes.h"
#include "tests/exchange_cloud.h"

namespace gasgrain {
namespace {

const GasProperties air{1.2, 1.8e-5};

// Grains in a linear flow u = u0 + G x, gas fields lent or not.
class AuditOfAShearFlow : public testing::Test {
 protected:
  void look(const std::vector<std::string>& words, double slip, int couplings = 1) {
    effects_ = parse_effects(words, "test");
    audit_ = Audit(effects_);
    BoxGrid grid;
    grid.lo = Vec3::Zero();
    grid.hi = Vec3(0.04, 0.04, 0.04);
    grid.cells = {8, 8, 8};
    const TileFrame frame{grid, grid.all()};
    FieldStore fields(effects_.lent(), frame.tile);
    const Vec3 h = grid.spacing();
    for_each_cell(frame.tile, [&](int i, int j, int k) {
      const Vec3 x = Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(h);
      const Vec3 u = Vec3(0.0, 0.0, slip) + gradient_ * x;
      for (int d = 0; d < 3; ++d) fields.vector(GasField::velocity)[d](i, j, k) = u[d];
      fields.scalar(GasField::void_fraction)(i, j, k) = 0.7;
    });
    for (int n = 0; n < 50; ++n)
      cloud_.add(Vec3(0.02 + 0.0001 * n, 0.02, 0.018), Vec3::Zero(), 1e-3,
                 2500.0 * sphere_volume(1e-3));
    ExchangeRecords records(effects_.layout(false));
    records.resize(cloud_.radius.size());
    const ParticleView view = cloud_.view();
    for (std::size_t p = 0; p < view.count; ++p) {
      const Vec3 u = Vec3(0.0, 0.0, slip) + gradient_ * Vec3(view.x(p));
      records.u(p) = u;
      records.K(p) = DragTang::coefficient(air, 0.7, u.norm(), 2e-3);
    }
    for (int n = 0; n < couplings; ++n) audit_.look(view, records, fields, frame, setting_);
  }
  const Audit::Seen& seen(const std::string& name) {
    for (const auto& one : audit_.seen())
      if (one.name == name) return one;
    throw std::runtime_error(name);
  }
  AuditRow row(const std::string& name) {
    const AuditReport report = audit_report(audit_, effects_, setting_, Ledger(effects_));
    for (const auto& one : report.rows)
      if (one.effect == name) return one;
    throw std::runtime_error(name);
  }

  Eigen::Matrix3d gradient_ = Eigen::Matrix3d::Zero();
  Cloud cloud_;
  Effects effects_;
  Audit audit_;
  AuditSetting setting_{air, 9.81, 1e-3, false};
};

TEST_F(AuditOfAShearFlow, finds_the_vorticity_and_acceleration_that_nobody_lends) {
  gradient_(2, 0) = 300.0;  // dw/dx: curl u = -300 e_y, u . grad u = u_x 300 = 0 along x
  gradient_(0, 0) = 20.0;
  gradient_(1, 1) = -20.0;
  look({"drag", "tang"}, 2.0);
  // Differences of a linear field are exact.
  EXPECT_NEAR(audit_.extremes().vorticity, 300.0, 1e-9 * 300.0);
  const Vec3 x(0.02 + 0.0049, 0.02, 0.018);
  const Vec3 u = Vec3(0.0, 0.0, 2.0) + gradient_ * x;
  EXPECT_NEAR(audit_.extremes().gas_acceleration, (gradient_ * u).norm(), 1e-9 * 300.0);
  EXPECT_TRUE(audit_.estimated().has(GasField::vorticity));
  EXPECT_TRUE(audit_.estimated().has(GasField::acceleration));
}

TEST_F(AuditOfAShearFlow, sums_what_the_estimate_says_of_each_grain) {
  gradient_(2, 0) = 300.0;
  look({"drag", "tang"}, 2.0, 3);
  EXPECT_EQ(audit_.couplings(), 3);
  EXPECT_EQ(audit_.grains(), 150.0);
  double sum = 0.0;
  for (std::size_t p = 0; p < cloud_.radius.size(); ++p) {
    Scales at;
    at.diameter = 2e-3;
    at.gas_density = air.density;
    at.viscosity = air.viscosity;
    at.slip = (Vec3(0.0, 0.0, 2.0) + gradient_ * Vec3(cloud_.view().x(p))).norm();
    at.vorticity = 300.0;
    sum += SizeOf<ForceSaffmanMei>::force(at);
  }
  EXPECT_NEAR(seen("saffman_mei").force, 3.0 * sum, 1e-9 * sum);
}

TEST_F(AuditOfAShearFlow, calls_an_effect_wrongly_off_where_it_is_large_and_rightly_where_not) {
  gradient_(2, 0) = 9000.0;  // 30 to 75 m/s where the grains are
  look({"drag", "tang"}, -150.0);
  EXPECT_TRUE(row("saffman_mei").wrong);
  EXPECT_NE(row("saffman_mei").remedy.find("write \"saffman_mei\""), std::string::npos);
  EXPECT_FALSE(row("viscous_stress").wrong);
  EXPECT_NE(row("viscous_stress").text.find("rightly off"), std::string::npos);
  EXPECT_FALSE(row("lorentz").wrong);
}

TEST_F(AuditOfAShearFlow, calls_an_effect_that_is_on_for_nothing_not_worth_its_time) {
  gradient_(2, 0) = 1.0;
  look({"drag", "tang", "rotation_torque"}, 2.0);
  EXPECT_TRUE(row("rotation_torque").wrong);
  EXPECT_NE(row("rotation_torque").remedy.find("take \"rotation_torque\""), std::string::npos);
  EXPECT_FALSE(row("drag").wrong);
}

// A hundredth of the grains must need it: of 50 none is too few, one is enough.
TEST_F(AuditOfAShearFlow, asks_for_an_effect_from_a_hundredth_of_the_grains_on) {
  look({"drag", "tang"}, 2.0);
  EXPECT_EQ(row("polydisperse").often, 0.0);
  EXPECT_FALSE(row("polydisperse").wrong);
  cloud_.radius[49] = 2e-3;
  look({"drag", "tang"}, 2.0);
  EXPECT_GE(row("polydisperse").often, needed_often);
  EXPECT_TRUE(row("polydisperse").wrong);
}

TEST_F(AuditOfAShearFlow, leaves_what_only_the_gas_program_knows_without_a_verdict) {
  look({"drag", "tang"}, 2.0);
  EXPECT_EQ(row("turbulence k_epsilon").state, AuditRow::State::of_gas_program);
  EXPECT_FALSE(row("turbulence k_epsilon").wrong);
}

TEST_F(AuditOfAShearFlow, is_json_that_can_be_read_and_has_every_row) {
  look({"drag", "tang"}, 2.0);
  const AuditReport report = audit_report(audit_, effects_, setting_, Ledger(effects_));
  const auto json = nlohmann::json::parse(report.json());
  EXPECT_EQ(json["effects"].size(), report.rows.size());
  EXPECT_EQ(json["heading"], report.heading);
}

TEST(AuditWithoutDrag, knows_the_grains_only_and_says_so) {
  const Effects effects = parse_effects({"pressure_gradient"}, "test");
  Audit audit(effects);
  BoxGrid grid = uneven_box({false, false, false});
  const TileFrame frame{grid, grid.all()};
  Random random(5);
  const Cloud cloud = random_cloud(grid, 20, random);
  ExchangeRecords records(effects.layout(false));
  records.resize(20);
  const AuditSetting setting{air, 9.81, 1e-3, false};
  audit.look(cloud.view(), records, FieldStore(effects.lent(), frame.tile), frame, setting);
  const AuditReport report = audit_report(audit, effects, setting, Ledger(effects));
  EXPECT_TRUE(report.rows.empty());
  EXPECT_NE(report.heading.find("no gas velocity was lent"), std::string::npos);
  EXPECT_GT(audit.extremes().speed, 0.0);
}

}  // namespace
}  // namespace gasgrain
