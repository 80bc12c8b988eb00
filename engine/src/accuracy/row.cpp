#include "accuracy/row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "accuracy/timing.hpp"
#include "carom/scene_file.hpp"

namespace carom::accuracy {

AccuracyRow new_row(const Way& way, const AccuracyCrew& crew, std::size_t balls) {
  AccuracyRow row;
  row.method = way.method;
  row.step = way.step;
  row.digits = way.digits;
  row.per_ball = crew.per_ball;
  row.workers = crew.per_ball ? std::max<std::size_t>(1, balls) : crew.workers;
  return row;
}

void fill_row(AccuracyRow& row, const std::function<void()>& fill) {
  try {
    fill();
  } catch (const StopAsked&) {
    throw;
  } catch (const SceneError& error) {
    row.failure = error.problems().front().place + ": " + error.problems().front().message;
  } catch (const std::exception& error) {
    row.failure = error.what();
  }
}

std::string why_last(const AccuracyRow& row, const std::string& name, double limit) {
  if (!row.failure.empty()) return fmt::format("{}: {}", name, row.failure);
  if (!(row.seconds > limit)) return "";
  return fmt::format("{} took {:.3g} s, and the time limit of a run is {:.3g} s; --share raises it",
                     name, row.seconds, limit);
}

}  // namespace carom::accuracy
