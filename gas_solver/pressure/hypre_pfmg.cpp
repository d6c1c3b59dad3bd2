#include "gas_solver/pressure/hypre_pfmg.h"

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

constexpr int max_iterations = 200;
// Iterations more than right after the build that are borne before the multigrid is built anew.
constexpr int borne_iterations = 1;

HYPRE_Int keep_build(HYPRE_StructSolver, HYPRE_StructMatrix, HYPRE_StructVector,
                     HYPRE_StructVector) {
  return 0;
}

}  // namespace

HyprePfmg::HyprePfmg(const Domain& domain) : domain_(domain) {
  HYPRE_Init();
  const MPI_Comm comm = domain.comm().handle();
  HYPRE_StructGridCreate(comm, 3, &grid_);
  Int3 lo = domain.own().lo;
  Int3 hi = domain.own().hi;
  Int3 period{0, 0, 0};
  for (int d = 0; d < 3; ++d) {
    --hi[d];  // hypre's boxes hold their upper end
    if (domain.grid().periodic[d] && domain.grid().cells[d] > 1) period[d] = domain.grid().cells[d];
  }
  HYPRE_StructGridSetExtents(grid_, lo.data(), hi.data());
  HYPRE_StructGridSetPeriodic(grid_, period.data());
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
  HYPRE_StructPCGCreate(comm, &gradients_);
  HYPRE_StructPCGSetTwoNorm(gradients_, 1);
  HYPRE_StructPCGSetTol(gradients_, 0.0);
}

HyprePfmg::~HyprePfmg() {
  HYPRE_StructPCGDestroy(gradients_);
  if (multigrid_ != nullptr) HYPRE_StructPFMGDestroy(multigrid_);
  HYPRE_StructVectorDestroy(source_);
  HYPRE_StructVectorDestroy(solution_);
  HYPRE_StructMatrixDestroy(matrix_);
  HYPRE_StructStencilDestroy(stencil_);
  HYPRE_StructGridDestroy(grid_);
}

void HyprePfmg::set_matrix(const PressureSystem& system) {
  const IndexBox own = domain_.own();
  const Array3<double>& cx = system.face_coefficient[0];
  values_.resize(4 * own.size());
  std::size_t n = 0;
  for_each_cell(own, [&](int i, int j, int k) {
    const auto o = cx.offset(i, j, k);
    const Int3 at{i, j, k};
    values_[n++] = diagonal(system, o);
    for (int d = 0; d < 3; ++d) {
      const bool joined = at[d] > 0 || domain_.grid().periodic[d];
      values_[n++] = joined ? -system.face_coefficient[d][o] : 0.0;
    }
  });
  // Where the solution is known but for a constant, one cell is joined to the value 0. Sources that
  // sum to 0 then make its value 0, and the solution is one of the system's.
  if (system.singular && own.contains(0, 0, 0)) values_[0] *= 2.0;
  Int3 lo = own.lo;
  Int3 hi{own.hi[0] - 1, own.hi[1] - 1, own.hi[2] - 1};
  HYPRE_Int entries[4] = {0, 1, 2, 3};
  HYPRE_StructMatrixSetBoxValues(matrix_, lo.data(), hi.data(), 4, entries, values_.data());
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
  constexpr int galerkin_seven_point = 1;
  HYPRE_StructPFMGSetRAPType(multigrid_, galerkin_seven_point);
  HYPRE_StructPFMGSetup(multigrid_, matrix_, source_, solution_);
  HYPRE_StructPCGSetPrecond(gradients_, HYPRE_StructPFMGSolve, keep_build, multigrid_);
  HYPRE_StructPCGSetup(gradients_, matrix_, source_, solution_);
  built_ = true;
}

int HyprePfmg::solve(PressureSystem& system, double tolerance) {
  set_matrix(system);
  Int3 lo = domain_.own().lo;
  Int3 hi{domain_.own().hi[0] - 1, domain_.own().hi[1] - 1, domain_.own().hi[2] - 1};
  HYPRE_StructVectorSetBoxValues(source_, lo.data(), hi.data(), system.source.data());
  HYPRE_StructVectorAssemble(source_);
  const bool fresh = !built_;
  if (fresh) build();
  int used = iterate(system, tolerance, max_iterations);
  if (fresh) iterations_after_build_ = used;
  if (used > iterations_after_build_ + borne_iterations) built_ = false;
  return used;
}

int HyprePfmg::iterate(PressureSystem& system, double tolerance, int limit) {
  HYPRE_StructVectorSetConstantValues(solution_, 0.0);
  HYPRE_StructPCGSetAbsoluteTol(gradients_, tolerance);
  HYPRE_StructPCGSetMaxIter(gradients_, limit);
  HYPRE_StructPCGSolve(gradients_, matrix_, source_, solution_);
  // Not to converge is no error of hypre's state: the continuity residual tells of it.
  HYPRE_ClearAllErrors();
  HYPRE_Int iterations = 0;
  HYPRE_StructPCGGetNumIterations(gradients_, &iterations);
  Int3 lo = domain_.own().lo;
  Int3 hi{domain_.own().hi[0] - 1, domain_.own().hi[1] - 1, domain_.own().hi[2] - 1};
  values_.resize(domain_.own().size());
  HYPRE_StructVectorGetBoxValues(solution_, lo.data(), hi.data(), values_.data());
  const double* value = values_.data();
  for_each_cell(domain_.own(), [&](int i, int j, int k) { system.solution(i, j, k) = *value++; });
  return iterations;
}

}  // namespace gasgrain
