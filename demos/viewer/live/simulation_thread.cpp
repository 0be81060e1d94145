#include "viewer/live/simulation_thread.h"

#include <memory>
#include <utility>

#include "viewer/live/simulation_loop.h"

namespace hooke::viewer {
namespace {

template <class Number>
std::thread started(Scene scene, Settings settings, const Rhythm& rhythm, CommandQueue& commands,
                    TripleBuffer<Moment>& moments) {
  auto loop = std::make_unique<SimulationLoop<Number>>(std::move(scene), std::move(settings), rhythm,
                                                       commands, moments);
  return std::thread([running = std::move(loop)] { running->run(); });
}

}  // namespace

SimulationThread::SimulationThread(Scene scene, Settings settings, Precision precision,
                                   const Rhythm& rhythm) {
  const auto start = precision == Precision::single ? started<float> : started<double>;
  thread_ = start(std::move(scene), std::move(settings), rhythm, commands_, moments_);
  moments_.fetch();
}

SimulationThread::~SimulationThread() {
  commands_.close();
  thread_.join();
}

}  // namespace hooke::viewer
