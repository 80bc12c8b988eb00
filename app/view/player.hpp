#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "carom/session.hpp"
#include "view/ghost.hpp"
#include "view/meter.hpp"
#include "view/pacer.hpp"
#include "view/price.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// Plays a scene before a person: the loop of frames and keys.
///
/// Each frame is due at an absolute time.  When it is, the simulation moves on, slice by slice, and
/// is cut off when the time for the frame runs out: a simulation that cannot keep up slows down,
/// and the keys do not wait for it.  How it is sliced does not change where the balls go.
///
/// Threads: the control thread only.
/// Errors: what the simulation throws, a worker's exception too, leaves `play`.
class Player {
 public:
  static constexpr double kFramesPerSecond = 30;

  Player(Scene scene, UserInterface& interface);

  /// Plays until somebody quits.  Gives 0, or the number of the signal that ended it.
  int play();

  /// The run in one line.
  [[nodiscard]] std::string summary() const;

 private:
  void handle(const Event& event);
  void press(char key);
  bool obey(const Command& command, const std::string& notice);  ///< says whether it was done
  void add_balls(int count);
  void change_step(double factor);
  void change_speed(double factor);
  bool toggle_effect(char key);
  void change_method();
  void toggle_ghost();
  void begin_ghost();
  void follow();
  [[nodiscard]] Price price() const;
  void restart();

  void handle_events_until(Instant due);
  void compute();
  void show();
  void say(std::string notice);
  [[nodiscard]] bool idle() const;

  Scene scene_;
  UserInterface& interface_;
  std::optional<Session> session_;
  Pacer pacer_;
  Meter meter_;

  double speed_ = 1;       // simulated seconds per real one
  double single_ = 0;      // simulated seconds still to go of single frames asked for
  double slice_cost_ = 0;  // real seconds per simulated second, as last seen
  std::chrono::duration<double> computing_{0};
  std::array<bool, kEffectCount> switched_off_{};  // by the order of the table of effects
  int help_page_ = -1;                             // no help
  std::uint64_t added_ = 0;

  bool priced_ = false;                          // the panel is open
  std::optional<Ghost> ghost_;                   // the comparison
  std::chrono::duration<double> ghost_cost_{0};  // of a frame, smoothed

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
