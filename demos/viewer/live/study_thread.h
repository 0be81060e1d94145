#pragma once

#include <atomic>
#include <string>
#include <thread>

#include <hooke/study.h>

namespace hooke::viewer {

/// A study of accuracy on a thread of its own.
class StudyThread {
 public:
  StudyThread(Scene scene, StudySettings settings);
  /// Cancels the study where it is not done.
  ~StudyThread();
  StudyThread(const StudyThread&) = delete;
  StudyThread& operator=(const StudyThread&) = delete;

  void cancel() { wanted_ = false; }
  bool cancelled() const { return !wanted_; }
  double share() const { return share_; }  ///< of its budget [1]
  bool done() const { return done_; }

  /// Once it is done: what came out, or why nothing did.
  const AccuracyStudy& study() const { return study_; }
  const std::string& problem() const { return problem_; }

 private:
  void work(const Scene& scene, StudySettings settings);

  std::atomic<bool> wanted_{true}, done_{false};
  std::atomic<double> share_{0.0};
  AccuracyStudy study_;
  std::string problem_;
  std::thread thread_;
};

}  // namespace hooke::viewer
