// Solvers that others wrote, each where its library was found. None of them is part of the program.
#include "bench/integration_peers.h"

#include <cmath>
#include <numbers>

#ifdef HADA_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif
#ifdef HADA_HAS_FFTW
#include <fftw3.h>
#endif
#ifdef HADA_HAS_HYPRE
#include <HYPRE.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>
#endif

namespace hada {
namespace {

#ifdef HADA_HAS_CHOLMOD
SolverRun run_cholmod(const IntegrationScene& scene) {
  return timed("CHOLMOD", scene, [](const IntegrationProblem& problem) {
    Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> solver(matrix_of(problem, true));
    const Eigen::VectorXd height = solver.solve(Eigen::Map<const Eigen::VectorXd>(
        problem.right.data(), Eigen::Index(problem.right.size())));
    return std::vector<double>(height.begin(), height.end());
  });
}
#endif

#ifdef HADA_HAS_HYPRE
SolverRun run_hypre(const IntegrationScene& scene) {
  return timed("hypre, BoomerAMG in conjugate gradients", scene, [](const IntegrationProblem& p) {
    int started = 0;
    MPI_Initialized(&started);
    if (!started) MPI_Init(nullptr, nullptr);
    HYPRE_Init();
    const auto matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>(matrix_of(p, true));
    HYPRE_IJMatrix a;
    HYPRE_IJVector b;
    HYPRE_IJVector x;
    HYPRE_IJMatrixCreate(MPI_COMM_WORLD, 0, p.unknowns - 1, 0, p.unknowns - 1, &a);
    HYPRE_IJMatrixSetObjectType(a, HYPRE_PARCSR);
    HYPRE_IJMatrixInitialize(a);
    std::vector<HYPRE_Int> counts(std::size_t(p.unknowns), 0);
    std::vector<HYPRE_BigInt> rows(std::size_t(p.unknowns), 0);
    for (int row = 0; row < p.unknowns; ++row) {
      rows[std::size_t(row)] = row;
      counts[std::size_t(row)] =
          HYPRE_Int(matrix.outerIndexPtr()[row + 1] - matrix.outerIndexPtr()[row]);
    }
    const std::vector<HYPRE_BigInt> cols(matrix.innerIndexPtr(),
                                         matrix.innerIndexPtr() + matrix.nonZeros());
    HYPRE_IJMatrixSetValues(a, p.unknowns, counts.data(), rows.data(), cols.data(),
                            matrix.valuePtr());
    HYPRE_IJMatrixAssemble(a);
    std::vector<double> height(std::size_t(p.unknowns), 0.0);
    for (auto* const vector : {&b, &x}) {
      HYPRE_IJVectorCreate(MPI_COMM_WORLD, 0, p.unknowns - 1, vector);
      HYPRE_IJVectorSetObjectType(*vector, HYPRE_PARCSR);
      HYPRE_IJVectorInitialize(*vector);
      HYPRE_IJVectorSetValues(*vector, p.unknowns, rows.data(),
                              vector == &b ? p.right.data() : height.data());
      HYPRE_IJVectorAssemble(*vector);
    }
    HYPRE_ParCSRMatrix par_a;
    HYPRE_ParVector par_b;
    HYPRE_ParVector par_x;
    HYPRE_IJMatrixGetObject(a, reinterpret_cast<void**>(&par_a));
    HYPRE_IJVectorGetObject(b, reinterpret_cast<void**>(&par_b));
    HYPRE_IJVectorGetObject(x, reinterpret_cast<void**>(&par_x));
    HYPRE_Solver solver;
    HYPRE_Solver amg;
    HYPRE_ParCSRPCGCreate(MPI_COMM_WORLD, &solver);
    HYPRE_PCGSetMaxIter(solver, 200);
    HYPRE_PCGSetTol(solver, 1e-8);
    HYPRE_PCGSetTwoNorm(solver, 1);
    HYPRE_BoomerAMGCreate(&amg);
    HYPRE_BoomerAMGSetCoarsenType(amg, 8);
    HYPRE_BoomerAMGSetInterpType(amg, 6);
    HYPRE_BoomerAMGSetRelaxType(amg, 6);
    HYPRE_BoomerAMGSetTol(amg, 0.0);
    HYPRE_BoomerAMGSetMaxIter(amg, 1);
    HYPRE_PCGSetPrecond(solver, HYPRE_PtrToSolverFcn(HYPRE_BoomerAMGSolve),
                        HYPRE_PtrToSolverFcn(HYPRE_BoomerAMGSetup), amg);
    HYPRE_ParCSRPCGSetup(solver, par_a, par_b, par_x);
    HYPRE_ParCSRPCGSolve(solver, par_a, par_b, par_x);
    HYPRE_IJVectorGetValues(x, p.unknowns, rows.data(), height.data());
    HYPRE_ParCSRPCGDestroy(solver);
    HYPRE_BoomerAMGDestroy(amg);
    HYPRE_IJMatrixDestroy(a);
    HYPRE_IJVectorDestroy(b);
    HYPRE_IJVectorDestroy(x);
    return height;
  });
}
#endif

#ifdef HADA_HAS_FFTW
// The Laplacian with free boundaries is diagonal under the cosine transform; full rectangles only.
SolverRun run_fftw(const IntegrationScene& scene) {
  const int rows = scene.mask.rows();
  const int cols = scene.mask.cols();
  std::vector<float> data(scene.mask.size());
  const auto plan = [&](fftw_r2r_kind kind) {
    return fftwf_plan_r2r_2d(rows, cols, data.data(), data.data(), kind, kind, FFTW_ESTIMATE);
  };
  const fftwf_plan forward = plan(FFTW_REDFT10);
  const fftwf_plan back = plan(FFTW_REDFT01);
  const auto solve = [&](const IntegrationProblem& problem) {
    std::copy(problem.right.begin(), problem.right.end(), data.begin());
    fftwf_execute(forward);
    const auto eigenvalue = [](int k, int n) {
      return 2.0 - 2.0 * std::cos(std::numbers::pi * k / n);
    };
    std::vector<double> across;
    for (int col = 0; col < cols; ++col) across.push_back(eigenvalue(col, cols));
    for (int row = 0; row < rows; ++row) {
      const double along = eigenvalue(row, rows);
      float* const line = data.data() + std::size_t(row) * std::size_t(cols);
      for (int col = 0; col < cols; ++col) {
        const double sum = (along + across[std::size_t(col)]) * 4.0 * rows * cols;
        line[col] = sum > 0.0 ? float(line[col] / sum) : 0.0f;
      }
    }
    fftwf_execute(back);
    return std::vector<double>();
  };
  const SolverRun run = timed("FFTW, cosine transform in floats", scene, solve,
                              [&] { return std::vector<double>(data.begin(), data.end()); });
  fftwf_destroy_plan(forward);
  fftwf_destroy_plan(back);
  return run;
}
#endif

}  // namespace

std::vector<SolverRun> run_peers([[maybe_unused]] const IntegrationScene& scene) {
  std::vector<SolverRun> runs;
#ifdef HADA_HAS_FFTW
  if (regions_of(scene.mask).size[0] == 0) {
    runs.push_back(run_fftw(scene));
    return runs;
  }
#endif
#ifdef HADA_HAS_CHOLMOD
  runs.push_back(run_cholmod(scene));
#endif
#ifdef HADA_HAS_HYPRE
  runs.push_back(run_hypre(scene));
#endif
  return runs;
}

}  // namespace hada
