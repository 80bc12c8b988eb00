#include "view/history.hpp"

#include <algorithm>
#include <iterator>

#include "export/frame_record.hpp"

namespace carom {
namespace {

constexpr std::chrono::milliseconds kEvery{200};  // real time from checkpoint to checkpoint
constexpr int kShare = 50;                        // a checkpoint costs one part of so many
constexpr std::size_t kMostFrames = 100000;
constexpr std::size_t kFewest = 4;  // checkpoints that must fit; else there are none

/// What a scene takes in memory, for the most part.
std::size_t bytes_of(const Scene& scene) {
  std::size_t bytes = sizeof(Scene) + scene.balls.size() * sizeof(Ball);
  if (!scene.continuation) return bytes;
  bytes += scene.continuation->flights.size() * sizeof(SavedFlight);
  for (const SavedFlight& flight : scene.continuation->flights) {
    for (const auto& pair : {flight.position, flight.velocity})
      bytes += pair[0].capacity() + pair[1].capacity();
    bytes += flight.start.capacity() + flight.spin.capacity();
  }
  return bytes;
}

/// The least that a checkpoint of so many balls takes.
std::size_t least_bytes(std::size_t balls) {
  return balls * sizeof(Ball);
}

}  // namespace

void History::begin(const Session& session, Instant now) {
  checkpoints_.clear();
  frames_.clear();
  frontier_.reset();
  measured_before_.reset();
  bytes_ = 0;
  last_ = session.simulation().time();
  due_ = now + kEvery;
  if (least_bytes(session.simulation().balls()) > kMostBytes / kFewest) return;
  add(session);
  frames_.push_back(last_);
  if (bytes_ > kMostBytes / kFewest) {
    checkpoints_.clear();
    bytes_ = 0;
  }
}

void History::note(const Session& session, const UserInterface& clock) {
  const double time = session.simulation().time();
  if (checkpoints_.empty() || time <= last_) return;
  last_ = time;
  frontier_.reset();
  frames_.push_back(time);
  if (frames_.size() > kMostFrames) frames_.pop_front();
  const Instant before = clock.now();
  if (before < due_) return;
  add(session);
  thin_out();
  const Instant after = clock.now();
  due_ = after + std::max<Instant::duration>(kEvery, kShare * (after - before));
}

void History::forget_after(const Session& session) {
  if (!is_past(session)) return;
  last_ = session.simulation().time();
  frontier_.reset();
  while (!frames_.empty() && frames_.back() > last_) frames_.pop_back();
  while (checkpoints_.size() > 1 && checkpoints_.back().time > last_) {
    bytes_ -= checkpoints_.back().bytes;
    checkpoints_.pop_back();
  }
}

double History::first() const {
  return checkpoints_.empty() ? last_ : checkpoints_.front().time;
}

double History::frame_before(double time, int frames) const {
  const auto at = std::lower_bound(frames_.begin(), frames_.end(), time) - frames_.begin();
  // After a moment between two frames the first is the next one.
  const bool between = at == static_cast<std::ptrdiff_t>(frames_.size()) ||
                       frames_[static_cast<std::size_t>(at)] > time;
  const std::ptrdiff_t wanted = at - frames - (frames < 0 && between ? 1 : 0);
  if (wanted < 0) return first();
  if (wanted >= static_cast<std::ptrdiff_t>(frames_.size())) return last_;
  return frames_[static_cast<std::size_t>(wanted)];
}

void History::go_back(std::unique_ptr<Session>& session, double time) {
  if (!frontier_) {
    Scene saved = session->save();
    frontier_ = {session->log(), std::move(saved.script), saved.continuation->clock};
  }
  const auto after = std::upper_bound(
      checkpoints_.begin(), checkpoints_.end(), time,
      [](double moment, const Checkpoint& checkpoint) { return moment < checkpoint.time; });
  const Checkpoint& from = after == checkpoints_.begin() ? *after : *std::prev(after);
  Scene scene = from.scene;
  scene.script = frontier_->rest;
  scene.continuation->clock = frontier_->clock;
  scene.continuation->paused = true;
  session.reset();  // its threads end before as many start again
  session = std::make_unique<Session>(std::move(scene));
  session->simulation().go_on_from(from.bookkeeping);
  session->set_effects_when_on(from.when_on);
  Scene log = frontier_->log;
  log.script.resize(from.commands);
  session->go_on_from(log);
  measured_before_ = from.measured;
}

Measurements History::measured(const Session& session) const {
  const Measurements since = session.simulation().measure();
  return measured_before_ ? together(*measured_before_, since) : since;
}

void History::move_on(Session& session, double time) {
  const double end = std::min(time, last_);
  if (frontier_) {
    const std::vector<ScriptLine>& way = frontier_->log.script;
    while (session.commands() < way.size() && way[session.commands()].at <= end) {
      const ScriptLine& line = way[session.commands()];
      session.nudge_to(std::max(session.simulation().time(), line.at));
      session.apply(line.command);
    }
  }
  session.nudge_to(std::max(end, session.simulation().time()));
}

void History::add(const Session& session) {
  Checkpoint checkpoint;
  const Simulation& simulation = session.simulation();
  checkpoint.time = simulation.time();
  checkpoint.scene = simulation.save();
  checkpoint.bookkeeping = simulation.bookkeeping();
  checkpoint.when_on = session.effects_when_on();
  checkpoint.measured = measured(session);
  checkpoint.commands = session.commands();
  checkpoint.bytes = sizeof(Checkpoint) + bytes_of(checkpoint.scene) +
                     checkpoint.bookkeeping.ids.size() * sizeof(std::size_t) +
                     checkpoint.bookkeeping.losses.size() * sizeof(double);
  bytes_ += checkpoint.bytes;
  checkpoints_.push_back(std::move(checkpoint));
}

/// Takes out the checkpoint whose absence is the shortest way for its age.
void History::thin_out() {
  while (bytes_ > kMostBytes && checkpoints_.size() > 2) {
    const double end = checkpoints_.back().time;
    std::size_t least = 1;
    double shortest = 0;
    for (std::size_t i = 1; i + 1 < checkpoints_.size(); ++i) {
      const double gap = checkpoints_[i + 1].time - checkpoints_[i - 1].time;
      const double age = end - checkpoints_[i - 1].time;
      if (i > 1 && gap / age >= shortest) continue;
      shortest = gap / age;
      least = i;
    }
    bytes_ -= checkpoints_[least].bytes;
    checkpoints_.erase(checkpoints_.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

}  // namespace carom
