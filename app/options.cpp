#include "options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>

#include "carom/names.hpp"
#include "carom/report.hpp"
#include "help.hpp"
#include "option_table.hpp"

namespace carom {
namespace {

constexpr auto kAbout =
    "carom: colliding balls in a terminal, with the price of accuracy on the label";
constexpr auto kAboutScenes =
    "Scenes are described in carom-scene(5); carom scenes lists the installed ones.\n"
    "Without a command, SCENE is played; write ./run for a file called run. The\n"
    "options of a command: carom COMMAND --help. The manual: carom(1).";
constexpr auto kCommon = "Common options";
constexpr std::size_t kFarthestWord = 2;  // typing errors, up to which a word is offered

const CommandRow* find_command(std::string_view name) {
  for (const CommandRow& row : command_table()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

bool takes(Options::Command command, const OptionRow& row) {
  return std::find(row.commands.begin(), row.commands.end(), command) != row.commands.end();
}

/// `check` takes the common options and no others.
bool is_common(const OptionRow& row) {
  return std::any_of(option_table().begin(), option_table().end(), [&](const OptionRow& each) {
    return each.name == row.name && takes(Options::Command::check, each);
  });
}

std::string see_help(const CommandRow* row) {
  return row == nullptr ? "; see carom --help" : fmt::format("; see carom {} --help", row->name);
}

/// As in "run, accuracy and check".
std::string in_a_row(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

std::string offer(std::string_view unknown, const std::vector<std::string>& known) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string_view nearest = nearest_word(unknown, words, kFarthestWord);
  return nearest.empty() ? "" : fmt::format(", the nearest one is {}", nearest);
}

/// The command line as CLI11 parses it.
class Parser {
 public:
  explicit Parser(const std::string& commit)
      : app_(kAbout, "carom"),
        version_(fmt::format("carom {}{}", version(),
                             commit.empty() ? "" : fmt::format(" (commit {})", commit))) {
    app_.allow_extras();
    app_.require_subcommand(0, 1);
    app_.formatter(std::make_shared<HelpText>());
    app_.footer(kAboutScenes);
    app_.add_option("SCENE", loose_, command_table().front().argument_purpose)
        ->type_name(command_table().front().argument);
    add_options(app_, command_table().front());
    for (const CommandRow& row : command_table()) {
      CLI::App& command = *app_.add_subcommand(row.name, row.purpose);
      command.group("Commands");
      command.footer(row.note);
      if (row.most_arguments > 0) {
        command
            .add_option(row.command == Options::Command::help ? "COMMAND" : "SCENE", words_,
                        row.argument_purpose)
            ->type_name(row.argument);
      }
      add_options(command, row);
    }
  }

  Options parse(const std::vector<std::string>& arguments) {
    refuse_empty_values(arguments);
    try {
      app_.parse(std::vector<std::string>(arguments.rbegin(),
                                          arguments.rend()));  // the order that CLI11 takes
    } catch (const CLI::CallForHelp&) {
      return printed(app_.help());
    } catch (const CLI::CallForVersion& version) {
      return printed(version.what());
    } catch (const CLI::ArgumentMismatch&) {
      throw UsageError(flag_with_value(arguments));
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what());
    }
    return finish();
  }

 private:
  static Options printed(const std::string& text) {
    Options options;
    options.command = Options::Command::print;
    options.text = text.ends_with('\n') ? text : text + '\n';
    return options;
  }

  void add_options(CLI::App& app, const CommandRow& command) {
    for (const bool common : {false, true}) {
      for (const OptionRow& row : option_table()) {
        if (!takes(command.command, row) || is_common(row) != common) continue;
        add_option(app, row).group(common ? kCommon : "Options of " + command.name);
      }
    }
    app.set_help_flag("-h,--help", "print this help")->group(kCommon);
    app.set_version_flag("--version", version_, "print the version and the commit")->group(kCommon);
  }

  CLI::Option& add_option(CLI::App& app, const OptionRow& row) {
    if (row.rule.flag != nullptr) {
      return *app.add_flag(row.name, options_.*row.rule.flag, row.purpose)->disable_flag_override();
    }
    const auto take = [this, &row](const std::string& value) {
      if (value.empty()) {
        throw CLI::ValidationError(row.name,
                                   fmt::format("needs a value, as in {} {}", row.name, row.value));
      }
      row.rule.take(options_, value);
    };
    const CLI::Validator validator(
        [&row](std::string& value) -> std::string {
          const std::string demand = row.rule.demand(value);
          return demand.empty() ? "" : fmt::format("{}, got '{}'", demand, value);
        },
        "");
    // A value may be missing for CLI11, so that `take` says what is wrong; each occurrence is
    // taken as it comes, so that of several the last one counts or all do.
    return *app.add_option_function<std::string>(row.name, take, help_of(row))
                ->type_name(row.value)
                ->check(validator)
                ->expected(0, 1)
                ->trigger_on_parse();
  }

  static std::string help_of(const OptionRow& row) {
    if (row.rule.words.empty()) return row.purpose;
    const auto& words = row.rule.words;
    return fmt::format("{} {} or {}", row.purpose, fmt::join(words.begin(), words.end() - 1, ", "),
                       words.back());
  }

  /// "--report= b.json" would take b.json as its value.
  static void refuse_empty_values(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
      if (argument == "--") return;
      if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) {
        throw UsageError(fmt::format("{}: needs a value after the '='", argument));
      }
    }
  }

  static std::string flag_with_value(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
      const std::string name = argument.substr(0, argument.find('='));
      const bool flag =
          name == "--help" || name == "--version" ||
          std::any_of(option_table().begin(), option_table().end(), [&](const OptionRow& row) {
            return row.name == name && row.rule.flag != nullptr;
          });
      if (flag && name != argument)
        return fmt::format("{}: takes no value, got '{}'", name, argument.substr(name.size() + 1));
    }
    return "an option has the wrong number of values; see carom --help";
  }

  Options finish() {
    const auto parsed = app_.get_subcommands();
    const bool named = !parsed.empty();
    const CommandRow& row =
        named ? *find_command(parsed.front()->get_name()) : command_table().front();
    refuse_unknown(row, named);
    if (row.command == Options::Command::help) return help();
    options_.command = row.command;
    options_.scenes = named ? words_ : loose_;
    check_together(row, named);
    return options_;
  }

  void refuse_unknown(const CommandRow& row, bool named) const {
    const CommandRow* const help_from = named ? &row : nullptr;
    std::vector<std::string> words = app_.remaining(true);
    words.erase(std::remove(words.begin(), words.end(), "--"), words.end());
    for (const std::string& word : words) {
      if (word.starts_with('-')) throw UsageError(unknown_option(word, row, help_from));
    }
    if (named && !loose_.empty()) words.insert(words.begin(), loose_.front());
    if (words.empty()) return;
    throw UsageError(fmt::format("unexpected argument '{}'{}", words.front(), see_help(help_from)));
  }

  static std::string unknown_option(const std::string& word, const CommandRow& row,
                                    const CommandRow* help_from) {
    const std::string name = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const OptionRow& option : option_table()) {
      if (takes(row.command, option)) names.push_back(option.name);
      if (option.name != name) continue;
      std::vector<std::string> commands;
      for (const CommandRow& command : command_table()) {
        if (takes(command.command, option)) commands.push_back(command.name);
      }
      if (takes(row.command, option)) {
        return fmt::format("'{}' is an option of {}: write it after '{}'", name, row.name,
                           row.name);
      }
      return fmt::format("'{}' is an option of {}, not of {}{}", name, in_a_row(commands), row.name,
                         see_help(help_from));
    }
    return fmt::format("unknown option '{}'{}{}", name, offer(name, names), see_help(help_from));
  }

  Options help() const {
    if (words_.empty()) {
      return printed(app_.get_formatter()->make_help(&app_, "carom", CLI::AppFormatMode::Normal));
    }
    if (words_.size() > 1) {
      throw UsageError(fmt::format("unexpected argument '{}': help takes one COMMAND", words_[1]));
    }
    if (find_command(words_.front()) == nullptr) throw UsageError(unknown_command(words_.front()));
    return printed(app_.get_subcommand(words_.front())->help("carom"));
  }

  void check_together(const CommandRow& row, bool named) const {
    const auto& scenes = options_.scenes;
    if (!named && scenes.size() > 1) throw UsageError(unknown_command(scenes.front()));
    if (scenes.size() < row.fewest_arguments) {
      throw UsageError(
          fmt::format("{} needs a SCENE: {}{}", row.name, row.argument_purpose, see_help(&row)));
    }
    if (scenes.size() > row.most_arguments) {
      throw UsageError(fmt::format("unexpected argument '{}': {} takes one SCENE{}",
                                   scenes[row.most_arguments], row.name, see_help(&row)));
    }
    if (options_.time && options_.frames) {
      throw UsageError("--time and --frames: give one of them; each says when the run ends");
    }
  }

  static std::string unknown_command(const std::string& word) {
    std::vector<std::string> names;
    for (const CommandRow& row : command_table()) names.push_back(row.name);
    return fmt::format("unknown command '{}'{}; the commands are {}", word, offer(word, names),
                       in_a_row(names));
  }

  CLI::App app_;
  std::string version_;  // what --version prints
  Options options_;
  std::vector<std::string> loose_;  // words before or without a command
  std::vector<std::string> words_;  // words after it
};

}  // namespace

Options parse_options(const std::vector<std::string>& arguments, const std::string& commit) {
  return Parser(commit).parse(arguments);
}

}  // namespace carom
