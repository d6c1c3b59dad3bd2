// A stack of contact laws behind one interface, so that a host chooses it by name once and calls
// its loops as a whole; inside of a loop nothing is virtual.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "fix_cfd_coupling/dem_physics/contact/batch_loop.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_loop.h"
#include "fix_cfd_coupling/dem_physics/contact/instruction_set.h"

namespace gasgrain::contact {

// As scripts write them; 'off' where there is none.
struct StackName {
  std::string normal, tangential, rolling = "off", cohesion = "off";

  [[nodiscard]] auto parts() const { return std::tie(cohesion, normal, tangential, rolling); }
  bool operator<(const StackName& other) const { return parts() < other.parts(); }
};

// The host that a law is connected to: its name as of errors, and where its history begins.
using HostOfLaw = std::function<ContactHost&(const std::string& law, int history_offset)>;

class ContactStack {
 public:
  virtual ~ContactStack() = default;

  // Of a row of the history, in its order.
  [[nodiscard]] virtual std::vector<HistoryValue> history() const = 0;
  // Before connect(): cohesion's values come first in the rows, as LIGGGHTS has them, not last.
  virtual void put_cohesion_first() = 0;
  virtual void words(LawWords& words) = 0;
  virtual void connect(const StackName& name, const HostOfLaw& host_of) = 0;
  virtual void set_reach(const Reach& reach) = 0;
  // Of pairs() and wall(); that of the machine unless said. Portable where the laws do not fit
  // lanes.
  virtual void set_instructions(InstructionSet set) = 0;
  [[nodiscard]] virtual InstructionSet instructions() const = 0;
  [[nodiscard]] virtual bool has_cohesion() const = 0;

  virtual void begin_pass() = 0;
  virtual void pairs(const Grains& grains, const NeighbourList& list, const ContactRows& rows,
                     ContactObserver* observer) = 0;
  virtual void wall(const Grains& grains, const WallNeighbours& near, const PrimitiveWall& shape,
                    int type, ContactObserver* observer) = 0;
  // One pair alone; false: nothing acts.
  virtual bool pair(const Grains& grains, int i, int j, const Triple& delta, int* use, double* row,
                    Push& push) = 0;
};

template <class Normal, class Tangential, class Rolling, class Cohesion>
class CompiledStack final : public ContactStack {
  using Laws = ContactLaws<Normal, Tangential, Rolling, Cohesion>;

 public:
  explicit CompiledStack(bool of_wall) : of_wall_(of_wall) {
    arrange(0);
    CompiledStack::set_instructions(chosen_instruction_set());
  }

  [[nodiscard]] std::vector<HistoryValue> history() const override {
    std::vector<HistoryValue> all = Tangential::history();
    for (const auto& value : Rolling::history(of_wall_)) all.push_back(value);
    const auto of_cohesion = Cohesion::history(of_wall_);
    const auto place = loop_.laws.places.cohesion == 0 ? all.begin() : all.end();
    all.insert(place, of_cohesion.begin(), of_cohesion.end());
    return all;
  }
  void put_cohesion_first() override {
    arrange(static_cast<int>(Cohesion::history(of_wall_).size()));
  }
  void words(LawWords& words) override {
    loop_.laws.normal.words(words);
    loop_.laws.tangential.words(words);
    loop_.laws.rolling.words(words);
    loop_.laws.cohesion.words(words);
  }
  void connect(const StackName& name, const HostOfLaw& host_of) override {
    Laws& laws = loop_.laws;
    laws.normal.connect(host_of("model " + name.normal, -1));
    laws.tangential.connect(host_of("tangential " + name.tangential, laws.places.tangential));
    if (Laws::has_rolling)
      laws.rolling.connect(host_of("rolling_friction " + name.rolling, laws.places.rolling));
    if (Laws::has_cohesion)
      laws.cohesion.connect(host_of("cohesion " + name.cohesion, Cohesion::history(of_wall_).empty()
                                                                     ? -1
                                                                     : laws.places.cohesion));
  }
  void set_reach(const Reach& reach) override { loop_.reach = reach; }
  [[nodiscard]] bool has_cohesion() const override { return Laws::has_cohesion; }

  void begin_pass() override { loop_.laws.cohesion.begin_pass(); }
  void pairs(const Grains& grains, const NeighbourList& list, const ContactRows& rows,
             ContactObserver* observer) override {
#ifdef GASGRAIN_LANES
    if constexpr (Laws::fit_lanes) {
      if (instructions_ == InstructionSet::avx512)
        return pairs_in_lanes<Avx512>(loop_.laws, queues(), grains, list, rows, observer);
      if (instructions_ == InstructionSet::avx2)
        return pairs_in_lanes<Avx2>(loop_.laws, queues(), grains, list, rows, observer);
    }
#endif
    loop_.pairs(grains, list, rows, observer);
  }
  void set_instructions(InstructionSet set) override {
    if (Laws::fit_lanes) instructions_ = set;
  }
  [[nodiscard]] InstructionSet instructions() const override {
    return instructions_;
  }
  void wall(const Grains& grains, const WallNeighbours& near, const PrimitiveWall& shape, int type,
            ContactObserver* observer) override {
#ifdef GASGRAIN_LANES
    if constexpr (Laws::fit_lanes) {
      if (instructions_ == InstructionSet::avx512)
        return wall_in_lanes<Avx512>(loop_.laws, queues(), grains, near, shape, type, observer);
      if (instructions_ == InstructionSet::avx2)
        return wall_in_lanes<Avx2>(loop_.laws, queues(), grains, near, shape, type, observer);
    }
#endif
    loop_.wall(grains, near, shape, type, observer);
  }
  bool pair(const Grains& grains, int i, int j, const Triple& delta, int* use, double* row,
            Push& push) override {
    return loop_.pair(grains, i, j, delta, delta.dot(delta), use, row, push);
  }

 private:
  void arrange(int tangential) {
    HistoryPlaces& places = loop_.laws.places;
    places.tangential = tangential;
    places.rolling = tangential + static_cast<int>(Tangential::history().size());
    places.touch_end = places.rolling + static_cast<int>(Rolling::history(of_wall_).size());
    const int of_cohesion = static_cast<int>(Cohesion::history(of_wall_).size());
    places.cohesion = tangential == of_cohesion ? 0 : places.touch_end;
    places.width = places.touch_end - tangential + of_cohesion;
  }

  ContactQueue* queues() {
    const int types = loop_.laws.tangential.types();
    queues_.resize(loop_.laws.tangential.place(types, types) + 1);
    return queues_.data();
  }

  ContactLoop<Laws> loop_;
  std::vector<ContactQueue> queues_;
  InstructionSet instructions_ = InstructionSet::portable;
  bool of_wall_;
};

}  // namespace gasgrain::contact
