#pragma once

#include <vector>

#include "forces.h"
#include "kernels/vertex_descent.h"
#include "model/adjacency.h"
#include "model/model.h"
#include "model/vertex_colours.h"
#include "solve/coupled_forces.h"
#include "solve/stage_solver.h"

namespace hooke {

/// The particles colour by colour, their springs and effects, and the state that sweeps over them improve.
/// Effects that depend on nothing but the particle are taken when its turn comes, coupled ones before each
/// sweep.
template <class Real>
class VertexSweeps {
 public:
  explicit VertexSweeps(const SolverContext<Real>& context);

  /// Takes the stage and the guess to begin with.
  void load(const ImplicitStage<Real>& stage, const State<Real>& guess);

  /// Solves the equations of each particle once, one colour after the other. `least_across`: see
  /// VertexEquations. Returns the sum of the squares of the changes of velocity.
  double sweep(Real least_across);

  /// Where free particles have got to.
  void store(State<Real>& next) const;

  /// The state is in the order of colours.
  const Model<Real>& model() const { return model_; }
  const State<Real>& from() const { return from_; }
  State<Real>& now() { return now_; }
  const State<Real>& now() const { return now_; }
  Real h() const { return h_; }  ///< [s]

  std::size_t colours() const { return colours_.size(); }
  std::size_t bytes() const;

 private:
  VertexSweeps(const SolverContext<Real>& context, const Adjacency& adjacency);
  VertexSweeps(const SolverContext<Real>& context, const Adjacency& adjacency, VertexColours colours);

  bool follow_islands();

  template <class Visit>
  void for_each_awake(const Visit& visit) const;

  double solve_awake(const VertexEquations<Real>& equations, const VertexStrip& strip);
  double solve_strip(const VertexEquations<Real>& equations, const VertexStrip& strip);

  /// The strips of one colour: `together` of them run at once. The others run after them, one by one: vectors
  /// that they load overlap particles of their own colour, although they make no use of these.
  struct Colour {
    std::size_t first, together, last;  ///< in strips_
  };

  void cut_into_strips(const std::vector<std::size_t>& colour_begin);
  bool overlaps(const VertexStrip& strip, std::size_t first, std::size_t last) const;

  Executor& executor_;
  Model<Real> model_;    ///< in the order of colours
  Forces<Real> forces_;  ///< the same
  CoupledForces<Real> coupled_;
  std::vector<Index> engine_;  ///< for each particle here its number in the engine's order
  std::vector<Colour> colours_;
  std::vector<VertexStrip> strips_;
  AwakeBlocks awake_;            ///< of strips
  std::vector<double> changes_;  ///< for each strip
  State<Real> from_, now_;
  Real h_ = 0;
  double time_ = 0.0;
};

}  // namespace hooke
