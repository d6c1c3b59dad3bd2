// What a contact law may ask of its host when a run begins: the script's properties, the grains,
// how far the host looks, the scene's liquid; and how it warns and refuses. One object for each
// pair style and each wall that names the law; none of it is for the loop over contacts.
#pragma once

#include <fmt/format.h>
#include <mpi.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact/pair_table.h"

namespace gasgrain::liquid {
class SceneLiquid;
}

namespace gasgrain::contact {

// One value for each grain that the host keeps. The host moves them when it makes place for more
// grains, so they are reached through where it keeps their address.
struct GrainScalar {
  const double* const* values = nullptr;
  bool on_ghosts = false;  // whether the host can send them there

  explicit operator bool() const { return values != nullptr; }
  double operator[](int grain) const { return (*values)[grain]; }
};

// How a user of this host writes such values: for messages.
struct GrainScalarLines {
  std::string make;  // the quoted line that makes them, or several with 'or' between
  std::string set;   // the quoted line that sets those of a group
  std::string send;  // what to do where they are not sent to the ghosts
};

class ContactHost {
 public:
  // `law` as the script names it, such as 'cohesion jkr'.
  explicit ContactHost(std::string law) : law_(std::move(law)) {}
  virtual ~ContactHost() = default;
  ContactHost(const ContactHost&) = delete;
  ContactHost& operator=(const ContactHost&) = delete;

  [[nodiscard]] const std::string& law() const { return law_; }

  // Properties of the script's `fix property/global`; nothing where it has none in this form.
  [[nodiscard]] virtual int types() const = 0;
  [[nodiscard]] virtual std::optional<PairTable<double>> pairs(const char* name) const = 0;
  [[nodiscard]] virtual std::optional<std::vector<double>> per_type(  // from [1]
      const char* name) const = 0;
  [[nodiscard]] virtual std::optional<double> scalar(const char* name) const = 0;
  [[nodiscard]] virtual std::vector<std::string> property_names() const = 0;
  // The same, or an end with the line to add and the nearest name that the script has.
  [[nodiscard]] PairTable<double> need_pairs(const char* name, const char* unit) const;
  [[nodiscard]] std::vector<double> need_per_type(const char* name, const char* unit) const;
  [[nodiscard]] double need_scalar(const char* name, const char* unit) const;
  [[noreturn]] void refuse_missing(const char* name, const std::string& lines) const;

  // Where the law stands.
  [[nodiscard]] virtual bool is_wall() const = 0;
  [[nodiscard]] virtual std::string wall_id() const = 0;  // '' of a pair style
  [[nodiscard]] virtual bool normal_model_is(const char* name) const = 0;
  // The law's own values begin here in the row that the host keeps of a contact; below 0: none.
  [[nodiscard]] virtual int history_offset() const = 0;

  // The grains. Collective: the radii of all ranks [m].
  [[nodiscard]] virtual double smallest_radius() const = 0;
  [[nodiscard]] virtual double largest_radius() const = 0;
  [[nodiscard]] virtual int grains() const = 0;  // of this rank
  [[nodiscard]] virtual const double* radii() const = 0;
  // Where the host keeps the grains' numbers: for what must not depend on who is i and who is j.
  [[nodiscard]] virtual const int* const* numbers() const = 0;
  // `q` is the charge of an atom style that has one.
  [[nodiscard]] virtual GrainScalar grain_scalar(const char* name) const = 0;
  [[nodiscard]] virtual GrainScalarLines grain_scalar_lines(const char* name) const = 0;
  // To the ghosts. Collective.
  virtual void send_to_ghosts(const GrainScalar& scalar) = 0;

  // The run.
  [[nodiscard]] virtual std::int64_t step() const = 0;
  [[nodiscard]] virtual double timestep() const = 0;
  [[nodiscard]] virtual MPI_Comm communicator() const = 0;
  [[nodiscard]] virtual liquid::SceneLiquid& liquid() = 0;

  // Asks the host to show bodies up to this gap [m] of the smallest grains; `greatest` is that of
  // the largest, which a host checks against what it sees of a wall. Without this it shows what
  // touches.
  virtual void reach(double gap_of_smallest, double greatest) = 0;
  void reach(double gap) { reach(gap, gap); }

  // Ends where grains stand for many; and where the script's units are not SI.
  virtual void refuse_coarse_grains() const = 0;
  virtual void refuse_unfit_run() const = 0;
  // Ends the launch; called by all ranks.
  [[noreturn]] void refuse(const std::string& why) const;
  virtual void warn(const std::string& text) const = 0;            // of all ranks, written once
  virtual void warn_from_here(const std::string& text) const = 0;  // of this rank

 protected:
  // Does not return.
  virtual void end_launch(const std::string& message) const = 0;

 private:
  std::string law_;
};

// A law for each pair of types, `make(i, j)`, each one checked by the law's own check(); all faults
// come as one message, which says of which property they are; `faults` are those found before.
template <class Make>
auto checked_laws(const ContactHost& host, const std::string& source, Make make,
                  std::string faults = "") {
  using Law = decltype(make(1, 1));
  PairTable<Law> laws(host.types());
  for (int i = 1; i <= host.types(); ++i)
    for (int j = 1; j <= host.types(); ++j) {
      try {
        laws(i, j) = make(i, j);
        if (j >= i) check(laws(i, j));
      } catch (const Error& error) {
        if (j >= i)
          faults += fmt::format("\nTypes {} and {}, from {}: {}", i, j, source, error.what());
      }
    }
  if (!faults.empty()) host.refuse(faults);
  return laws;
}

}  // namespace gasgrain::contact
