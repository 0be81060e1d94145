#include "bullet_cloth.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <map>

namespace hooke::bench {

/// What Bullet wants around a soft body; in this order, as each needs those before it.
struct BulletCloth::World {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld dynamics{&dispatcher, &broadphase, &solver, &configuration};
  std::unique_ptr<btSoftBody> body;

  ~World() {
    if (body) dynamics.removeSoftBody(body.get());
  }
};

namespace {

btVector3 to_bullet(const Vec3& v) {
  return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

std::unique_ptr<btSoftBody> make_body(const Scene& scene, btSoftBodyWorldInfo& info) {
  std::vector<btVector3> positions;
  for (const Vec3& position : scene.particles.position) positions.push_back(to_bullet(position));
  std::vector<btScalar> masses(scene.particles.mass.begin(), scene.particles.mass.end());
  for (const Pin& pin : scene.pins) masses[pin.particle] = 0;  // Bullet's way to say infinite
  return std::make_unique<btSoftBody>(&info, int(positions.size()), positions.data(), masses.data());
}

void add_links(btSoftBody& body, const Scene& scene, const std::vector<double>& stiffness) {
  std::map<double, btSoftBody::Material*> materials;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    btSoftBody::Material*& material = materials[stiffness[s]];
    if (!material) {
      material = body.appendMaterial();
      material->m_kLST = btScalar(stiffness[s]);
    }
    body.appendLink(int(scene.springs.first[s]), int(scene.springs.second[s]), material);
  }
}

}  // namespace

BulletCloth::BulletCloth(const Scene& scene, const BulletSettings& settings)
    : world_(std::make_unique<World>()), damping_(settings.damping) {
  btSoftBodyWorldInfo& info = world_->dynamics.getWorldInfo();
  for (const Effect& effect : scene.effects) {
    if (const auto* gravity = std::get_if<Gravity>(&effect))
      info.m_gravity = to_bullet(gravity->acceleration);
  }
  world_->body = make_body(scene, info);
  add_links(*world_->body, scene, settings.stiffness);
  world_->body->m_cfg.piterations = settings.iterations;
  world_->body->m_cfg.collisions = 0;
  world_->body->setActivationState(DISABLE_DEACTIVATION);
  world_->dynamics.addSoftBody(world_->body.get());
}

BulletCloth::~BulletCloth() = default;

void BulletCloth::step(double seconds) {
  world_->body->m_cfg.kDP = btScalar(1.0 - std::exp(-damping_ * seconds));
  world_->dynamics.stepSimulation(btScalar(seconds), 0);
}

std::vector<Vec3> BulletCloth::positions() const {
  std::vector<Vec3> positions;
  const auto& nodes = world_->body->m_nodes;
  for (int i = 0; i < nodes.size(); ++i) {
    positions.emplace_back(nodes[i].m_x.x(), nodes[i].m_x.y(), nodes[i].m_x.z());
  }
  return positions;
}

}  // namespace hooke::bench
