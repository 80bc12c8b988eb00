#pragma once

#include <string>

#include "carom/accuracy.hpp"
#include "export/output_file.hpp"

namespace carom {

/// A drawing of a study that gnuplot makes: error against time, both logarithmic.
///
/// Holds: the file is written whole or not at all, as OutputFile does.
/// Errors: std::runtime_error where gnuplot is not installed, found before anything runs, or fails;
/// std::system_error as OutputFile.
class Gnuplot {
 public:
  /// An empty name is no drawing.
  /// REQUIRES: else it ends in .svg or .png.
  Gnuplot(const std::string& option, const std::string& file);

  void draw(const AccuracyStudy& study);
  void commit() { file_.commit(); }

 private:
  std::string option_;
  bool png_;
  OutputFile file_;
};

/// The commands for gnuplot.
std::string gnuplot_script(const AccuracyStudy& study, bool png);

}  // namespace carom
