#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "solver.h"

namespace hooke::reference {
namespace {

struct Free {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};

template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Free>;

void require(int status, const char* call) {
  if (status < 0) throw std::runtime_error(std::string(call) + " of CVODE failed: " + std::to_string(status));
}

template <class Pointer>
Pointer require(Pointer made, const char* call) {
  if (made == nullptr) throw std::runtime_error(std::string(call) + " of SUNDIALS failed");
  return made;
}

Owned<SUNContext> make_context() {
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  return Owned<SUNContext>(context);
}

/// A view of values that outlive it.
Owned<N_Vector> view(std::vector<double>& values, SUNContext context) {
  return Owned<N_Vector>(
      require(N_VMake_Serial(sunindextype(values.size()), values.data(), context), "N_VMake_Serial"));
}

int derivative(realtype time, N_Vector y, N_Vector result, void* forces) {
  const auto count = std::size_t(N_VGetLength(y));
  static_cast<EngineForces*>(forces)->derivative(time, {N_VGetArrayPointer(y), count},
                                                 {N_VGetArrayPointer(result), count});
  return 0;
}

}  // namespace

std::vector<double> solve_with_cvode(EngineForces& forces, std::vector<double> y, double from, double to,
                                     const Scale& scale, double tolerance) {
  std::vector<double> absolute(y.size(), tolerance * scale.speed);
  std::fill_n(absolute.begin(), y.size() / 2, tolerance * scale.length);
  const auto context = make_context();
  const auto values = view(y, context.get()), absolutes = view(absolute, context.get());
  const Owned<SUNNonlinearSolver> iteration(
      require(SUNNonlinSol_FixedPoint(values.get(), 0, context.get()), "SUNNonlinSol_FixedPoint"));
  const std::unique_ptr<void, Free> cvode(require(CVodeCreate(CV_ADAMS, context.get()), "CVodeCreate"));
  require(CVodeInit(cvode.get(), derivative, from, values.get()), "CVodeInit");
  require(CVodeSetUserData(cvode.get(), &forces), "CVodeSetUserData");
  require(CVodeSVtolerances(cvode.get(), tolerance, absolutes.get()), "CVodeSVtolerances");
  require(CVodeSetNonlinearSolver(cvode.get(), iteration.get()), "CVodeSetNonlinearSolver");
  require(CVodeSetMaxNumSteps(cvode.get(), 10'000'000), "CVodeSetMaxNumSteps");
  require(CVodeSetStopTime(cvode.get(), to), "CVodeSetStopTime");  // no force is asked for beyond
  double reached = from;
  require(CVode(cvode.get(), to, values.get(), &reached, CV_NORMAL), "CVode");
  return y;
}

}  // namespace hooke::reference
