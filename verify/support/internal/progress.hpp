#pragma once
#include <string>

namespace nipref::verify {

/// One line on standard error that overwrites itself; silent unless that is a terminal.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the line.
  ~Progress();

  void show(const std::string& text);

 private:
  bool terminal_;
};

}  // namespace nipref::verify
