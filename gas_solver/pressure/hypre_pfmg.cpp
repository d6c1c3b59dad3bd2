#include "gas_solver/pressure/hypre_pfmg.h"

#include <algorithm>
#include <cmath>

namespace gasgrain {
namespace {

// Iterations more than right after the build that are borne before the multigrid is built anew.
constexpr int borne_iterations = 1;
// A build that serves fewer solves than this was not worth keeping: what the last of them lost is
// more than what was saved. For the solves that follow none is kept.
constexpr int solves_worth_keeping = 8;
constexpr int solves_of_fast_change = 32;

// Two cells round an axis are joined by both of their faces, and need no cut.
struct Links {
  double low = 0;    // coefficient between the cell and its low neighbour
  double round = 0;  // and a neighbour across the cut of a periodic axis
};

Links links(const BoxGrid& grid, const PressureSystem& system, int axis, const Int3& at) {
  const Array3<double>& c = system.face_coefficient[axis];
  const auto o = c.offset(at[0], at[1], at[2]);
  const bool first = at[axis] == 0;
  const bool last = at[axis] == grid.cells[axis] - 1;
  Links found;
  if (!first) found.low = c[o];
  if (!grid.periodic[axis]) return found;
  if (grid.cells[axis] == 2) {
    if (last) found.low += c[o + c.stride(axis)];
  } else if (grid.cells[axis] > 2) {
    if (first) found.round = c[o];
    if (last) found.round = c[o + c.stride(axis)];
  }
  return found;
}

}  // namespace

HyprePfmg::HyprePfmg(const Domain& domain) : domain_(domain) {
  HYPRE_Init();
  const MPI_Comm comm = domain.comm().handle();
  HYPRE_StructGridCreate(comm, 3, &grid_);
  Int3 lo = domain.own().lo;
  Int3 hi = domain.own().hi;
  for (int d = 0; d < 3; ++d) --hi[d];  // hypre's boxes hold their upper end
  HYPRE_StructGridSetExtents(grid_, lo.data(), hi.data());
  HYPRE_StructGridAssemble(grid_);

  // A symmetric matrix: the cell and its low neighbours.
  Int3 offsets[4] = {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  HYPRE_StructStencilCreate(3, 4, &stencil_);
  for (int n = 0; n < 4; ++n) HYPRE_StructStencilSetElement(stencil_, n, offsets[n].data());
  HYPRE_StructMatrixCreate(comm, grid_, stencil_, &matrix_);
  HYPRE_StructMatrixSetSymmetric(matrix_, 1);
  HYPRE_StructMatrixInitialize(matrix_);
  for (HYPRE_StructVector* vector : {&source_, &solution_}) {
    HYPRE_StructVectorCreate(comm, grid_, vector);
    HYPRE_StructVectorInitialize(*vector);
    HYPRE_StructVectorSetConstantValues(*vector, 0.0);
    HYPRE_StructVectorAssemble(*vector);
  }
}

HyprePfmg::~HyprePfmg() {
  if (multigrid_ != nullptr) HYPRE_StructPFMGDestroy(multigrid_);
  HYPRE_StructVectorDestroy(source_);
  HYPRE_StructVectorDestroy(solution_);
  HYPRE_StructMatrixDestroy(matrix_);
  HYPRE_StructStencilDestroy(stencil_);
  HYPRE_StructGridDestroy(grid_);
}

// Plane by plane, so that the entries need not be held a second time.
void HyprePfmg::set_matrix(const PressureSystem& system) {
  const IndexBox own = domain_.own();
  constexpr std::size_t entries = 4;
  plane_.resize(entries * own.extent(0) * own.extent(1));
  for (int k = own.lo[2]; k < own.hi[2]; ++k) {
    double* entry = plane_.data();
    IndexBox plane = own;
    plane.lo[2] = k;
    plane.hi[2] = k + 1;
    for_each_cell(plane, [&](int i, int j, int) {
      const Int3 at{i, j, k};
      double& own_value = *entry++;
      own_value = diagonal(system, i, j, k);
      for (int d = 0; d < 3; ++d) {
        const Links to = links(domain_.grid(), system, d, at);
        own_value -= to.round;
        *entry++ = -to.low;
      }
    });
    // Where the solution is known but for a constant, one cell is joined to the value 0, which
    // leaves the preconditioner definite.
    if (system.singular && plane.contains(0, 0, 0)) plane_[0] *= 2.0;
    Int3 hi{own.hi[0] - 1, own.hi[1] - 1, k};
    HYPRE_Int which[entries] = {0, 1, 2, 3};
    HYPRE_StructMatrixSetBoxValues(matrix_, plane.lo.data(), hi.data(), HYPRE_Int{entries}, which,
                                   plane_.data());
  }
  HYPRE_StructMatrixAssemble(matrix_);
}

void HyprePfmg::build() {
  if (multigrid_ != nullptr) HYPRE_StructPFMGDestroy(multigrid_);
  HYPRE_StructPFMGCreate(domain_.comm().handle(), &multigrid_);
  HYPRE_StructPFMGSetMaxIter(multigrid_, 1);
  HYPRE_StructPFMGSetTol(multigrid_, 0.0);
  HYPRE_StructPFMGSetZeroGuess(multigrid_);
  constexpr int red_black_gauss_seidel_symmetric = 2;
  HYPRE_StructPFMGSetRelaxType(multigrid_, red_black_gauss_seidel_symmetric);
  HYPRE_StructPFMGSetNumPreRelax(multigrid_, 1);
  HYPRE_StructPFMGSetNumPostRelax(multigrid_, 1);
  HYPRE_StructPFMGSetSkipRelax(multigrid_, 1);
  constexpr int averaged_seven_point = 1;
  HYPRE_StructPFMGSetRAPType(multigrid_, averaged_seven_point);
  HYPRE_StructPFMGSetup(multigrid_, matrix_, source_, solution_);
  kept_for_ = 0;
}

void HyprePfmg::precondition(const Array3<double>& residual, Array3<double>& correction) {
  Int3 lo = domain_.own().lo;
  Int3 hi{domain_.own().hi[0] - 1, domain_.own().hi[1] - 1, domain_.own().hi[2] - 1};
  // hypre takes what it reads as not const.
  HYPRE_StructVectorSetBoxValues(source_, lo.data(), hi.data(),
                                 const_cast<double*>(residual.data()));
  HYPRE_StructPFMGSolve(multigrid_, matrix_, source_, solution_);
  HYPRE_StructVectorGetBoxValues(solution_, lo.data(), hi.data(), correction.data());
}

int HyprePfmg::solve(PressureSystem& system, ConjugateGradients& gradients, int limit) {
  if (gradients.converged()) return 0;
  set_matrix(system);
  const bool keep = pace_ > 0 && solves_without_keeping_ == 0;
  if (solves_without_keeping_ > 0) --solves_without_keeping_;
  int used = 0;
  if (keep) {
    ++kept_for_;
    const double expected = pace_ * gradients.decades() + borne_iterations;
    used = go_on(system, gradients, std::min(limit, static_cast<int>(std::lround(expected))));
    if (gradients.converged()) return used;
    if (kept_for_ < solves_worth_keeping) solves_without_keeping_ = solves_of_fast_change;
  }
  build();
  const double decades = gradients.decades();
  const int after_build = go_on(system, gradients, limit - used);
  // A pace over less than a decade tells little: the next solve then builds anew.
  pace_ = decades < 1 ? 0 : after_build / decades;
  return used + after_build;
}

int HyprePfmg::go_on(PressureSystem& system, ConjugateGradients& gradients, int limit) {
  const int used = gradients.iterate(
      system, limit, [this](const Array3<double>& r, Array3<double>& z) { precondition(r, z); });
  // Not to converge is no error of hypre's state: the continuity residual tells of it.
  HYPRE_ClearAllErrors();
  return used;
}

void HyprePfmg::forget() {
  pace_ = 0;
  solves_without_keeping_ = 0;
}

}  // namespace gasgrain
