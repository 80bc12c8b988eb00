#include "solvers/overlap/step_flight.hpp"

#include <algorithm>

#include "effects/attraction.hpp"
#include "effects/drag.hpp"
#include "effects/gravity.hpp"
#include "effects/periodic.hpp"
#include "state/stopwatch.hpp"

namespace carom::overlap {

void StepFlight::fly(Share share, bool timed, bool recording, Work& work) const {
  pairs_.begin_moves(share.index);
  const std::size_t begin = share.begin(balls_.size());
  const std::size_t end = share.end(balls_.size());
  if (balls_.pull[0].size() > 0) {
    const Stopwatch stopwatch(timed, work.seconds.of<Attraction>());
    effects::kick(balls_, rules_.step / 2, begin, end);
  }
  work.bullets.clear();
  work.out.clear();
  if (rules_.contacts_last) contacts_.begin(balls_, begin, end);
  if (rules_.collides)
    find_bullets(balls_, begin, end, rules_.step, rules_.smallest_radius, work.bullets);
  for (std::size_t i = begin; i < end; i += Flight::kBlock) {
    const std::size_t block_end = std::min(i + Flight::kBlock, end);
    if (rules_.contacts_last) {
      fly_lasting(i, block_end, timed, recording, work);
    } else if (rules_.collision.wall_friction > 0) {
      rub_walls(i, block_end, timed, recording, work);
    } else {
      fly_block(i, block_end, timed, recording, work, nullptr);
      if (recording) note_walls(i, nullptr, work);
    }
    if (pairs_.listed()) {
      const Stopwatch stopwatch(timed, work.seconds.of<Collisions>());
      pairs_.note_moves(share.index, i, block_end);
    }
  }
}

void StepFlight::fly_lasting(std::size_t begin, std::size_t end, bool timed, bool recording,
                             Work& work) const {
  std::vector<double>& lost = losses_.by_ball;
  std::array<double, Flight::kBlock> before{};
  const bool keeps = rules_.drag_rate > 0;
  if (keeps) {
    std::copy_n(lost.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, before.begin());
  }
  fly_block(begin, end, timed, recording, work, nullptr);
  // What is asleep does not move: drag takes nothing.
  for (std::size_t k = begin; keeps && k < end; ++k) {
    if (contacts_.asleep(k)) lost[k] = before[k - begin];
  }
  contacts_.end(balls_, begin, end, work.out);
}

void StepFlight::rub_walls(std::size_t begin, std::size_t end, bool timed, bool recording,
                           Work& work) const {
  effects::Struck struck;
  fly_block(begin, end, timed, recording, work, &struck);
  const Stopwatch stopwatch(timed, work.seconds.of<Friction>());
  effects::FrictionBlock by_friction;
  effects::apply_wall_frictions(balls_, begin, end - begin, struck, rules_.collision.wall_friction,
                                &losses_.by_ball[begin], recording ? &by_friction : nullptr);
  if (recording) note_walls(begin, &by_friction, work);
}

void StepFlight::fly_block(std::size_t begin, std::size_t end, bool timed, bool recording,
                           Work& work, effects::Struck* struck) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Glide& glide = rules_.glide[axis];
    Flight flight;
    prepare(flight, balls_, axis, begin, end, rules_.step, glide);
    if (!losses_.by_ball.empty()) flight.lost = losses_.by_ball.data() + begin;
    if (rules_.drag_rate > 0) {
      const Stopwatch stopwatch(timed, work.seconds.of<Drag>());
      effects::drag(flight);
    } else {
      straight(flight);
    }
    if (glide.gain != 0) {
      const Stopwatch stopwatch(timed, work.seconds.of<Gravity>());
      effects::gravity(flight);
    }
    land(flight);
    if (domain_.solid(axis)) {
      if (!rules_.contacts_last) {
        const Stopwatch stopwatch(timed, work.seconds.of<Walls>());
        work.impacts.ball_wall +=
            effects::walls(flight, domain_, rules_.wall[axis],
                           struck == nullptr ? nullptr : struck->normal[axis].data(),
                           recording ? &work.at_walls[axis] : nullptr);
      }
    } else if (domain_.period[axis] > 0) {
      effects::wrap(flight, domain_, turns_[axis].empty() ? nullptr : turns_[axis].data());
    }
    store(flight, balls_);
  }
}

void StepFlight::note_walls(std::size_t begin, const effects::FrictionBlock* by_friction,
                            Work& work) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const effects::WallImpact& met : work.at_walls[axis]) {
      const std::size_t i = begin + met.k;
      effects::Member ball;
      ball.ball = static_cast<std::uint32_t>(i);
      ball.position = balls_.at(i);
      ball.radius = balls_.radius[i];
      ball.mass = balls_.mass[i];
      effects::note_wall(met, axis, ball,
                         by_friction == nullptr ? FrictionChange{} : (*by_friction)[axis][met.k],
                         work.impacts.log);
    }
    work.at_walls[axis].clear();
  }
}

}  // namespace carom::overlap
