#include "coupling/exchange/ledger.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

constexpr std::array<const char*, 6> sum_names{"given", "taken", "outstanding",
                                               "left",  "free",  "host"};

}  // namespace

Ledger::Ledger(const Effects& effects) : effects_(effects.names()), work_(effects_.size(), 0.0) {}

std::array<const Vec3*, 6> Ledger::sums() const {
  return {&given_, &taken_, &outstanding_, &left_, &free_, &host_};
}

void Ledger::add_taken(const AppliedForces& applied) {
  taken_ += applied.reacting;
  free_ += applied.free;
  host_ += applied.host;
  exchanged_ += applied.exchanged;
  add_work(applied.work);
}

void Ledger::add_work(const std::vector<double>& work) {
  for (std::size_t n = 0; n < work_.size(); ++n) work_[n] += work.at(n);
}

double Ledger::residual() const {
  const double amiss = (given_ - taken_ + outstanding_ + left_).norm();
  if (amiss == 0.0) return 0.0;
  return exchanged_ > 0.0 ? amiss / exchanged_ : std::numeric_limits<double>::infinity();
}

std::vector<std::string> Ledger::idle_effects() const {
  std::vector<std::string> idle;
  for (std::size_t n = 0; n < effects_.size(); ++n)
    if (work_[n] == 0.0) idle.push_back(effects_[n]);
  return idle;
}

std::vector<double> Ledger::values() const {
  std::vector<double> values;
  for (const Vec3* sum : sums()) values.insert(values.end(), sum->data(), sum->data() + 3);
  values.push_back(exchanged_);
  values.insert(values.end(), work_.begin(), work_.end());
  return values;
}

void Ledger::set_values(const std::vector<double>& values) {
  const std::size_t expected = this->values().size();
  if (values.size() != expected)
    fail(
        "the ledger was given {} values of another rank where its effects ask for {}: all "
        "ranks must have the same effects",
        values.size(), expected);
  const double* next = values.data();
  for (Vec3* sum : {&given_, &taken_, &outstanding_, &left_, &free_, &host_}) {
    *sum = Eigen::Map<const Vec3>(next);
    next += 3;
  }
  exchanged_ = *next++;
  work_.assign(next, next + work_.size());
}

std::vector<std::string> Ledger::column_names() const {
  std::vector<std::string> names;
  for (const char* name : sum_names)
    for (const char axis : {'x', 'y', 'z'})
      names.push_back(fmt::format("impulse_{}_{}_Ns", name, axis));
  for (const std::string& effect : effects_)
    names.push_back(fmt::format("impulse_of_{}_Ns", effect));
  names.insert(names.end(), {"impulse_exchanged_Ns", "ledger_residual"});
  return names;
}

std::vector<double> Ledger::column_values() const {
  std::vector<double> values;
  for (const Vec3* sum : sums()) values.insert(values.end(), sum->begin(), sum->end());
  values.insert(values.end(), work_.begin(), work_.end());
  values.insert(values.end(), {exchanged_, residual()});
  return values;
}

std::string Ledger::text() const {
  const auto vector = [](const Vec3& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
  };
  std::string text = fmt::format(
      "impulse exchanged with the gas [N s]: given by it {}, taken by particles {}, outstanding "
      "{}, left with "
      "removed particles {}; exchanged {:.6g}, residual {:.2e}",
      vector(given_), vector(taken_), vector(outstanding_), vector(left_), exchanged_, residual());
  const auto idle = idle_effects();
  if (!idle.empty())
    text += fmt::format(
        "\neffects that are on and did nothing: {}. Remove them from the scene, or look why.",
        fmt::join(idle, ", "));
  return text;
}

}  // namespace gasgrain
