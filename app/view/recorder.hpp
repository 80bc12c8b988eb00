#pragma once

#include <optional>
#include <string>

#include "export/output_file.hpp"
#include "view/encoder.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// Writes what a screen shows, from the first picture on, as an asciicast.
///
/// Holds: the file is whole or not there at all, as `finish` decides.
/// Threads: the control thread only.
/// Errors: std::system_error that names the option and the file.
class Recorder {
 public:
  /// Opens the file, so that what cannot be written is found before anything is shown.
  Recorder(const std::string& option, const std::string& file, Palette palette);

  /// The screen shows this from `now` on.
  void picture(Instant now, const Canvas& canvas, const std::string& title);
  /// Writes the end and puts the file in its place.
  void finish(Instant now);
  [[nodiscard]] const std::string& file() const { return name_; }

 private:
  [[nodiscard]] double seconds(Instant now) const;

  std::string name_;
  OutputFile file_;
  Encoder encoder_;
  std::optional<Instant> begun_;
  UserInterface::Size size_;
};

}  // namespace carom
