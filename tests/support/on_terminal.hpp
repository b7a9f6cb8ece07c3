#pragma once
#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "support/paths.hpp"
#include "support/scratch.hpp"

/// Bare chroots have no pseudo-terminals. A test that needs one is then skipped, and says so.
inline bool has_terminals() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) MESSAGE("skipped: no pseudo-terminal can be opened here");
  return close(terminal) == 0;
}

/// A run of the program whose standard error is a terminal, so that a test can wait for what it prints.
class OnTerminal {
 public:
  OnTerminal(std::vector<std::string> arguments, const char* term, unsigned short columns) {
    const winsize size{24, columns, 0, 0};
    arguments.insert(arguments.begin(), program());
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    child_ = forkpty(&terminal_, nullptr, nullptr, &size);
    REQUIRE(child_ >= 0);
    if (child_ > 0) return;
    dup2(open(output_.path().c_str(), O_WRONLY), STDOUT_FILENO);
    setenv("TERM", term, 1);
    std::signal(SIGINT, SIG_DFL);
    execv(words[0], words.data());
    _exit(127);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;
  ~OnTerminal() {
    if (running_) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close(terminal_);
  }

  /// Reads until `text` has been printed; false if the program ends before that.
  bool wait_for(const std::string& text) {
    while (!contains(told_, text)) {
      if (!read_more()) return false;
    }
    return true;
  }

  void interrupt() const { kill(child_, SIGINT); }

  /// The exit status of the program after its end; negative: the signal that ended it.
  int status() {
    while (read_more()) {
    }
    int status = 0;
    waitpid(child_, &status, 0);
    running_ = false;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  [[nodiscard]] std::string output() const { return output_.text(); }
  [[nodiscard]] const std::string& told() const { return told_; }

 private:
  bool read_more() {
    std::array<char, 4096> buffer{};
    const ssize_t count = read(terminal_, buffer.data(), buffer.size());
    if (count > 0) told_.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  ScratchFile output_;
  int terminal_ = -1;
  pid_t child_ = -1;
  bool running_ = true;
  std::string told_;
};
