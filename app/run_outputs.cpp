#include "run_outputs.hpp"

#include "export/events.hpp"
#include "export/trace.hpp"
#include "view/paint.hpp"
#include "view/text_screen.hpp"

namespace carom {

RunOutputs::RunOutputs(const Options& options)
    : options_(options),
      dump_("--dump", options.dump),
      trajectory_("--trajectory", options.trajectory),
      events_("--events", options.events),
      series_("--series", options.series),
      trace_("--trace", options.trace),
      cast_("--cast", options.cast) {}

bool RunOutputs::look_at_frames() const {
  return dump_ || trajectory_ || events_ || series_ || trace_ || cast_;
}

FrameRecorder::Wanted RunOutputs::wanted() const {
  FrameRecorder::Wanted wanted;
  wanted.balls = trajectory_ || series_;
  wanted.state_hash = static_cast<bool>(trajectory_);
  wanted.measured = static_cast<bool>(series_);
  wanted.impacts = events_ || series_;
  return wanted;
}

void RunOutputs::begin(Session& session) {
  session_ = &session;
  recorder_.emplace(session, wanted());
  if (trajectory_) trajectory_text_.emplace(session.scene());
  if (series_) series_text_.emplace(session.scene());
  if (trace_) session.simulation().record_timeline(options_.trace_frames);
  if (events_) events_.write(events_header());
  if (series_) series_.write(SeriesText::header());
  if (cast_) {
    cast_.write(CastText(options_.columns, options_.rows, session.scene().name).header());
  }
}

std::string RunOutputs::picture(std::uint64_t number) const {
  Canvas canvas(options_.columns, options_.rows);
  paint(session_->simulation().frame(), canvas);
  return to_text(canvas, number, session_->simulation().time());
}

void RunOutputs::frame(std::uint64_t number) {
  if (number % options_.every != 0) return;
  if (trajectory_ || events_ || series_) {
    const FrameRecord record = recorder_->record(number);
    if (trajectory_) trajectory_.write(trajectory_text_->frame(record));
    if (events_) events_.write(events_lines(record.impacts));
    if (series_) series_.write(series_text_->line(record));
  }
  if (!dump_ && !cast_) return;
  const std::string text = picture(number);
  if (dump_) dump_.write(text);
  if (!cast_) return;
  const std::string rows = text.substr(text.find('\n') + 1);  // below the frame's number
  cast_.write(CastText::output(session_->clock(), changes_.next(rows)));
}

void RunOutputs::end(std::uint64_t frames) {
  if (events_) events_.write(events_lines(recorder_->record(frames, true).impacts));
  if (cast_) cast_.write(CastText::output(session_->clock(), PictureChanges::end()));
  if (trace_) {
    trace_.write(trace_json(session_->simulation().timeline(), session_->scene().name));
  }
}

void RunOutputs::commit() {
  for (OutputFile* file : {&dump_, &trajectory_, &events_, &series_, &trace_, &cast_}) {
    file->commit();
  }
}

}  // namespace carom
