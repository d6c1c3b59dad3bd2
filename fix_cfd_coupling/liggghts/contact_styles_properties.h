// Reads what a contact sub-model needs from the script's `fix property/global` lines, and refuses
// what is missing or wrong in one message.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/host_error.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace gasgrain {

// One value for each pair of types; types count from 1, as in the script.
template <class Value>
class PairTable {
 public:
  PairTable() = default;
  explicit PairTable(int types) : types_(types), values_((types + 1) * (types + 1)) {}
  Value& operator()(int i, int j) { return values_[i * (types_ + 1) + j]; }
  const Value& operator()(int i, int j) const { return values_[i * (types_ + 1) + j]; }
  [[nodiscard]] int types() const { return types_; }

 private:
  int types_ = 0;
  std::vector<Value> values_;
};

class ContactProperties {
 public:
  // `model` as the script names it, such as 'cohesion jkr'.
  ContactProperties(LAMMPS_NS::LAMMPS& host, std::string model);

  [[nodiscard]] int types() const { return types_; }
  [[nodiscard]] const std::string& model() const { return model_; }

  // Nothing where the script has no such property in this form.
  [[nodiscard]] std::optional<PairTable<double>> pairs(const char* name) const;
  [[nodiscard]] std::optional<std::vector<double>> per_type(const char* name) const;  // from [1]
  [[nodiscard]] std::optional<double> scalar(const char* name) const;

  // The same, or an end with the line to add; `form` is what follows the name in it.
  [[nodiscard]] PairTable<double> need_pairs(const char* name, const char* unit) const;
  [[nodiscard]] std::vector<double> need_per_type(const char* name, const char* unit) const;
  [[nodiscard]] double need_scalar(const char* name, const char* unit) const;

  // Ends where units are not the laws', and, as the host's models do, where grains stand for many.
  void refuse_unfit_run() const;

  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void refuse_missing(const char* name, const std::string& lines) const;

 private:
  LAMMPS_NS::LAMMPS& host_;
  std::string model_;
  int types_;
};

// A law for each pair of types, `make(i, j)`, each one checked by the law's own check(); all faults
// come as one message, which says of which property they are; `faults` are those found before.
template <class Make>
auto checked_laws(const ContactProperties& properties, const std::string& source, Make make,
                  std::string faults = "") {
  using Law = decltype(make(1, 1));
  PairTable<Law> laws(properties.types());
  for (int i = 1; i <= properties.types(); ++i)
    for (int j = 1; j <= properties.types(); ++j) {
      try {
        laws(i, j) = make(i, j);
        if (j >= i) check(laws(i, j));
      } catch (const Error& error) {
        if (j >= i)
          faults += fmt::format("\nTypes {} and {}, from {}: {}", i, j, source, error.what());
      }
    }
  if (!faults.empty()) properties.refuse(faults);
  return laws;
}

}  // namespace gasgrain
