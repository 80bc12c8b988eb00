#include "run_outputs.hpp"

#include "export/events.hpp"
#include "export/trace.hpp"
#include "view/paint.hpp"
#include "view/text_screen.hpp"

namespace carom {

namespace {

OutputFile opened(const char* option, const std::string& name, const Options& options) {
  if (options.checkpoint.empty()) return OutputFile(option, name);
  return {option, name, OutputFile::Kept{}};
}

}  // namespace

RunOutputs::RunOutputs(const Options& options)
    : options_(options),
      dump_(opened("--dump", options.dump, options)),
      trajectory_(opened("--trajectory", options.trajectory, options)),
      events_(opened("--events", options.events, options)),
      series_(opened("--series", options.series, options)),
      trace_("--trace", options.trace),
      cast_(opened("--cast", options.cast, options)) {}

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

void RunOutputs::prepare(Session& session, const std::optional<Measurements>& before) {
  session_ = &session;
  recorder_.emplace(session, wanted(), before);
  if (trajectory_) trajectory_text_.emplace(session.scene());
  if (series_) series_text_.emplace(session.scene());
  if (trace_) session.simulation().record_timeline(options_.trace_frames);
}

bool RunOutputs::go_on(Session& session, const Checkpoint& from) {
  prepare(session, from.measured);
  const auto files = growing();
  for (std::size_t k = 0; k < files.size(); ++k) {
    for (const auto& [option, length] : from.files) {
      if (option == kGrowing[k] && !files[k]->go_on_after(length)) return false;
    }
  }
  if (series_) series_text_->begin_at(session.simulation().time());
  if (cast_) {
    const std::string text = picture(from.frame);
    (void)changes_.next(text.substr(text.find('\n') + 1));
  }
  return true;
}

void RunOutputs::keep(Checkpoint& checkpoint) {
  const auto files = growing();
  for (std::size_t k = 0; k < files.size(); ++k) {
    if (*files[k]) checkpoint.files.emplace_back(kGrowing[k], files[k]->keep());
  }
}

void RunOutputs::begin(Session& session, std::uint64_t number) {
  prepare(session, {});
  if (!options_.checkpoint.empty()) {
    for (OutputFile* file : growing()) (void)file->go_on_after(0);
  }
  if (events_) events_.write(events_header());
  if (series_) series_.write(SeriesText::header());
  if (cast_) {
    cast_.write(CastText(options_.columns, options_.rows, session.scene().name).header());
  }
  frame(number);
  for (OutputFile* file : files()) file->flush();
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
  for (OutputFile* file : files()) file->commit();
}

}  // namespace carom
