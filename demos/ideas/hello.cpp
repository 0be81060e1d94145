// hello: a scene, a simulation, one loop. A cloth is held level and let go at all but two corners.
#include <hooke/hooke.h>
#include "ideas/account/account.h"
#include "ideas/account/show.h"

void hello(hooke::ideas::Account& account) {
  hooke::Scene scene;
  hooke::ClothGrid kind{.columns = 64, .rows = 64, .spacing = 0.016, .bend = 2, .damping = 1e-3};
  kind.placement = {.rotation_axis = {1, 0, 0}, .rotation_degrees = -80};
  const hooke::GridParticles cloth = hooke::add(scene, kind);
  scene.pin(cloth.at(0, 0));
  scene.pin(cloth.at(63, 0));
  scene.effects = {hooke::Gravity{}, hooke::Drag{.coefficient = 3e-5}};  // nothing else is simulated

  hooke::Simulation simulation(scene, {.step = 1e-4});
  const double start = simulation.energy().total();
  bool only_lost = true;
  while (simulation.time() < account.seconds(0.32)) {
    account.measure([&] { return simulation.step(100); });
    only_lost = only_lost && simulation.energy().total() < start;
  }
  const double lost = start - simulation.energy().total();
  account.claim(only_lost, "it only loses energy: %.2f J so far, to the air and in its threads", lost);
  account.print_cost(simulation);
  hooke::ideas::show(account.picture(), {hooke::ideas::moment(scene, simulation)}, {.azimuth = 0.7});
}

int main(int argc, char** argv) {
  return hooke::ideas::give_account(argc, argv, "hello: a cloth falls", hello);
}
