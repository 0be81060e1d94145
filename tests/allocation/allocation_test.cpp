#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "irregular_mesh.h"
#include "scenes.h"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t bytes, std::size_t alignment) {
  ++allocations;
  // aligned_alloc wants a multiple of the alignment.
  if (void* const pointer = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment))
    return pointer;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) {
  return counted(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, std::size_t(alignment));
}
void operator delete(void* pointer) noexcept {
  std::free(pointer);
}
void operator delete(void* pointer, std::size_t) noexcept {
  std::free(pointer);
}
void operator delete(void* pointer, std::align_val_t) noexcept {
  std::free(pointer);
}
void operator delete(void* pointer, std::size_t, std::align_val_t) noexcept {
  std::free(pointer);
}

using namespace hooke;

TEST_CASE_TEMPLATE("a step allocates nothing, in any mode, by any method, on any number of threads", Real,
                   float, double) {
  Scene grid = test::hung_cloth(80, 60, 0.001), mesh;
  grid.pin(40, {{0.0, {0, 0, 0}}, {1.0, {0, 0, 0.1}}});
  add(mesh, test::irregular_mesh(60));
  mesh.effects = {Gravity{}, GroundPlane{.height = -1.0, .stiffness = 10.0}};
  for (const Scene& scene : {grid, mesh}) {
    for (auto accumulation : accumulations) {
      for (const Method& method : all_methods) {
        if (!can_accumulate(method, accumulation)) continue;
        for (unsigned threads : {1u, 2u}) {
          CAPTURE(to_string(method));
          Simulation<Real> simulation(
              scene, {.method = method, .step = 1e-4, .accumulation = accumulation, .threads = threads});
          REQUIRE(simulation.step(20).ok());
          const std::size_t before = allocations;
          REQUIRE(before > 0);
          const Report report = simulation.step(50);
          CHECK(allocations == before);
          CHECK(report.ok());
        }
      }
    }
  }
}

TEST_CASE_TEMPLATE("a step with effects on stretch allocates nothing", Real, float, double) {
  Scene scene = test::hung_cloth(20, 20, 0.001);
  scene.effects.insert(scene.effects.end(), {Cables{{0, 5, 9}}, StiffeningSprings{1.0, 1.0, {1, 2}},
                                             Plasticity{.yield = 0.0, .rate = 1.0, .springs = {3, 4}},
                                             StrainLimit{.limit = 0.001}, Tethers{}});
  for (unsigned threads : {1u, 2u}) {
    Simulation<Real> simulation(scene, {.step = 1e-3, .threads = threads});
    REQUIRE(simulation.step(20).ok());
    const std::size_t before = allocations;
    const Report report = simulation.step(50);
    CHECK(allocations == before);
    CHECK(report.limit_sweeps > 0);
  }
}
