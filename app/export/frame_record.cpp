#include "export/frame_record.hpp"

#include <algorithm>

namespace carom {

Measurements together(const Measurements& before, const Measurements& since) {
  Measurements all = since;
  all.ball_ball += before.ball_ball;
  all.ball_wall += before.ball_wall;
  all.joint_impacts += before.joint_impacts;
  all.resting_contacts += before.resting_contacts;
  all.jammed += before.jammed;
  all.islands_again += before.islands_again;
  all.missed_hits += before.missed_hits;
  all.energy_initial = before.energy_initial;
  all.energy_largest = std::max(before.energy_largest, since.energy_largest);
  all.momentum_initial = before.momentum_initial;
  all.max_overlap = std::max(before.max_overlap, since.max_overlap);
  return all;
}

FrameRecorder::FrameRecorder(Session& session, const Wanted& wanted,
                             const std::optional<Measurements>& before)
    : session_(session), wanted_(wanted), before_(before) {
  if (wanted_.impacts) session_.simulation().record_impacts(true);
}

FrameRecord FrameRecorder::record(std::uint64_t frame, bool last) {
  Simulation& simulation = session_.simulation();
  FrameRecord record;
  record.frame = frame;
  record.clock = session_.clock();
  record.time = simulation.time();
  if (wanted_.balls) {
    record.balls = simulation.state();
    record.ids = simulation.ids();
  }
  if (wanted_.state_hash) record.state_hash = simulation.state_hash();
  if (wanted_.measured) {
    record.measured = simulation.measure();
    if (before_) record.measured = together(*before_, record.measured);
  }
  if (wanted_.impacts) record.impacts = simulation.take_impacts(last);
  return record;
}

}  // namespace carom
