#include "export/frame_record.hpp"

namespace carom {

FrameRecorder::FrameRecorder(Session& session, const Wanted& wanted)
    : session_(session), wanted_(wanted) {
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
  if (wanted_.measured) record.measured = simulation.measure();
  if (wanted_.impacts) record.impacts = simulation.take_impacts(last);
  return record;
}

}  // namespace carom
