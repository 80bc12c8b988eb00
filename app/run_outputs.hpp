#pragma once

#include <cstdint>
#include <optional>

#include "carom/session.hpp"
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
  /// Writes what comes before the first frame.
  void begin(Session& session);
  /// Writes a frame, if --every leaves it.
  void frame(std::uint64_t number);
  /// Writes what comes after the last one.
  void end(std::uint64_t frames);
  void commit();

 private:
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
