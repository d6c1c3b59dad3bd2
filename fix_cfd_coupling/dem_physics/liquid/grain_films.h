// The liquid on grains, and what each of them grants within a step.
//
// All ranks that see a contact must decide alike about its bridge, from numbers that are the same
// everywhere. A step therefore reads the films as they were `published` at its start, on the owner
// and on every copy of a grain, and books changes beside them; owners settle at the end of the
// step. A bridge that wants to form is asked for in one step. At its end each grain knows how much
// of its film was asked for and grants
//   scale  1, or less when more than the whole film was asked for: film_min stays, no film falls
//          below 0
//   open   who may have it: all, none, or (fewer places than askers) the asker of the lowest
//          number; a wall has number 0
// With the next step the bridge forms from the films of that step, or the asking lapses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace gasgrain::liquid {

class GrainFilms {
 public:
  static constexpr double open_to_all = -2.0;
  static constexpr double open_to_none = -1.0;
  static constexpr int no_asker = std::numeric_limits<int>::max();

  // Of a grain, on its owner and on its copies; doubles only, as they are sent.
  struct Published {
    double film;               // [m3]
    double thickness;          // of it [m]
    double scale;              // of what it gives
    double open;               // to the grain of this number, or one of the two above
    double bridges_over_mass;  // of the last step, at least one [1/kg]
    static constexpr int size = 5;
  };
  // Of an owned grain, moves with it.
  struct Grant {
    double scale = 1.0;
    double open = open_to_all;
    double bridges = 0.0;
  };
  // Of an owned grain, in one step.
  struct Tally {
    double change = 0.0;       // of its film [m3]
    double asked_share = 0.0;  // sum of the shares of its film
    int asked = 0;
    int first_asker = no_asker;
    int bridges = 0;
    double bridged = 0.0;  // half of the liquid in its bridges [m3]
  };

  void resize(std::size_t grains) {
    published_.resize(grains);
    grants_.resize(grains);
    tallies_.resize(grains);
  }

  void publish(int k, double film, double radius, double mass) {
    constexpr double sphere = 4.0 * 3.14159265358979323846;
    const Grant& grant = grants_[at(k)];
    published_[at(k)] = {film, film / (sphere * radius * radius), grant.scale, grant.open,
                         std::max(1.0, grant.bridges) / mass};
    tallies_[at(k)] = {};
  }
  [[nodiscard]] const Published& published(int k) const { return published_[at(k)]; }
  Published& published(int k) { return published_[at(k)]; }
  [[nodiscard]] const Tally& tally(int k) const { return tallies_[at(k)]; }
  Grant& grant(int k) { return grants_[at(k)]; }

  [[nodiscard]] bool has_place_for(int k, double number) const {
    const double open = published_[at(k)].open;
    return open == open_to_all || open == number;
  }

  // Of owned grains only:
  void ask(int k, double share, int number) {
    Tally& t = tallies_[at(k)];
    t.asked_share += share;
    ++t.asked;
    t.first_asker = std::min(t.first_asker, number);
  }
  void change(int k, double volume) { tallies_[at(k)].change += volume; }
  void count_bridge(int k, double volume) {
    ++tallies_[at(k)].bridges;
    tallies_[at(k)].bridged += 0.5 * volume;
  }
  void count_wall_bridge(int k, double volume) {
    ++tallies_[at(k)].bridges;
    tallies_[at(k)].bridged += volume;
  }

  // The film after the step. most_bridges: 0 for no limit.
  double settle(int k, double film, int most_bridges) {
    const Tally& t = tallies_[at(k)];
    // A few roundings below 1 / share: the sum of what is given must not pass the film.
    const double scale =
        t.asked_share > 1.0
            ? (1.0 - 4.0 * t.asked * std::numeric_limits<double>::epsilon()) / t.asked_share
            : 1.0;
    grants_[at(k)] = {scale, places(t, most_bridges), static_cast<double>(t.bridges)};
    return film + t.change;
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  static double places(const Tally& t, int most_bridges) {
    if (most_bridges == 0) return open_to_all;
    if (t.bridges >= most_bridges) return open_to_none;
    if (t.bridges + t.asked <= most_bridges) return open_to_all;
    return t.first_asker;
  }

  std::vector<Published> published_;
  std::vector<Grant> grants_;
  std::vector<Tally> tallies_;
};

}  // namespace gasgrain::liquid
