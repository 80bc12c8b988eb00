#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string_view>

#include "carom/report.hpp"
#include "help.hpp"
#include "values.hpp"

namespace carom {
namespace {

constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kManyScenes = std::numeric_limits<std::size_t>::max();

/// A command of the program: its name, how many scenes it takes, what it is for.
struct CommandRow {
  std::string_view name;
  Options::Command command;
  std::size_t fewest_scenes;
  std::size_t most_scenes;
  std::string_view arguments;
  std::string_view purpose;
};

constexpr std::array kCommands{
    CommandRow{"play", Options::Command::play, 0, 1, "[SCENE]",
               "play SCENE, or the built-in scene, in the terminal"},
    CommandRow{"run", Options::Command::run, 1, 1, "SCENE",
               "simulate without a terminal; write frames, report, final state"},
    CommandRow{"accuracy", Options::Command::accuracy, 1, 1, "SCENE",
               "run it in every way: what each costs, and how wrong each is"},
    CommandRow{"check", Options::Command::check, 1, kManyScenes, "SCENE...",
               "say what a scene simulates and what not, or what is wrong with it"},
    CommandRow{"verify", Options::Command::verify, 0, 0, "",
               "run the hard cases: does this build compute right"},
};

const CommandRow* find_command(std::string_view name) {
  const auto* const row = std::find_if(kCommands.begin(), kCommands.end(),
                                       [&](const CommandRow& each) { return each.name == name; });
  return row == kCommands.end() ? nullptr : row;
}

/// The options of one command, bound to where their values go.
class Syntax {
 public:
  explicit Syntax(const CommandRow& row) : row_(row) {
    app_.set_help_flag();
    app_.allow_extras();
    app_.add_option("SCENE", options_.scenes);
    options_.command = row.command;
    if (row.command == Options::Command::run) add_run();
    if (row.command == Options::Command::accuracy) add_accuracy();
    if (row.command == Options::Command::verify) add_verify();
    add_common();
  }

  [[nodiscard]] const CLI::App& app() const { return app_; }

  Options parse(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
      app_.parse(arguments);
    } catch (const CLI::ArgumentMismatch& error) {
      const std::string message =
          error.what();  // "--time: 1 required ..." or "quiet was given ..."
      const bool flag = !message.starts_with('-');
      throw UsageError(fmt::format("{}{}: {}{}", flag ? "--" : "",
                                   message.substr(0, message.find_first_of(": ")),
                                   flag ? "takes no value" : "needs a value", see_help()));
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what() + see_help());
    }
    for (const std::string& extra : app_.remaining()) {
      if (extra != "--") throw UsageError(fmt::format("unknown option '{}'{}", extra, see_help()));
    }
    return options_;
  }

  [[nodiscard]] bool wants_help() const { return help_; }
  [[nodiscard]] bool wants_version() const { return version_; }
  [[nodiscard]] std::string see_help() const {
    return row_.command == Options::Command::play ? "; see carom --help"
                                                  : fmt::format("; see carom {} --help", row_.name);
  }

 private:
  using Take = std::function<void(const std::string& name, const std::string& value)>;

  /// An option with a value; given twice, the last one counts.
  void add(const std::string& name, const std::string& value, Take take,
           const std::string& purpose) {
    app_.add_option_function<std::string>(
            name,
            [name, take = std::move(take), this](const std::string& text) {
              if (text.empty() || text.starts_with("--")) {
                throw UsageError(
                    fmt::format("{}: needs a value, got '{}'{}", name, text, see_help()));
              }
              take(name, text);
            },
            purpose)
        ->type_name(value)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }

  void add_flag(const std::string& name, bool& given, const std::string& purpose) {
    app_.add_flag(name, given, purpose)->disable_flag_override();
  }

  void add_common() {
    app_.option_defaults()->group("Options of every command");
    add(
        "--method", "METHOD",
        [this](const std::string& name, const std::string& text) {
          if (text == "overlap") {
            options_.method = Method::overlap;
          } else if (text == "event") {
            options_.method = Method::event;
          } else {
            throw UsageError(fmt::format("{}: must be overlap or event, got '{}'", name, text));
          }
        },
        "how to compute: overlap, which takes steps of time");
    add(
        "--step", "SECONDS",
        [this](const std::string& name, const std::string& text) {
          options_.step = finite_number(name, text, false);
        },
        "length of a step; 1/240 where nothing says otherwise");
    add(
        "--digits", "DIGITS",
        [this](const std::string& name, const std::string& text) {
          options_.digits = static_cast<int>(whole_number(name, text, 1, 1000));
        },
        "digits of the arithmetic: 16, double precision");
    if (row_.command == Options::Command::accuracy) {
      add(
          "--workers", "WORKERS",
          [this](const std::string& name, const std::string& text) { take_crews(name, text); },
          "threads, as in 1,2,per-ball: the first for all runs, the rest for one of each method");
    } else {
      add(
          "--workers", "WORKERS",
          [this](const std::string& name, const std::string& text) {
            options_.workers = crew(name, text);
          },
          "threads: a number, or per-ball; never changes the result");
    }
    add(
        "--seed", "SEED",
        [this](const std::string& name, const std::string& text) {
          options_.seed = whole_number(name, text, 0, kAny);
        },
        "what the scene's fills are drawn from, a whole number");
    add_flag("--no-color", options_.no_color, "no colours, as with NO_COLOR in the environment");
    add_flag("-h,--help", help_, "print this help");
    add_flag("--version", version_, "print the version");
  }

  static std::string crew(const std::string& name, const std::string& text) {
    if (text != "per-ball" && text.find_first_not_of("0123456789") != std::string::npos) {
      throw UsageError(
          fmt::format("{}: must be per-ball or a whole number from 1, got '{}'", name, text));
    }
    if (text != "per-ball") whole_number(name, text, 1, kAny);
    return text;
  }

  void take_crews(const std::string& name, const std::string& text) {
    options_.crews.clear();
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      options_.crews.push_back(crew(name, text.substr(begin, end - begin)));
      begin = end + 1;
    }
    options_.workers = options_.crews.front();
  }

  void add_time() {
    add(
        "--time", "SECONDS",
        [this](const std::string& name, const std::string& text) {
          options_.time = finite_number(name, text, true);
        },
        "simulated seconds to run, not the scene's duration");
  }

  void add_accuracy() {
    app_.option_defaults()->group("Options of accuracy");
    add_time();
    add(
        "--target", "ERROR",
        [this](const std::string& name, const std::string& text) {
          options_.target = positive_number(name, text);
        },
        "name the cheapest run whose error of position at the end is not larger");
    add(
        "--share", "SECONDS",
        [this](const std::string& name, const std::string& text) {
          options_.share = finite_number(name, text, false);
        },
        "wall-clock seconds that one run may take (2)");
    add_file("--json", options_.json, "write everything as JSON");
    add_file("--csv", options_.csv, "write the runs as a table with commas");
    add(
        "--plot", "FILE",
        [this](const std::string& name, const std::string& text) {
          if (!text.ends_with(".svg") && !text.ends_with(".png")) {
            throw UsageError(fmt::format("{}: must end in .svg or .png, got '{}'", name, text));
          }
          options_.plot = text;
        },
        "draw error against time with gnuplot: .svg or .png");
    add_flag("--quiet", options_.quiet, "no progress and no table");
  }

  void add_verify() {
    app_.option_defaults()->group("Options of verify");
    add(
        "--case", "NAME",
        [this](const std::string&, const std::string& text) { options_.case_name = text; },
        "run this case only");
    add_flag("--long", options_.thorough, "the long versions: more collisions, larger systems");
    add_file("--json", options_.json, "write the results as JSON");
  }

  void add_run() {
    app_.option_defaults()->group("Options of run");
    add_time();
    add(
        "--frames", "FRAMES",
        [this](const std::string& name, const std::string& text) {
          options_.frames = whole_number(name, text, 0, kAny);
        },
        "frames of the frame clock to run, instead of a time");
    add_file("--dump", options_.dump, "write the frames as text");
    add(
        "--size", "COLSxROWS",
        [this](const std::string& name, const std::string& text) {
          std::tie(options_.columns, options_.rows) = cell_size(name, text);
        },
        "size of a dumped frame (80x24)");
    add(
        "--every", "FRAMES",
        [this](const std::string& name, const std::string& text) {
          options_.every = whole_number(name, text, 1, kAny);
        },
        "dump every frame, every second, third ... (1)");
    add_file("--report", options_.report, "write what was measured and the final state as JSON");
    add_file("--save", options_.save, "write the final state as a scene that goes on");
    add_flag("--quiet", options_.quiet, "no progress and no summary");
  }

  void add_file(const std::string& name, std::string& file, const std::string& purpose) {
    add(
        name, "FILE", [&file](const std::string&, const std::string& text) { file = text; },
        purpose);
  }

  const CommandRow& row_;
  CLI::App app_;
  Options options_;
  bool help_ = false;
  bool version_ = false;
};

/// Where the command's name stands: the first argument that is neither option nor option's value.
std::size_t find_command_word(const std::vector<std::string>& arguments) {
  // Between them they have the options of every command, and so tell values from words.
  const Syntax run(*find_command("run"));
  const Syntax accuracy(*find_command("accuracy"));
  const Syntax verify(*find_command("verify"));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--") break;
    if (argument == "-" || !argument.starts_with('-')) return i;
    const CLI::Option* option = run.app().get_option_no_throw(argument);
    if (option == nullptr) option = accuracy.app().get_option_no_throw(argument);
    if (option == nullptr) option = verify.app().get_option_no_throw(argument);
    if (option != nullptr && option->get_items_expected_max() > 0) ++i;
  }
  return arguments.size();
}

void refuse_empty_values(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--") return;
    if (argument.starts_with("--") && argument.ends_with('=')) {
      throw UsageError(fmt::format("{}: needs a value after the '='", argument));
    }
  }
}

void check_together(const Options& options, const CommandRow& row, const Syntax& syntax) {
  if (options.scenes.size() < row.fewest_scenes) {
    throw UsageError(fmt::format("{} needs a SCENE, a file to read, or - for standard input{}",
                                 row.name, syntax.see_help()));
  }
  if (options.scenes.size() > row.most_scenes) {
    throw UsageError(fmt::format("unexpected argument '{}': {} takes {} SCENE{}",
                                 options.scenes[row.most_scenes], row.name,
                                 row.most_scenes == 0 ? "no" : "one", syntax.see_help()));
  }
  if (options.time && options.frames) {
    throw UsageError("--time and --frames: give one of them; each says when the run ends");
  }
}

std::string overview(const Syntax& syntax) {
  std::string text =
      "carom: colliding balls in a terminal, with the price of accuracy on the label\n\n"
      "Usage: carom [SCENE] [OPTION...]\n"
      "       carom COMMAND [SCENE...] [OPTION...]\n\nCommands:\n";
  for (const CommandRow& row : kCommands) {
    text += help_row(fmt::format("{} {}", row.name, row.arguments), std::string(row.purpose));
  }
  return text + help_options(syntax.app()) +
         "\nSCENE is a file as in carom-scene(5), or - for standard input. Without a\n"
         "command, SCENE is played; write ./run for a file called run. The options of a\n"
         "command: carom COMMAND --help. The manual: carom(1).\n";
}

std::string command_help(const CommandRow& row, const Syntax& syntax) {
  std::string text = fmt::format("carom {}: {}\n\nUsage: carom {} {} [OPTION...]\n", row.name,
                                 row.purpose, row.name, row.arguments);
  text += help_options(syntax.app());
  if (row.command == Options::Command::accuracy) {
    text +=
        "\nA FILE of - is standard output; the table then goes to standard error.\n"
        "A file is written whole or not at all.\n";
  }
  if (row.command == Options::Command::run) {
    text +=
        "\nA FILE of - is standard output; the summary then goes to standard error.\n"
        "A file is written whole or not at all.\n";
  }
  return text;
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
  refuse_empty_values(arguments);
  std::vector<std::string> rest = arguments;
  const std::size_t word = find_command_word(rest);
  const CommandRow* row = nullptr;
  if (word < rest.size()) {
    row = find_command(rest[word]);
  }
  const bool named = row != nullptr;
  if (named) {
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(word));
  } else {
    row = find_command("play");
  }
  Syntax syntax(*row);
  Options options = syntax.parse(rest);
  if (syntax.wants_help() || syntax.wants_version()) {
    options.command = Options::Command::print;
    options.text = syntax.wants_version() ? fmt::format("carom {}\n", version())
                   : named                ? command_help(*row, syntax)
                                          : overview(syntax);
    return options;
  }
  if (!named && options.scenes.size() > 1) {
    throw UsageError(
        fmt::format("unknown command '{}': the commands are play, run, accuracy, check and verify",
                    options.scenes.front()));
  }
  check_together(options, *row, syntax);
  return options;
}

}  // namespace carom
