// Choosing another scene, keeping the present one in a file, and recording.
#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "carom/crew.hpp"
#include "carom/scene_file.hpp"
#include "export/output_file.hpp"
#include "view/player.hpp"
#include "view/unused_name.hpp"

namespace carom {
namespace {

constexpr int kMostSteps = 100;  // of a key pressed again and again

}  // namespace

bool Player::press_for_scenes(int key) {
  switch (key) {
    case key::kTab:
      if (settings_.scene_library.names.empty()) {
        say("no scenes to choose from");
      } else {
        picker_.emplace(settings_.scene_library, scene_name_);
        notice_.clear();
      }
      return true;
    case 's':
      save_scene();
      return true;
    case 'o':
      toggle_recording();
      return true;
    default:
      return false;
  }
}

void Player::press_in_picker(int key, int times) {
  switch (key) {
    case key::kUp:
      return picker_->move(-times);
    case key::kDown:
      return picker_->move(times);
    case key::kEnter:
      return open_scene(picker_->chosen());
    case key::kTab:
    case key::kEscape:
    case 'q':
      picker_.reset();
      timer_.restart(interface_.now());
      return;
    default:
      if (key <= ' ' || key > '~') return;
      for (int i = 0; i < std::min(times, kMostSteps); ++i) picker_->seek(static_cast<char>(key));
  }
}

/// The old scene stays where the new one cannot be played.
void Player::open_scene(const std::string& name) {
  std::unique_ptr<Session> session;
  Scene scene;
  try {
    scene = settings_.scene_library.load(name);
    scene.played = true;
    session = std::make_unique<Session>(scene);
  } catch (const SceneError& error) {
    return say(error.problems().front().message);
  } catch (const CrewError& error) {
    return say(error.what());
  }
  picker_.reset();
  select({});
  reference_.reset();
  session_ = std::move(session);
  scene_ = std::move(scene);
  scene_name_ = name;
  drawing_.viewpoint = {};
  piles_up_ = choose_method(scene_).piles_up;
  begin_again();
  interface_.set_title(title());
  say("scene " + name);
}

void Player::save_scene() {
  if (settings_.folder.empty()) return say("there is no folder to write to");
  const std::string name = unused_name(settings_.folder, scene_.name, ".json");
  try {
    OutputFile file("s", name);
    file.write(write_scene(session_->save()));
    file.commit();
    say("saved as " + name);
  } catch (const std::system_error& error) {
    say(error.what());
  }
}

void Player::toggle_recording() {
  if (recorder_) {
    const std::string name = recorder_->file();
    finish_recording();
    return say(recording_error_.empty() ? "recorded " + name : recording_error_);
  }
  if (settings_.folder.empty()) return say("there is no folder to write to");
  try {
    recorder_ = std::make_unique<Recorder>("o", unused_name(settings_.folder, scene_.name, ".cast"),
                                           settings_.palette);
    say("recording: o ends it");
  } catch (const std::system_error& error) {
    say(error.what());
  }
}

}  // namespace carom
