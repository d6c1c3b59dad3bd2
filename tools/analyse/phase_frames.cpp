#include "tools/analyse/phase_frames.h"

#include <limits>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

std::array<std::string, 3> columns_of(const std::string& name) {
  if (name.rfind("f_", 0) == 0 || name.rfind("c_", 0) == 0 || name.rfind("v_", 0) == 0)
    return {name + "[1]", name + "[2]", name + "[3]"};
  return {name + "x", name + "y", name + "z"};
}

bool has_column(const DumpFrame& frame, const std::string& name) {
  try {
    static_cast<void>(frame.column(name));
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::string ForceColumns::text() const {
  if (names[0].empty())
    return "none: the dumps have neither f_mean[1] f_mean[2] f_mean[3] nor fx fy fz, so that there "
           "is no DEM rate and no omega";
  if (is_mean)
    return fmt::format("{} {} {}, the means over all steps", names[0], names[1], names[2]);
  return fmt::format(
      "{} {} {} of the dumped steps alone: contacts between two dumps are missed. For the mean "
      "over all steps let the script have 'fix mean big ave/atom 1 N N fx fy fz' and dump "
      "f_mean[1] f_mean[2] f_mean[3] every N",
      names[0], names[1], names[2]);
}

ForceColumns force_columns(const DumpFrame& frame, const std::string& wanted) {
  for (const std::string& name : wanted.empty() ? std::vector<std::string>{"f_mean", "f"}
                                                : std::vector<std::string>{wanted}) {
    const auto names = columns_of(name);
    if (!wanted.empty() || has_column(frame, names[0])) {
      for (const auto& column : names) static_cast<void>(frame.column(column));  // throws
      return {names, name.rfind("f_", 0) == 0};
    }
  }
  return {};
}

Phases phases_of(const DumpFrame& frame, const BigGrains& big, const ForceColumns& force) {
  const auto three = [&frame](const std::array<std::string, 3>& names) {
    return std::array<std::size_t, 3>{frame.column(names[0]), frame.column(names[1]),
                                      frame.column(names[2])};
  };
  const auto position = three({"x", "y", "z"});
  const auto velocity = three({"vx", "vy", "vz"});
  const std::size_t radius = frame.column("radius");
  const std::size_t id = frame.column("id");
  const bool has_force = !force.names[0].empty();
  const auto pushed = has_force ? three(force.names) : position;
  const auto vector = [&frame](std::size_t row, const std::array<std::size_t, 3>& columns) {
    return Vec3(frame.value(row, columns[0]), frame.value(row, columns[1]),
                frame.value(row, columns[2]));
  };
  const std::vector<bool> is_big = big.of(frame);
  Phases phases;
  phases.step = frame.step();
  for (std::size_t row = 0; row < frame.size(); ++row) {
    MovingGrain grain{static_cast<int>(frame.value(row, id)), vector(row, position),
                      vector(row, velocity), frame.value(row, radius),
                      Vec3::Constant(std::numeric_limits<double>::quiet_NaN())};
    if (has_force) grain.force = vector(row, pushed);
    (is_big[row] ? phases.big : phases.small).push_back(grain);
  }
  return phases;
}

}  // namespace gasgrain
