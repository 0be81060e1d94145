#include "viewer/live/study_thread.h"

#include <exception>
#include <utility>

namespace hooke::viewer {

StudyThread::StudyThread(Scene scene, StudySettings settings)
    : thread_([this, studied = std::move(scene), asked = std::move(settings)] { work(studied, asked); }) {}

StudyThread::~StudyThread() {
  cancel();
  thread_.join();
}

void StudyThread::work(const Scene& scene, StudySettings settings) {
  settings.progress = [this](const StudyProgress& progress) {
    share_ = progress.share;
    return wanted_.load();
  };
  try {
    study_ = study_accuracy(scene, settings);
  } catch (const std::exception& error) {
    problem_ = error.what();
  }
  done_ = true;
}

}  // namespace hooke::viewer
