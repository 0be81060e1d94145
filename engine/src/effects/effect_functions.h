#pragma once

#include "effects/compiled_effect.h"
#include "scene/element_checks.h"
#include "stability/held_particles.h"

/// What is there for each effect; each one's are in the file of its name.

namespace hooke {

/// The effect as it runs in this scene.
template <class Real>
EffectPointer<Real> compile_effect(const Gravity&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Drag&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Field&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const ParticleWind&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Wind&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const ForceScript&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const GroundPlane&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const HingeBending&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const LaplacianBending&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Pressure&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Volume&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const CustomEffect&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const TensileTriangles&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Cables&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const StiffeningSprings&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Plasticity&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const StrainLimit&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Tethers&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const MotionScript&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Collider&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const FrameAttachment&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Stitch&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const SelfCollision&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const ParticleContact&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Tearing&, const EffectContext<Real>&);
template <class Real>
EffectPointer<Real> compile_effect(const Sleep&, const EffectContext<Real>&);

/// Faults of its values, or of the scene for its purposes. Of the scene nothing has been checked yet.
void check_effect(const Gravity&, const Scene&, const ElementChecks&);
void check_effect(const Drag&, const Scene&, const ElementChecks&);
void check_effect(const Field&, const Scene&, const ElementChecks&);
void check_effect(const ParticleWind&, const Scene&, const ElementChecks&);
void check_effect(const Wind&, const Scene&, const ElementChecks&);
void check_effect(const ForceScript&, const Scene&, const ElementChecks&);
void check_effect(const GroundPlane&, const Scene&, const ElementChecks&);
void check_effect(const HingeBending&, const Scene&, const ElementChecks&);
void check_effect(const LaplacianBending&, const Scene&, const ElementChecks&);
void check_effect(const Pressure&, const Scene&, const ElementChecks&);
void check_effect(const Volume&, const Scene&, const ElementChecks&);
void check_effect(const CustomEffect&, const Scene&, const ElementChecks&);
void check_effect(const TensileTriangles&, const Scene&, const ElementChecks&);
void check_effect(const Cables&, const Scene&, const ElementChecks&);
void check_effect(const StiffeningSprings&, const Scene&, const ElementChecks&);
void check_effect(const Plasticity&, const Scene&, const ElementChecks&);
void check_effect(const StrainLimit&, const Scene&, const ElementChecks&);
void check_effect(const Tethers&, const Scene&, const ElementChecks&);
void check_effect(const MotionScript&, const Scene&, const ElementChecks&);
void check_effect(const Collider&, const Scene&, const ElementChecks&);
void check_effect(const FrameAttachment&, const Scene&, const ElementChecks&);
void check_effect(const Stitch&, const Scene&, const ElementChecks&);
void check_effect(const SelfCollision&, const Scene&, const ElementChecks&);
void check_effect(const ParticleContact&, const Scene&, const ElementChecks&);
void check_effect(const Tearing&, const Scene&, const ElementChecks&);
void check_effect(const Sleep&, const Scene&, const ElementChecks&);

/// Adds how stiffly it holds particles, of a scene without faults.
void add_bounds(const Gravity&, const Scene&, HeldParticles&);
void add_bounds(const Drag&, const Scene&, HeldParticles&);
void add_bounds(const Field&, const Scene&, HeldParticles&);
void add_bounds(const ParticleWind&, const Scene&, HeldParticles&);
void add_bounds(const Wind&, const Scene&, HeldParticles&);
void add_bounds(const ForceScript&, const Scene&, HeldParticles&);
void add_bounds(const GroundPlane&, const Scene&, HeldParticles&);
void add_bounds(const HingeBending&, const Scene&, HeldParticles&);
void add_bounds(const LaplacianBending&, const Scene&, HeldParticles&);
void add_bounds(const Pressure&, const Scene&, HeldParticles&);
void add_bounds(const Volume&, const Scene&, HeldParticles&);
void add_bounds(const CustomEffect&, const Scene&, HeldParticles&);
void add_bounds(const TensileTriangles&, const Scene&, HeldParticles&);
void add_bounds(const Cables&, const Scene&, HeldParticles&);
void add_bounds(const StiffeningSprings&, const Scene&, HeldParticles&);
void add_bounds(const Plasticity&, const Scene&, HeldParticles&);
void add_bounds(const StrainLimit&, const Scene&, HeldParticles&);
void add_bounds(const Tethers&, const Scene&, HeldParticles&);
void add_bounds(const MotionScript&, const Scene&, HeldParticles&);
void add_bounds(const Collider&, const Scene&, HeldParticles&);
void add_bounds(const FrameAttachment&, const Scene&, HeldParticles&);
void add_bounds(const Stitch&, const Scene&, HeldParticles&);
void add_bounds(const SelfCollision&, const Scene&, HeldParticles&);
void add_bounds(const ParticleContact&, const Scene&, HeldParticles&);
void add_bounds(const Tearing&, const Scene&, HeldParticles&);
void add_bounds(const Sleep&, const Scene&, HeldParticles&);

/// Whether it can do work without having an energy that the simulation knows: then nobody can say how much
/// energy there should be.
template <class Data>
inline constexpr bool does_unknown_work = false;
template <>
inline constexpr bool does_unknown_work<Field> = true;
template <>
inline constexpr bool does_unknown_work<Pressure> = true;  // gas may give more than it has at the start
template <>
inline constexpr bool does_unknown_work<CustomEffect> = true;
template <>
inline constexpr bool does_unknown_work<ParticleWind> = true;
template <>
inline constexpr bool does_unknown_work<Wind> = true;
template <>
inline constexpr bool does_unknown_work<ForceScript> = true;
/// What a limit or a tether pulls in from a state that did not keep it, and with pins that move, has no
/// bound.
template <>
inline constexpr bool does_unknown_work<StrainLimit> = true;
template <>
inline constexpr bool does_unknown_work<Tethers> = true;
template <>
inline constexpr bool does_unknown_work<MotionScript> = true;
template <>
inline constexpr bool does_unknown_work<Collider> = true;  // it may move, and begin around particles
template <>
inline constexpr bool does_unknown_work<FrameAttachment> = true;
template <>
inline constexpr bool does_unknown_work<Stitch> = true;  // a seam that closes pulls

bool does_unknown_work_in(const Scene& scene);

/// Whether it changes the results of steps, beside or instead of having a force.
template <class Data>
inline constexpr bool corrects_results = false;
template <>
inline constexpr bool corrects_results<Plasticity> = true;
template <>
inline constexpr bool corrects_results<StrainLimit> = true;
template <>
inline constexpr bool corrects_results<Tethers> = true;
template <>
inline constexpr bool corrects_results<MotionScript> = true;
template <>
inline constexpr bool corrects_results<Collider> = true;
template <>
inline constexpr bool corrects_results<FrameAttachment> = true;
template <>
inline constexpr bool corrects_results<Stitch> = true;
template <>
inline constexpr bool corrects_results<SelfCollision> = true;
template <>
inline constexpr bool corrects_results<ParticleContact> = true;  // what has slid is noted after each step

}  // namespace hooke
