#include "bullet_cloth.h"

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <random>

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

/// Puts the nodes where they belong, and builds Bullet's tree of them anew, balanced. Boxes wider than the
/// scene, by margins twice the one that Bullet holds them to, save it from moving nodes in the tree, which
/// nothing here needs: it is for collisions.
void place_nodes(btSoftBody& body, const std::vector<btVector3>& positions) {
  constexpr btScalar margin = 10;  // [m]
  body.getCollisionShape()->setMargin(margin);
  for (int i = 0; i < body.m_nodes.size(); ++i) {
    btSoftBody::Node& node = body.m_nodes[i];
    node.m_x = node.m_q = positions[std::size_t(i)];
    node.m_leaf->volume = btDbvtVolume::FromCR(node.m_x, 2 * margin);
  }
  body.m_ndbvt.optimizeTopDown();
}

/// The nodes are made in random places first: Bullet inserts each into a tree as it comes, and one row after
/// the other makes that tree so deep that a million of them take minutes.
std::unique_ptr<btSoftBody> make_body(const Scene& scene, btSoftBodyWorldInfo& info) {
  std::vector<btVector3> positions;
  for (const Vec3& position : scene.particles.position) positions.push_back(to_bullet(position));
  std::vector<btVector3> elsewhere = positions;
  std::shuffle(elsewhere.begin(), elsewhere.end(), std::mt19937(1));
  std::vector<btScalar> masses(scene.particles.mass.begin(), scene.particles.mass.end());
  for (const Pin& pin : scene.pins) masses[pin.particle] = 0;  // Bullet's way to say infinite
  auto body = std::make_unique<btSoftBody>(&info, int(positions.size()), elsewhere.data(), masses.data());
  place_nodes(*body, positions);
  return body;
}

void add_links(btSoftBody& body, const Springs& springs) {
  btSoftBody::Material* material = body.appendMaterial();
  material->m_kLST = 1;  // a projection takes away all of a link's error
  for (std::size_t s = 0; s < springs.size(); ++s)
    body.appendLink(int(springs.first[s]), int(springs.second[s]), material);
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
  add_links(*world_->body, scene.springs);
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
