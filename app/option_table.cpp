#include "option_table.hpp"

#include <array>

#include "values.hpp"

namespace carom {
namespace {

using C = Options::Command;

constexpr std::size_t kManyScenes = static_cast<std::size_t>(-1);

const char* const kScene = "a scene file, the name of an installed scene, or - for standard input";
const char* const kFiles =
    "A FILE of - is standard output; the text then goes to standard error.\n"
    "A file is written whole or not at all.";

std::vector<OptionRow> make_options() {
  const std::vector<C> every{C::play, C::run, C::accuracy, C::check, C::verify, C::sweep};
  const std::vector<C> not_accuracy{C::play, C::run, C::check, C::verify, C::sweep};
  const std::vector<C> takes_scene{C::play, C::run, C::accuracy, C::check, C::sweep};
  const std::vector<C> sweep{C::sweep};
  const std::vector<C> play{C::play};
  const std::vector<C> run{C::run};
  const std::vector<C> accuracy{C::accuracy};
  const std::vector<C> verify_only{C::verify};
  return {
      // Of every command; the order is that of the help.
      {every, "--method", "METHOD", "how the motion is computed:", method()},
      {every, "--step", "SECONDS", "length of a time step; default: the scene's, else 1/240",
       seconds(&Options::step, false)},
      {every, "--digits", "DIGITS", "decimal digits of method event:", digits()},
      {not_accuracy, "--workers", "WORKERS",
       "worker threads: a number, or per-ball; never changes the result", workers()},
      {accuracy, "--workers", "WORKERS",
       "worker threads, as in 1,2,per-ball: the first for all runs, the rest for one run of each "
       "method",
       list_of_workers()},
      {every, "--seed", "SEED", "the whole number that the scene's fills are drawn from",
       whole_number(&Options::seed, 0)},
      {takes_scene, "--set", "/POINTER=VALUE",
       "change one value of the scene before it is checked; may be repeated", changes()},
      {every, "--no-color", "", "no colours, as with NO_COLOR in the environment",
       flag(&Options::no_color)},

      {{C::run, C::accuracy, C::sweep},
       "--time",
       "SECONDS",
       "simulated seconds to run; default: the scene's duration",
       seconds(&Options::time, true)},
      {{C::run, C::sweep},
       "--frames",
       "FRAMES",
       "frames of the frame clock to run, instead of a time",
       whole_number(&Options::frames, 0)},
      {run, "--dump", "FILE", "write the frames as text", text(&Options::dump)},
      {run, "--size", "COLSxROWS", "size of a dumped frame; default: 80x24", cell_size()},
      {run, "--every", "FRAMES", "write every frame, every second, third ...; default: 1",
       whole_number(&Options::every, 1)},
      {run, "--report", "FILE", "write what was measured and the final state as JSON",
       text(&Options::report)},
      {run, "--save", "FILE", "write the final state as a scene that goes on from there",
       text(&Options::save)},

      {accuracy, "--target", "ERROR",
       "name the cheapest run whose final position error is at most this",
       positive(&Options::target)},
      {accuracy, "--share", "SECONDS", "wall-clock seconds that one run may take; default: 2",
       seconds(&Options::share, false)},
      {accuracy, "--csv", "FILE", "write the runs as comma-separated values", text(&Options::csv)},
      {accuracy, "--plot", "FILE", "draw error against time with gnuplot: .svg or .png",
       picture(&Options::plot)},

      {verify_only, "--case", "NAME", "run this case only", text(&Options::case_name)},
      {verify_only, "--list", "", "print the names of the cases and what each is about",
       flag(&Options::list)},
      {verify_only, "--long", "", "the long versions: more collisions, larger systems",
       flag(&Options::thorough)},

      {{C::accuracy, C::verify},
       "--json",
       "FILE",
       "write all results as JSON",
       text(&Options::json)},
      {{C::run, C::accuracy, C::sweep},
       "--quiet",
       "",
       "print neither progress nor results",
       flag(&Options::quiet)},

      {sweep, "--over", "/POINTER=VALUES",
       "a value to change: FROM:TO:COUNT, FIRST..LAST or A,B,C; may be repeated",
       texts(&Options::over)},
      {sweep, "--jobs", "N", "runs at the same time; default: one per core",
       whole_number(&Options::jobs, 1, 4096)},
      {sweep, "--share", "I/N", "run share I of N only, I from 0; default: what Slurm or MPI says",
       text(&Options::sweep_share)},
      {sweep, "--status", "", "count the points of DIR that are done", flag(&Options::status)},
      {sweep, "--merge", "", "write the tables of the points of DIR that are done",
       flag(&Options::merge)},
      {sweep, "--retry", "", "run the points that have failed again", flag(&Options::retry)},

      {run, "--trajectory", "FILE", "write the frames as extended XYZ", text(&Options::trajectory)},
      {run, "--events", "FILE", "write every event as a line of CSV", text(&Options::events)},
      {run, "--series", "FILE", "write what is measured at each frame as a line of CSV",
       text(&Options::series)},
      {run, "--trace", "FILE", "write what each thread did as Trace Event JSON",
       text(&Options::trace)},
      {run, "--trace-frames", "FRAMES", "the last frames that a trace holds; default: 120",
       whole_number(&Options::trace_frames, 1)},
      {run, "--cast", "FILE", "write the frames as an asciicast", text(&Options::cast)},
      {run, "--no-state", "", "leave the state out of the report", flag(&Options::no_state)},
      {run, "--checkpoint", "FILE",
       "save the state in FILE, from which a killed run goes on when started again",
       text(&Options::checkpoint)},
      {run, "--checkpoint-every", "SECONDS", "wall-clock seconds between checkpoints; default: 60",
       seconds(&Options::checkpoint_every, false)},
      {play, "--record", "FILE", "write the session as an asciicast", text(&Options::record)},
      {play, "--log", "FILE", "write the session as a scene with a script, for carom run",
       text(&Options::log)},
      {play, "--glyphs", "GLYPHS",
       "how the balls are drawn:", choice(&Options::glyphs, {"ascii", "blocks", "braille"})},
      {play, "--fps", "N", "frames drawn per second, from 1 to 120; default: 30",
       whole_number(&Options::fps, 1, 120)},
      {play, "--no-mouse", "", "leave the mouse to the terminal", flag(&Options::no_mouse)},
      {accuracy, "--seeds", "K",
       "starts of a scene that comes to rest, or that is averaged; default: 8",
       whole_number(&Options::seeds, 1, 1000)},
      {accuracy, "--observable", "NAME", "an average to compare, once or repeatedly:",
       choices(&Options::observables,
               {"Z", "pressure", "temperature", "collision_rate", "mean_free_path"})},
  };
}

std::array<CommandRow, 8> make_commands() {
  return {{
      {C::play, "play", "[SCENE]", kScene, 0, 1,
       "play SCENE, or the built-in scene, in the terminal", ""},
      {C::run, "run", "SCENE", kScene, 1, 1,
       "simulate without a terminal; write frames, report, final state", kFiles},
      {C::accuracy, "accuracy", "SCENE", kScene, 1, 1,
       "run SCENE in every way: the cost and the error of each", kFiles},
      {C::check, "check", "SCENE...", kScene, 1, kManyScenes,
       "print what a scene simulates and what it does not, or its problems", ""},
      {C::verify, "verify", "", "", 0, 0, "run the hard cases: does this build compute correctly?",
       ""},
      {C::sweep, "sweep", "SCENE DIR", "the scene, and the folder of the sweep", 1, 2,
       "run SCENE over a grid of its values, with the results in DIR",
       "With --status or --merge only DIR is given, as in carom sweep DIR --status."},
      {C::scenes, "scenes", "", "", 0, 0, "list the installed scenes", ""},
      {C::help, "help", "[COMMAND]", "the name of a command", 0, 1,
       "print the help of COMMAND, or this help", ""},
  }};
}

}  // namespace

std::span<const CommandRow> command_table() {
  static const auto kTable = make_commands();
  return kTable;
}

std::span<const OptionRow> option_table() {
  static const std::vector<OptionRow> kTable = make_options();
  return kTable;
}

}  // namespace carom
