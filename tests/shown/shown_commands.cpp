#include "shown/shown_commands.hpp"

#include <optional>
#include <regex>
#include <sstream>

#include "support/process.hpp"

namespace carom::shown {
namespace {

/// What a literal line of a manual page prints.
std::string printed(std::string line) {
  for (const auto& [escape, text] : {std::pair<std::string, std::string>{"\\e", "\\"},
                                     {"\\&", ""},
                                     {"\\-", "-"},
                                     {"\\(dq", "\""}}) {
    for (std::size_t at = line.find(escape); at != std::string::npos;
         at = line.find(escape, at + text.size())) {
      line.replace(at, escape.size(), text);
    }
  }
  return line;
}

/// Collects the commands of one block.
class Block {
 public:
  Block(std::vector<Command>& commands, std::string mark)
      : commands_(commands), mark_(std::move(mark)) {}

  void add(std::size_t number, const std::string& line, bool bare) {
    if (continued_ || !end_.empty()) {
      commands_.back().text += '\n' + line;
      if (line == end_) end_.clear();
    } else if (line.starts_with("$ ") || (bare && line.starts_with("carom "))) {
      const bool prompted = line.starts_with('$');
      commands_.push_back({number, line.substr(prompted ? 2 : 0), prompted, {}, mark_});
      mine_ = true;
    } else {
      if (mine_) commands_.back().output.push_back(line);
      return;
    }
    continued_ = line.ends_with('\\');
    static const std::regex kDocument("<<'([A-Z]+)'");
    std::smatch found;
    if (std::regex_search(line, found, kDocument)) end_ = found[1];
  }

 private:
  std::vector<Command>& commands_;
  std::string mark_;
  bool mine_ = false;  // the last command is of this block
  std::string end_;    // the last line of a text that the command reads
  bool continued_ = false;
};

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Command> commands_in(const std::filesystem::path& page) {
  const bool markdown = page.extension() == ".md";
  std::vector<Command> commands;
  std::optional<Block> block;
  const std::vector<std::string> lines = lines_of(support::read_file(page));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string& line = lines[k];
    if (block && (markdown ? line == "```" : line.starts_with(".Ed"))) {
      block.reset();
    } else if (block) {
      block->add(k + 1, markdown ? line : printed(line), !markdown);
    } else if (markdown ? line.starts_with("```console") : line.starts_with(".Bd -literal")) {
      block.emplace(commands, line.starts_with("```console ") ? line.substr(11) : "");
    }
  }
  return commands;
}

std::string masked(const std::string& line) {
  static const std::regex kNumber("[-+]?[0-9][0-9.]*(e[-+]?[0-9]+)?");
  static const std::regex kTime("N ?(ns|us|ms|s|min)\\b");
  static const std::regex kSpaces("[ *]+");
  std::string text = std::regex_replace(line, kNumber, "N");
  text = std::regex_replace(text, kTime, "T");
  text = std::regex_replace(text, kSpaces, " ");
  return text.ends_with(' ') ? text.substr(0, text.size() - 1) : text;
}

bool matches(const std::vector<std::string>& shown, const std::vector<std::string>& found) {
  // reachable[k]: the lines shown so far can be the first k lines found.
  std::vector<bool> reachable(found.size() + 1, false);
  reachable[0] = true;
  for (const std::string& line : shown) {
    std::vector<bool> next(found.size() + 1, false);
    for (std::size_t k = 0; k <= found.size(); ++k) {
      if (line == "...") {
        next[k] = reachable[k] || (k > 0 && next[k - 1]);
      } else {
        next[k] = k > 0 && reachable[k - 1] && masked(line) == masked(found[k - 1]);
      }
    }
    reachable = next;
  }
  return reachable.back();
}

}  // namespace carom::shown
