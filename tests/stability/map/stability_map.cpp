// The stability map: schemes over hardness, as CSV on standard output.
//   drag           explicit, semi-implicit in turn, semi-implicit overlapped, over interval /
//                  relaxation time, for two mass loadings: fastest of gas and grains over the
//                  fastest grain at first. stable: not beyond 1; bounded: not beyond 2; else broken
//   void_fraction  every method of the LIST over cell size / diameter: how much the drag on a grain
//                  in a steady stream changes while it moves 0.02 cells sideways across a face,
//                  over its mean. stable: 0.02 at most; bounded: 0.1 at most; else broken
//   coupling       in turn and overlapped, over interval / relaxation time and cells crossed in an
//                  interval: as drag, in 2000 couplings. refused: ended with a message
#include <fmt/format.h>
#include <mpi.h>

#include "coupling/base/file_locks.h"
#include "tests/stability/face_crossing.h"
#include "tests/stability/periodic_cloud.h"

namespace gasgrain::stability {
namespace {

constexpr double broken_beyond = 1e6;

void print_row(const std::string& part, const std::string& scheme, double first, double second,
               double measure, const std::string& verdict) {
  fmt::print("{},{},{:.4g},{:.4g},{:.4g},{}\n", part, scheme, first, second, measure, verdict);
  std::fflush(stdout);
}

std::string verdict_of(double measure, double stable, double bounded) {
  if (measure <= stable) return "stable";
  return measure <= bounded ? "bounded" : "broken";
}

// Fastest of gas and grains over the fastest grain at first.
template <class Bed>
double greatest_growth(Bed& bed, int couplings) {
  const double first = bed.fastest_grain();
  double fastest = first;
  for (int n = 0; n < couplings && fastest < broken_beyond * first; ++n) {
    bed.advance();
    fastest = std::max({fastest, bed.fastest_grain(), gas_cases::greatest_speed(bed.gas())});
  }
  return fastest / first;
}

void print_growth(const std::string& part, const std::string& scheme, double first, double second,
                  double growth) {
  print_row(part, scheme, first, second, growth, verdict_of(growth, 1.0 + 1e-6, 2.0));
}

const std::vector<double> decades{1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0,
                                  3.0,  10.0, 30.0, 1e2,  3e2, 1e3};

void map_drag() {
  for (const double loading : {1.0, 100.0})
    for (const double a : decades) {
      const PeriodicCloud scene({a, loading}, 1.0);
      ExplicitBed naive(scene.input, PeriodicCloud::effects, scene.pace.interval, scene.cloud);
      print_growth("drag", "explicit", a, loading, greatest_growth(naive, 200));
      for (const bool overlapped : {false, true}) {
        Pace pace = scene.pace;
        pace.overlapped = overlapped;
        CoupledBed bed(scene.input, PeriodicCloud::effects, pace, scene.cloud);
        print_growth("drag", overlapped ? "semi-implicit overlapped" : "semi-implicit in turn", a,
                     loading, greatest_growth(bed, 200));
      }
    }
}

void map_void_fraction() {
  for (const double cell :
       {0.2, 0.25, 1.0 / 3, 0.5, 2.0 / 3, 0.8, 1.0, 1.5, 2.0, 2.5, 10.0 / 3, 5.0})
    for_each_choice<VoidFractionMethod>([&](auto method) {
      const int side = std::max(6, static_cast<int>(std::lround(6.0 / cell)));
      const Crossing met = cross_a_face(
          cell, side, "drag schiller_naumann void_fraction " + std::string(method.name));
      print_row("void_fraction", std::string(method.name), cell, met.eps_jump, met.force_jump,
                verdict_of(met.force_jump, 0.02, 0.1));
    });
}

void map_coupling() {
  constexpr double loading = 100.0;
  for (const bool overlapped : {false, true})
    for (const double a : {0.1, 1.0, 10.0, 1e2, 1e3})
      for (const double cells : {0.01, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0}) {
        PeriodicCloud scene({a, loading}, 1.0, cells, 1e300);
        scene.pace.overlapped = overlapped;
        CoupledBed bed(scene.input, PeriodicCloud::effects, scene.pace, scene.cloud);
        const std::string scheme = overlapped ? "overlapped" : "in turn";
        try {
          print_growth("coupling", scheme, a, cells, greatest_growth(bed, 2000));
        } catch (const Error&) {
          print_row("coupling", scheme, a, cells, 0.0, "refused");
        }
      }
}

}  // namespace
}  // namespace gasgrain::stability

int main(int argc, char** argv) {
  gasgrain::open_files_without_semaphores();
  MPI_Init(&argc, &argv);
  fmt::print("part,scheme,hardness,second,measure,verdict\n");
  gasgrain::stability::map_drag();
  gasgrain::stability::map_coupling();
  gasgrain::stability::map_void_fraction();
  MPI_Finalize();
  return 0;
}
