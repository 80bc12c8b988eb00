#pragma once

#include <string>

#include "sweep/axis.hpp"

namespace carom::sweeps {

/// What a point leaves: the report of its run without what depends on the machine, its values, and
/// the means of temperature, pressure and Z over the lines of its series.
/// Errors: std::runtime_error where the run wrote something else.
std::string point_report(const std::string& report, const std::string& series,
                         const std::vector<Axis>& axes, const std::vector<std::string>& values);

/// A line a point: `reports` by point, empty where there is none.
std::string runs_csv(const std::vector<Axis>& axes, const std::vector<std::string>& reports);

/// The grid without the seed: how many runs, and mean and standard error of each quantity.
std::string summary_csv(const std::vector<Axis>& axes, const std::vector<std::string>& reports);

}  // namespace carom::sweeps
