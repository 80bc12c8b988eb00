#include "solvers/event/event_memory.hpp"

#include "solvers/event/domains/domains.hpp"
#include "solvers/event/event_loop.hpp"
#include "solvers/event/make_core.hpp"
#include "solvers/event/suits_domains.hpp"
#include "solvers/event/wide_physics.hpp"

namespace carom::event {
namespace {

template <class P>
EventMemory of_event_loop(const Scene& scene, std::size_t balls) {
  const std::size_t spin = scene.effects.friction ? sizeof(typename P::Scalar) : 0;
  EventMemory memory;
  memory.flights = balls * (sizeof(typename P::Disk) + spin);
  if (scene.effects.collisions) memory.neighbours = balls * Neighbours<P>::kBytesOfBall;
  memory.queue = balls * EventQueue<typename P::Clock>::kBytesOfBall;
  return memory;
}

}  // namespace

EventMemory event_memory(const Scene& scene, const std::vector<Ball>& balls, std::size_t workers) {
  if (scene.solver.digits > kDigitsOfDouble) {
    return of_event_loop<WidePhysics>(scene, balls.size());
  }
  const Domain domain(scene.box, scene.effects.walls.has_value());
  const bool rests = may_rest(scene, balls);
  if (!suits_domains(scene.effects, domain, balls, rests, Sharing{}, workers)) {
    return of_event_loop<Ballistic>(scene, balls.size());
  }
  EventMemory memory;
  const bool spins = scene.effects.friction.has_value();
  memory.flights = Domains<Ballistic>::bytes_of_flights(balls.size(), workers, spins);
  memory.domains = Domains<Ballistic>::bytes_of_workers(balls.size(), workers);
  return memory;
}

}  // namespace carom::event
