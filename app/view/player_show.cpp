// What a player shows.
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "carom/report.hpp"
#include "view/arrows.hpp"
#include "view/ball_numbers.hpp"
#include "view/help_panel.hpp"
#include "view/instruments_panel.hpp"
#include "view/panel.hpp"
#include "view/player.hpp"
#include "view/status.hpp"

namespace carom {
namespace {

constexpr std::chrono::milliseconds kEnergyEvery{500};
constexpr double kFallsBehind = 0.95;  // of the speed wanted; below, the status says so
constexpr int kDoubleDigits = 16;
constexpr int kLeastColumns = 20;
constexpr int kLeastRows = 8;
constexpr const char* kPickerKeys = " arrows or a letter: choose  Enter: play it  Esc: back";
constexpr int kRowsForHints = 12;  // screens this high have a second line below

}  // namespace

int Player::lines_below(int rows) {
  return rows >= kRowsForHints ? 2 : 1;
}

void Player::show() {
  const UserInterface::Size size = interface_.size();
  Canvas screen(size.columns, size.rows);
  changed_ = false;
  if (size.columns < kLeastColumns || size.rows < kLeastRows) {
    screen.write(0, 0, "too small:", Ink::notice);
    screen.write(0, 1, fmt::format("{}x{} is least", kLeastColumns, kLeastRows), Ink::notice);
    return put_on_screen(screen);
  }
  const int below = size.rows - lines_below(size.rows);
  lay_over(picture(size.columns, below), 0, 0, screen);
  paint_lines_below(screen, below);
  put_on_screen(screen);
}

void Player::put_on_screen(const Canvas& screen) {
  interface_.show(screen);
  if (!recorder_) return;
  try {
    recorder_->picture(interface_.now(), screen, title());
  } catch (const std::system_error& error) {
    recording_error_ = error.what();
    recorder_.reset();
    say("the recording has ended: " + recording_error_);
  }
}

void Player::finish_recording() {
  if (!recorder_) return;
  try {
    recorder_->finish(interface_.now());
  } catch (const std::system_error& error) {
    recording_error_ = error.what();
  }
  recorder_.reset();
}

Docks Player::docks(int columns, int rows) const {
  // The bar of time stands below the panels, and on the lower side of a box without any.
  const bool below = threads_.open() || (instruments_.open() && columns < kWideScreen);
  if (below && scrub_bar_now()) --rows;
  DockWishes wishes;
  wishes.threads_first = threads_first_;
  if (instruments_.open())
    wishes.instruments =
        columns >= kWideScreen ? kRowsOfInstrumentsStacked : kRowsOfInstrumentsBeside;
  if (cost_shown_ && columns >= kWideScreen) wishes.cost = rows_of_cost(reference_.has_value());
  if (threads_.open()) wishes.threads = threads_.rows_wanted(session_->simulation());
  return docks_for(wishes, session_->scene().box, columns, rows);
}

UserInterface::Size Player::box_size() const {
  const UserInterface::Size size = interface_.size();
  const Docks places = docks(size.columns, size.rows - lines_below(size.rows));
  return {places.box.columns, places.box.rows};
}

/// The balls, and what is drawn over and under them.
void Player::paint_box(Canvas& box) const {
  const Simulation& simulation = session_->simulation();
  const Frame* const before = threads_.before(simulation);
  const Frame frame = before != nullptr ? *before : simulation.frame();
  paint(frame, box, drawing_);
  if (arrows_shown_) paint_arrows(frame, simulation.state(), box, drawing_);
  if (trails_.shown()) trails_.paint(frame, box, drawing_);
  if (numbers_shown_) paint_numbers(frame, simulation.ids(), box, drawing_);
}

Canvas Player::picture(int columns, int rows) {
  if (picker_) return picker_->picture(columns, rows, drawing_.glyphs);
  Canvas picture(columns, rows);
  const Docks places = docks(columns, rows);
  Canvas box(places.box.columns, places.box.rows);
  follow_selected();
  paint_box(box);
  if (reference_) paint_reference(reference_->frame(), box, drawing_);
  lay_over(box, 0, 0, picture);
  const auto place = [&](const Canvas& panel, const CellRect& at) {
    lay_over(panel, at.column, at.row, picture);
  };
  if (!places.instruments.empty())
    place(instruments_panel(instruments_.readings(), places.instruments.columns,
                            places.instruments.rows, drawing_.glyphs),
          places.instruments);
  if (!places.threads.empty())
    place(threads_panel(threads_.view(), places.threads.columns, places.threads.rows,
                        drawing_.glyphs),
          places.threads);
  if (cost_shown_) {
    const bool docked = !places.cost.empty();
    const CellRect& room = docked ? places.cost : places.box;
    const Canvas panel = cost_panel(cost(), room.columns, room.rows, drawing_.glyphs);
    lay_over(panel, docked ? room.column : room.columns - panel.columns, room.row, picture);
  }
  paint_selected(picture);
  if (const auto bar = scrub_bar_now())
    lay_over(scrub_bar(*bar, columns, drawing_.glyphs), 0, rows - 1, picture);
  if (help_page_ >= 0) {
    // The screen may have grown since, and the help have fewer pages.
    help_page_ = std::min(help_page_, help_pages(picture) - 1);
    paint_help(picture, help_page_, drawing_.glyphs);
  }
  return picture;
}

/// The status and what keys do, or what one just did.
void Player::paint_lines_below(Canvas& screen, int first) {
  const Simulation& simulation = session_->simulation();
  const Instant now = interface_.now();
  const bool running = !session_->paused() && !picker_;
  if (now >= energy_due_ || !running) {
    energy_error_ = history_.measured(*session_).relative_energy_error();
    energy_due_ = now + kEnergyEvery;
  }
  if (now >= notice_until_ && running) notice_.clear();
  if (running) {
    meter_.record(now, simulation.time(), computing_);
    ++frames_;
  } else {
    meter_.reset();
  }
  Status status;
  status.scene = scene_.name.empty() ? "carom" : scene_.name;
  status.balls = simulation.balls();
  status.workers = simulation.workers();
  status.time = simulation.time();
  status.frames_per_second = meter_.frames_per_second();
  status.computing_milliseconds = running ? meter_.computing_milliseconds() : 0;
  status.energy_error = energy_error_;
  if (piles_up_) status.note = fmt::format("overlap: {}", kPilesUp);
  if (recorder_) status.note = "recording";
  status.late = timer_.late();
  status.speed = speed_;
  status.paused = !running;
  const auto pace = meter_.pace();
  if (pace && *pace < kFallsBehind * speed_) status.pace = pace;

  const bool two = screen.rows - first > 1;
  if (two || notice_.empty())
    screen.write(0, first, status_line(status, screen.columns), Ink::status);
  const int last = screen.rows - 1;
  if (picker_ && notice_.empty()) {
    screen.write(0, last, kPickerKeys, Ink::notice);
  } else if (!notice_.empty()) {
    screen.write(0, last, ' ' + notice_, Ink::notice);
  } else if (two) {
    screen.write(0, last,
                 hint_line(key_hints(screen.columns, !running, effect_keys(scene_.effects))),
                 Ink::status);
  }
}

Cost Player::cost() const {
  const Simulation& simulation = session_->simulation();
  const Measurements measured = history_.measured(*session_);
  Cost cost;
  cost.method = method_name(simulation.method());
  if (simulation.method() == Method::overlap || scene_.effects.attraction) {
    const std::string step = fmt::format("step 1/{:.6g} s", 1 / simulation.step());
    cost.method += ", " + step;
    cost.precision = step;
  } else {
    const int digits = session_->scene().solver.digits;
    cost.method += fmt::format(", {} digits", digits);
    cost.precision =
        digits == kDoubleDigits ? "double precision" : fmt::format("{} digits", digits);
  }
  cost.milliseconds = meter_.computing_milliseconds();
  cost.dissipated = measured.energy_dissipated;
  cost.energy_error = measured.relative_energy_error();
  cost.max_overlap = measured.max_overlap;
  if (!reference_) return cost;
  cost.reference.emplace();
  cost.reference->name = reference_->name();
  cost.reference->milliseconds = std::chrono::duration<double, std::milli>(reference_cost_).count();
  cost.reference->distance = reference_->distance();
  cost.reference->span = reference_->span();
  cost.reference->horizon = reference_->horizon();
  const Frame frame = simulation.frame();
  for (const FrameBall& ball : frame.balls) {
    double& radius = cost.reference->radius;
    radius = radius == 0 ? ball.radius : std::min(radius, ball.radius);
  }
  return cost;
}

}  // namespace carom
