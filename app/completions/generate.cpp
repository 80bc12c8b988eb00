// Writes the completion scripts:  carom_completions FOLDER
#include <filesystem>
#include <fstream>
#include <iostream>

#include "completions/completions.hpp"

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: carom_completions FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    write(folder / "bash" / "carom", carom::bash_completions());
    write(folder / "zsh" / "_carom", carom::zsh_completions());
    write(folder / "fish" / "carom.fish", carom::fish_completions());
  } catch (const std::exception& error) {
    std::cerr << "carom_completions: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
