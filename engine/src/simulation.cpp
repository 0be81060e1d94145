#include <hooke/simulation.h>

#include <stdexcept>
#include <string>

#include "simulation_parts.h"
#include "tearing/longest_lengths.h"

namespace hooke {
namespace {

/// Writes a vector for each of the user's particles; vector_of gives the one at a place of the engine's
/// order.
template <class Out, class VectorOf>
void write_vectors(Out* first, std::size_t stride_bytes, const Order& order, const VectorOf& vector_of) {
  auto* bytes = reinterpret_cast<std::byte*>(first);
  for (std::size_t i = 0; i < order.size(); ++i, bytes += stride_bytes) {
    const auto vector = vector_of(order.engine(i));
    auto* out = reinterpret_cast<Out*>(bytes);
    for (int axis = 0; axis < 3; ++axis) out[axis] = Out(vector[axis]);
  }
}

/// Positions between the state before (share 0) and the one now (share 1).
template <class Out, class Real>
void write_positions(Out* first, std::size_t stride_bytes, const Order& order, const State<Real>& before,
                     const State<Real>& now, double share) {
  if (share == 1.0) {
    write_vectors(first, stride_bytes, order, [&](Index e) { return now.position(e); });
    return;
  }
  write_vectors(first, stride_bytes, order, [&](Index e) -> Eigen::Matrix<Real, 3, 1> {
    const Eigen::Matrix<Real, 3, 1> from = before.position(e);
    return from + Real(share) * (now.position(e) - from);
  });
}

/// Whose message says which function was called in vain.
void require_particle(const char* function, Index particle, std::size_t particles) {
  if (particle < particles) return;
  throw std::out_of_range(std::string(function) + ": there is no particle " + std::to_string(particle) +
                          "; give one below " + std::to_string(particles));
}

template <class Out, class Real>
void write_velocities(Out* first, std::size_t stride_bytes, const Order& order, const State<Real>& now) {
  write_vectors(first, stride_bytes, order, [&](Index e) { return now.velocity(e); });
}

}  // namespace

std::string_view to_string(Accumulation accumulation) {
  switch (accumulation) {
    case Accumulation::gather:
      return "gather";
    case Accumulation::coloured:
      return "coloured";
    case Accumulation::atomic:
      return "atomic";
  }
  return "";
}

std::string_view to_string(UnstableStep choice) {
  switch (choice) {
    case UnstableStep::divide:
      return "divide";
    case UnstableStep::refuse:
      return "refuse";
    case UnstableStep::take:
      return "take";
  }
  return "";
}

std::string_view to_string(OnTrouble choice) {
  switch (choice) {
    case OnTrouble::stop:
      return "stop";
    case OnTrouble::halve:
      return "halve";
    case OnTrouble::tell:
      return "tell";
    case OnTrouble::ignore:
      return "ignore";
  }
  return "";
}

template <class Real>
Simulation<Real>::Simulation(const Scene& scene, Settings settings)
    : parts_(std::make_unique<Parts>(scene, std::move(settings))) {
  if (!may_tear(scene)) return;
  const auto start = std::make_shared<const Scene>(scene);
  parts_->begin_tearing({start, start, {}, parts_->settings.unstable_step, {scene, parts_->model.order, {}}});
}

template <class Real>
Simulation<Real>::~Simulation() = default;
template <class Real>
Simulation<Real>::Simulation(Simulation&&) noexcept = default;
template <class Real>
Simulation<Real>& Simulation<Real>::operator=(Simulation&&) noexcept = default;

template <class Real>
Report Simulation<Real>::step(std::uint64_t count) {
  return parts_->tears ? Parts::take_tearing_steps(parts_, count) : parts_->take_steps(count);
}

template <class Real>
Report Simulation<Real>::advance(double frame_seconds) {
  const Tick tick = parts_->clock.advance(frame_seconds);
  Report report = step(tick.steps);
  report.interpolation = tick.interpolation;
  report.dropped_seconds = tick.dropped_seconds;
  if (tick.dropped_seconds > 0.0) report.flags |= flag_steps_dropped;
  return report;
}

template <class Real>
double Simulation<Real>::time() const {
  return parts_->states.now().time;
}

template <class Real>
std::uint64_t Simulation<Real>::steps() const {
  return parts_->steps;
}

template <class Real>
std::size_t Simulation<Real>::particle_count() const {
  return parts_->model.particles();
}

template <class Real>
std::size_t Simulation<Real>::spring_count() const {
  return parts_->model.springs;
}

template <class Real>
unsigned Simulation<Real>::threads() const {
  return parts_->executor->threads();
}

template <class Real>
const Settings& Simulation<Real>::settings() const {
  return parts_->settings;
}

template <class Real>
StateView<Real> Simulation<Real>::state() const {
  const State<Real>& s = parts_->whole_state();
  const std::size_t n = s.size();
  return {{s.x(), n}, {s.y(), n}, {s.z(), n}, {s.vx(), n}, {s.vy(), n}, {s.vz(), n}};
}

template <class Real>
Index Simulation<Real>::engine_index(Index particle) const {
  require_particle("engine_index", particle, particle_count());
  return parts_->model.order.engine(particle);
}

template <class Real>
std::span<const Triangle> Simulation<Real>::triangles() const {
  return parts_->tears ? std::span<const Triangle>(parts_->tears->now->triangles)
                       : std::span<const Triangle>{};
}

template <class Real>
Index Simulation<Real>::origin(Index particle) const {
  require_particle("origin", particle, particle_count());
  if (!parts_->tears) return particle;
  const std::size_t before = parts_->tears->start->particles.size();
  return particle < before ? particle : parts_->tears->torn_from[particle - before];
}

template <class Real>
void Simulation<Real>::copy_positions(float* first, std::size_t stride_bytes, double interpolation) const {
  write_positions(first, stride_bytes, parts_->model.order, parts_->states.before(), parts_->states.now(),
                  interpolation);
}

template <class Real>
void Simulation<Real>::copy_positions(double* first, std::size_t stride_bytes, double interpolation) const {
  write_positions(first, stride_bytes, parts_->model.order, parts_->states.before(), parts_->states.now(),
                  interpolation);
}

template <class Real>
void Simulation<Real>::copy_velocities(float* first, std::size_t stride_bytes) const {
  write_velocities(first, stride_bytes, parts_->model.order, parts_->whole_state());
}

template <class Real>
void Simulation<Real>::copy_velocities(double* first, std::size_t stride_bytes) const {
  write_velocities(first, stride_bytes, parts_->model.order, parts_->whole_state());
}

template <class Real>
void Simulation<Real>::apply_impulse(Index particle, const Vec3& impulse) {
  require_particle("apply_impulse", particle, particle_count());
  Parts& p = *parts_;
  const Index e = p.model.order.engine(particle);
  const State<Real>& whole = p.whole_state();
  const Vec3 change = impulse * double(p.model.inverse_mass_awake()[e]);
  const Eigen::Matrix<Real, 3, 1> velocity =
      (whole.velocity(e).template cast<double>() + change).template cast<Real>();
  if (!velocity.allFinite()) {
    throw std::invalid_argument("apply_impulse: particle " + std::to_string(particle) +
                                " would get a velocity that is not finite; give a finite, smaller impulse");
  }
  // A kick that is still pending goes first: its forces may depend on the velocity before the impulse.
  State<Real>& now = p.states.now();
  if (now.pending_kick != 0.0) now = whole;
  p.wake({&particle, 1});
  if (p.watch && !p.model.pinned(e)) {
    const Vec3 mean = 0.5 * (now.velocity(e) + velocity).template cast<double>();
    p.watch->add_work(impulse.dot(mean));
  }
  now.set_velocity(e, velocity);
  p.stopped.reset();
  p.whole.forget();
  // What error control knows of the forces here may depend on the velocity.
  if (p.controlled) p.controlled->restart(p.controlled->next_step(), p.controlled->last_error());
  if (p.solved) p.solved->forget();
}

template <class Real>
bool Simulation<Real>::is_asleep(Index particle) const {
  require_particle("is_asleep", particle, particle_count());
  return parts_->sleepers && parts_->model.islands->particle_sleeps(particle);
}

template <class Real>
void Simulation<Real>::wake(Index particle) {
  require_particle("wake", particle, particle_count());
  parts_->wake({&particle, 1});
}

template <class Real>
const Plan& Simulation<Real>::plan() const {
  return parts_->plan.shown;
}

template <class Real>
Energy Simulation<Real>::energy() const {
  return parts_->energy();
}

template <class Real>
Vec3 Simulation<Real>::momentum() const {
  Parts& p = *parts_;
  return sum_particles(p.model, p.forces, p.whole_state(), *p.executor).momentum;
}

template <class Real>
double Simulation<Real>::max_strain() const {
  return parts_->forces.measure_springs(parts_->states.now(), *parts_->executor).max_strain;
}

template <class Real>
Stability Simulation<Real>::stability() const {
  Parts& p = *parts_;
  return report_stability(p.stability, p.settings, p.model, p.forces.effects(), p.states.now(), *p.executor);
}

template <class Real>
std::uint64_t Simulation<Real>::state_hash() const {
  return hash_state(parts_->whole_state(), parts_->model.order);
}

template class Simulation<float>;
template class Simulation<double>;

}  // namespace hooke
