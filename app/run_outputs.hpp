#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "carom/session.hpp"
#include "checkpoint.hpp"
#include "export/cast.hpp"
#include "export/frame_record.hpp"
#include "export/output_file.hpp"
#include "export/series.hpp"
#include "export/trajectory.hpp"
#include "options.hpp"

namespace carom {

/// The files that a run writes along the way: dump, trajectory, events, series, trace and cast.
///
/// Holds: a file that is not asked for costs nothing.
/// Errors: std::system_error that names the option and the file.
class RunOutputs {
 public:
  /// Opens the files, so that what cannot be written is found before anything runs.
  explicit RunOutputs(const Options& options);

  /// Whether frames are looked at.
  [[nodiscard]] bool look_at_frames() const;
  /// Writes what comes before the first frame, and that, so that a full disk is found.
  void begin(Session& session, std::uint64_t number);
  /// Goes on after an earlier part of the run instead; false where its files are gone.
  [[nodiscard]] bool go_on(Session& session, const Checkpoint& from);
  /// Whether a frame is written, after which there can be a checkpoint.
  [[nodiscard]] bool leaves(std::uint64_t number) const { return number % options_.every == 0; }
  /// Sees to it that all of the files is on the disk, and adds how long they are.
  void keep(Checkpoint& checkpoint);
  /// Writes a frame, if --every leaves it.
  void frame(std::uint64_t number);
  /// Writes what comes after the last one.
  void end(std::uint64_t frames);
  void commit();

 private:
  [[nodiscard]] std::array<OutputFile*, 6> files() {
    return {&dump_, &trajectory_, &events_, &series_, &trace_, &cast_};
  }
  /// Those that grow frame by frame, in the order of kGrowing.
  [[nodiscard]] std::array<OutputFile*, 5> growing() {
    return {&dump_, &trajectory_, &events_, &series_, &cast_};
  }
  static constexpr std::array kGrowing{"--dump", "--trajectory", "--events", "--series", "--cast"};
  void prepare(Session& session, const std::optional<Measurements>& before);
  [[nodiscard]] FrameRecorder::Wanted wanted() const;
  [[nodiscard]] std::string picture(std::uint64_t number) const;

  const Options& options_;
  OutputFile dump_;
  OutputFile trajectory_;
  OutputFile events_;
  OutputFile series_;
  OutputFile trace_;
  OutputFile cast_;
  Session* session_ = nullptr;
  std::optional<FrameRecorder> recorder_;
  std::optional<TrajectoryText> trajectory_text_;
  std::optional<SeriesText> series_text_;
  PictureChanges changes_;
};

}  // namespace carom
