#include "export/series.hpp"

#include <fmt/format.h>

namespace carom {
namespace {

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

std::string SeriesText::header() {
  return "frame,time,balls,kinetic,potential,energy,input,dissipated,energy_error,momentum_x,"
         "momentum_y,temperature,pressure,Z,ball_ball,ball_wall,max_overlap,resting\n";
}

std::string SeriesText::line(const FrameRecord& record) {
  const Measurements& m = record.measured;
  const Fluid fluid = meter_.measure(record.time, record.balls, record.impacts);
  const double kinetic = potential_ ? fluid.kinetic : m.energy_final;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", record.frame,
                     record.time, record.balls.size(), kinetic, m.energy_final - kinetic,
                     m.energy_final, m.energy_input, m.energy_dissipated, m.relative_energy_error(),
                     m.momentum_final.x(), m.momentum_final.y(), number(fluid.temperature),
                     number(fluid.pressure), number(fluid.Z), m.ball_ball, m.ball_wall,
                     m.max_overlap, m.resting_contacts);
}

}  // namespace carom
