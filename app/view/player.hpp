#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "carom/session.hpp"
#include "view/aim.hpp"
#include "view/cost_panel.hpp"
#include "view/docks.hpp"
#include "view/frame_timer.hpp"
#include "view/history.hpp"
#include "view/instruments.hpp"
#include "view/keys.hpp"
#include "view/meter.hpp"
#include "view/next_event.hpp"
#include "view/paint.hpp"
#include "view/presses.hpp"
#include "view/recorder.hpp"
#include "view/reference_run.hpp"
#include "view/scrub_bar.hpp"
#include "view/selection_panel.hpp"
#include "view/settings.hpp"
#include "view/slice_cost.hpp"
#include "view/threads_watch.hpp"
#include "view/trails.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// Plays a scene before a person: the loop of frames and keys.
///
/// Each frame is due at an absolute time.  When it is, the simulation moves on, slice by slice, and
/// is cut off when the time for the frame runs out: a simulation that cannot keep up slows down.
/// All keys that wait are read before any is acted on: quit and pause come first, repeats count
/// together, and what takes long is spread over frames.  How it is sliced does not change where the
/// balls go.
///
/// Threads: the control thread only.
/// Errors: what the simulation throws, a worker's exception too, leaves `play`.
class Player {
 public:
  Player(Scene scene, UserInterface& interface, const Settings& settings = {});

  /// Writes what is shown from now on; before `play`.
  void record(std::unique_ptr<Recorder> recorder) { recorder_ = std::move(recorder); }
  /// Plays until somebody quits.  Gives 0, or the number of the signal that ended it.
  int play();

  /// The run in one line.
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] const Session& session() const { return *session_; }
  /// The glyphs that a key chose.
  [[nodiscard]] std::optional<Glyphs> chosen_glyphs() const { return chosen_glyphs_; }
  /// Why the recording failed; empty: it did not.
  [[nodiscard]] const std::string& recording_error() const { return recording_error_; }

 private:
  // The loop.
  void read_events_until(Instant due);
  void receive(const Event& event);
  void act();
  void compute();
  void say(std::string notice);
  [[nodiscard]] bool idle() const;
  [[nodiscard]] double frame_seconds() const;  ///< simulated, at the present speed

  // What keys do; `times` they were pressed.
  void press(int key, int times);
  bool press_in_help(int key, int times);
  void pause_or_go_on();
  bool obey(const Command& command, const std::string& notice);  ///< says whether it was done
  void add_balls(int count);
  void change_step(double factor);
  void change_speed(double factor);
  bool toggle_effect(int key, int times);
  void change_method();
  void toggle_reference();
  void begin_reference();
  void follow_reference();
  void next_glyphs();
  void note_frame(Instant now);
  void toggle_trails();
  void toggle_arrows();
  void toggle_numbers();
  void toggle_instruments();
  void toggle_threads();
  void toggle_slow_motion();
  void next_barrier();
  void zoom(double factor);
  void move_view(double columns, double rows);
  void restart();
  void begin_again();  ///< what has gone before does not count

  // Scenes and recordings.
  bool press_for_scenes(int key);
  void press_in_picker(int key, int times);
  void open_scene(const std::string& name);
  void save_scene();
  void toggle_recording();

  // Time back.
  bool press_for_time(int key, int times);
  void single_frames(int times);
  void go_to(double time);
  bool move_in_the_past(Instant limit);
  void changed_by_hand();
  [[nodiscard]] std::optional<ScrubBar> scrub_bar_now() const;  ///< where it is shown

  // What the mouse does.
  void use_mouse(const Mouse& mouse);
  void press_button(int column, int row);
  void scrub(int column);
  void use_mouse_in_picker(const Mouse& mouse);
  void throw_ball();
  [[nodiscard]] Camera camera() const;  ///< of the balls, as they are shown

  // The selected ball.
  bool press_for_selected(int key, int times);
  void select(std::optional<std::size_t> ball);  ///< by its place in the state
  void select_next(int times);
  [[nodiscard]] std::optional<std::size_t> selected_place() const;
  [[nodiscard]] SelectedBall selected_ball(std::size_t place) const;
  void look_ahead();
  void follow_selected();
  void paint_selected(Canvas& picture) const;

  // What is shown.
  [[nodiscard]] UserInterface::Size box_size() const;  ///< of the part with the balls
  static int lines_below(int rows);                    ///< of a screen: for the status and for keys
  void show();
  void put_on_screen(const Canvas& screen);
  void finish_recording();
  [[nodiscard]] std::string title() const;
  void paint_box(Canvas& box) const;
  [[nodiscard]] Canvas picture(int columns, int rows);
  void paint_lines_below(Canvas& screen, int first);
  [[nodiscard]] Docks docks(int columns, int rows) const;
  [[nodiscard]] Cost cost() const;

  Scene scene_;
  UserInterface& interface_;
  Settings settings_;
  std::unique_ptr<Session> session_;
  History history_;
  FrameTimer timer_;
  Meter meter_;
  Presses presses_;
  Drawing drawing_;

  double speed_ = 1;   // simulated seconds per real one
  double single_ = 0;  // simulated seconds still to go of single frames asked for
  SliceCost slice_cost_;
  std::chrono::duration<double> computing_{0};
  int help_page_ = -1;       // no help
  bool page_waits_ = false;  // a key waits that opens the help or the list of scenes
  std::uint64_t added_ = 0;

  bool cost_shown_ = false;
  std::optional<ReferenceRun> reference_;
  std::chrono::duration<double> reference_cost_{0};  // of a frame, smoothed

  std::optional<ScenePicker> picker_;  // the scene waits meanwhile
  std::string scene_name_;             // as the library has it; empty: another one
  std::optional<Glyphs> chosen_glyphs_;
  std::optional<double> seek_;           // a moment of the past that is on its way
  bool scrubbing_ = false;               // the button went down on the bar of time
  std::optional<Aim> aim_;               // the button is down
  std::optional<std::size_t> selected_;  // the number that it keeps, as of Simulation::ids
  bool followed_ = false;
  NextEvent next_event_;

  std::unique_ptr<Recorder> recorder_;
  std::string recording_error_;

  Trails trails_;
  bool arrows_shown_ = false;
  bool numbers_shown_ = false;
  Instruments instruments_;
  ThreadsWatch threads_;
  bool threads_first_ = false;  // they were opened last
  std::size_t calls_ = 0;       // of advance_to for the present frame

  bool piles_up_;  // overlap by default, for so many balls can pile up

  std::string notice_;
  Instant notice_until_;
  double energy_error_ = 0;
  Instant energy_due_;

  bool changed_ = true;  // there is something new to show
  bool quit_ = false;
  int signal_ = 0;
  std::uint64_t frames_ = 0;
};

}  // namespace carom
