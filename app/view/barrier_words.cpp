#include "view/barrier_words.hpp"

namespace carom {
namespace {

std::string flown(Computation computation, bool pairs) {
  const bool events = computation == Computation::events;
  std::string words =
      events
          ? "The path of every ball through this window is known, each computed by one worker as "
            "if the ball were alone."
          : "Every ball has flown one step, each moved by one worker as if the ball were alone.";
  if (!pairs) return words;
  words += " No pair is tested before the last worker arrives: all pairs see the same ";
  return words + (events ? "paths." : "positions.");
}

std::string pulled(Computation computation) {
  std::string words =
      "The pull on every ball is summed, by one worker each, all from the same "
      "positions. ";
  if (computation == Computation::integrated)
    return words + "New positions are kept apart until all workers have read the old ones.";
  return words + "This phase writes velocities and moves no ball.";
}

std::string tested(Computation computation) {
  switch (computation) {
    case Computation::overlap:
      return "Every pair of neighbours has been tested once, boxes first. The hits are known; no "
             "ball has been changed by them yet.";
    case Computation::events:
      return "Every pair of neighbours has been tested, boxes first. Balls whose paths meet form a "
             "conflict group; no path has changed yet.";
    case Computation::integrated:
      break;
  }
  return "Each worker has searched its share for the first contact. The earliest contact "
         "of all workers ends this piece of the step.";
}

std::string resolved(Computation computation) {
  if (computation == Computation::events)
    return "Each conflict group was solved exactly by one worker. Groups share no ball; where "
           "changed paths meet, groups merge and are solved again.";
  return "Each group of touching balls was resolved by one worker. Groups share no ball, so the "
         "result does not depend on which worker was faster.";
}

}  // namespace

std::string guarantee_of(std::string_view barrier, Computation computation, bool pairs) {
  if (barrier == "do_frame")
    return "The control thread has ordered a frame and waits at frame_done. From here to "
           "frame_done "
           "only the workers touch the balls.";
  const bool searches = barrier == "wall_computation" && computation == Computation::integrated;
  if (barrier == "pair_computation" || searches) return tested(computation);
  if (barrier == "wall_computation" || barrier == "flight") return flown(computation, pairs);
  if (barrier == "neighbour_search")
    return "The neighbours of every ball are listed. From here on the lists are only read.";
  if (barrier == "pair_resolution") return resolved(computation);
  if (barrier == "attraction") return pulled(computation);
  if (barrier == "frame_done")
    return "All workers are done and wait at do_frame. Only now does the control thread look at "
           "the "
           "balls: the picture shows the new positions.";
  return "All workers have finished this phase; none has begun the next one before.";
}

std::string guarantee_between_frames() {
  return "All workers wait at do_frame. The control thread is alone: keys and the script change "
         "the "
         "scene here, between frames.";
}

}  // namespace carom
