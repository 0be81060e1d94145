#include "viewer/scene_view.h"

#include "viewer/picking.h"

namespace hooke::viewer {
namespace {

std::vector<bool> pinned_in(const Scene& scene) {
  std::vector<bool> pinned(scene.particles.size(), false);
  for (const Pin& pin : scene.pins) pinned[pin.particle] = true;
  return pinned;
}

bool same_place(const std::vector<GroundPlane>& a, const std::vector<GroundPlane>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].normal != b[i].normal || a[i].height != b[i].height) return false;
  }
  return true;
}

}  // namespace

SceneView::SceneView(const Scene& scene)
    : renderer_(picture::subject_of(scene)),
      whole_(renderer_.subject()),
      look_(picture::look_for(renderer_.subject())),
      camera_(renderer_.subject().up),
      floor_(scene, renderer_.subject().up),
      pinned_(pinned_in(scene)) {}

/// What is no longer pinned for being torn off is a new particle.
void SceneView::show(std::shared_ptr<const Scene> torn) {
  if (torn == torn_) return;
  torn_ = std::move(torn);
  picture::Subject subject = torn_ ? picture::torn_subject(whole_, *torn_) : whole_;
  subject.grounds = renderer_.subject().grounds;
  pinned_.resize(subject.particles, false);
  renderer_ = picture::Renderer(std::move(subject));
}

void SceneView::take(const Moment& moment) {
  positions_ = moment.positions;
  if (moment.in_force) show(moment.in_force->torn);
  renderer_.upload(positions_);
  look_.time = moment.time;
  floor_.make_room(positions_);
  look_.floor_height = floor_.height();
  if (fitted_) camera_.follow(positions_, viewport_);
}

void SceneView::take(const std::vector<Effect>& effects) {
  std::vector<GroundPlane> grounds = picture::grounds_of(effects);
  if (same_place(grounds, renderer_.subject().grounds)) return;
  picture::Subject subject = renderer_.subject();
  subject.grounds = std::move(grounds);
  renderer_ = picture::Renderer(std::move(subject));
  renderer_.upload(positions_);
}

void SceneView::draw(const Viewport& viewport, int left, int bottom, double seconds) {
  const int width = int(viewport.width), height = int(viewport.height);
  if (!target_ || target_->width() != width || target_->height() != height) target_.emplace(width, height);
  viewport_ = viewport;
  if (!fitted_) {
    fit();
    camera_.arrive();
    fitted_ = true;
  }
  camera_.advance(seconds);
  target_->begin();
  renderer_.draw(camera_.camera(), look_, width, height);
  target_->show(left, bottom);
}

void SceneView::fit() {
  camera_.fit(positions_, viewport_);
}

std::optional<Index> SceneView::particle_at(const Eigen::Vector2d& pixel, double radius) const {
  return pick(positions_, pinned_, camera_.camera(), viewport_, pixel, radius);
}

Vec3 SceneView::position(Index particle) const {
  const float* const at = positions_.data() + 3 * std::size_t(particle);
  return {at[0], at[1], at[2]};
}

std::optional<Eigen::Vector2d> SceneView::place_of(Index particle) const {
  const Vec3 seen = camera_.camera().project(position(particle), viewport_.aspect());
  if (!(seen.z() > 0.0)) return std::nullopt;
  return viewport_.pixel(seen.x(), seen.y());
}

}  // namespace hooke::viewer
