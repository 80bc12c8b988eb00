#pragma once

#include <string>

/// The temporary files of this process that a signal must not leave behind.
///
/// Threads: the control thread only; the signal handler reads what the functions leave in place.
namespace carom::unfinished_files {

/// Creates a file whose name ends in XXXXXX, which are replaced; its descriptor, or -1 and errno.
int create(std::string& name);
/// Removes the file.
void remove(const std::string& name);
/// The file is finished, or gone.
void forget(const std::string& name);

/// From now on every signal that ends the program, a crash too, removes the files first; only
/// SIGKILL cannot.  One that was ignored stays ignored.
void remove_on_signals();

}  // namespace carom::unfinished_files
