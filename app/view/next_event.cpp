#include "view/next_event.hpp"

#include <algorithm>
#include <utility>

#include "carom/scene_file.hpp"

namespace carom {
namespace {

constexpr double kFirstSlice = 1.0 / 240;
constexpr double kGrows = 1.5;

bool is_met(const Impact& impact, std::size_t ball) {
  const bool meets = impact.kind == ImpactKind::ball || impact.kind == ImpactKind::wall ||
                     impact.kind == ImpactKind::joint;
  return meets && (impact.a == ball || impact.b == ball);
}

}  // namespace

/// False once the event is past, or a command has made it another run.
bool NextEvent::holds(const Session& session, std::size_t id) const {
  const Simulation& run = session.simulation();
  if (id != id_ || run.balls() != balls_ || run.measure().energy_input != energy_input_ ||
      run.time() < begun_)
    return false;
  if (found_) return run.time() <= found_->time;
  return none_ ? run.time() < begun_ + kFarthest / 2 : ahead_ != nullptr;
}

void NextEvent::begin(const Session& session) {
  const Simulation& run = session.simulation();
  Scene scene = run.save();
  scene.script.clear();
  scene.per_ball = false;
  scene.workers = 1;
  ahead_ = std::make_unique<Simulation>(scene);
  ahead_->record_impacts(true);
  balls_ = run.balls();
  energy_input_ = run.measure().energy_input;
  begun_ = run.time();
  slice_ = kFirstSlice;
}

void NextEvent::look(const Session& session, std::size_t id, const std::function<bool()>& in_time) {
  if (!holds(session, id)) {
    ahead_.reset();
    found_.reset();
    none_ = false;
    id_ = id;
    begin(session);
  }
  if (!ahead_) return;
  const std::vector<std::size_t>& ids = session.simulation().ids();
  // The copy counts its balls from 0 on.
  const auto ball = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  do {
    ahead_->advance_to(ahead_->time() + slice_);
    slice_ *= kGrows;
    for (Impact impact : ahead_->take_impacts()) {
      if (!is_met(impact, ball) || impact.time < session.simulation().time()) continue;
      if (impact.b == ball) std::swap(impact.a, impact.b);
      impact.a = id;
      if (impact.b != Impact::kNoBall) impact.b = ids[impact.b];
      found_ = impact;
      ahead_.reset();
      return;
    }
    none_ = ahead_->time() > begun_ + kFarthest;
  } while (!none_ && in_time());
  if (none_) ahead_.reset();
}

}  // namespace carom
