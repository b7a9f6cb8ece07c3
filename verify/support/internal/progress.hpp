#pragma once
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {

/// Where and how progress is printed.
struct ProgressOutput {
  std::function<void(const std::string&)> write;  ///< empty: nothing is printed
  std::function<double()> seconds;                ///< the present time
  /// The number of columns of a terminal, where a line can be overwritten; 0: whole lines are written, every 15 seconds.
  std::function<std::size_t()> columns;
};

/// Progress on standard error: nothing if `quiet`; on a terminal a line that is overwritten; whole lines elsewhere, or if
/// TERM is dumb or not set.
ProgressOutput standard_error(bool quiet);

/// Shows the progress of a long run. On a terminal: "audit 12/57 [####....] I6, 95 s, about 360 s left". Elsewhere, every
/// 15 seconds: "nipref: audit: 12 of 57 done, now I6, 95 s, about 360 s left". The first time is the time since the
/// start, the second the time left for this part of the run.
class Progress {
 public:
  explicit Progress(ProgressOutput output);
  /// Shows progress on standard error. From now on an interrupt ends the work gently.
  explicit Progress(bool quiet) : Progress(standard_error(quiet)) { stop_gently_on_interrupt(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Erases the line that is overwritten.
  ~Progress();

  /// Begins a new part of the run, with this number of items.
  void begin(std::string stage, std::size_t items);
  /// Begins the next item.
  void next(std::string item);
  /// Runs a new part: shows the name of each item and calls work(item), until the process is interrupted.
  template <class Items, class Name, class Work>
  void each(std::string stage, const Items& items, Name name, Work work) try {
    begin(std::move(stage), std::ranges::size(items));
    for (const auto& item : items) {
      stop_if_interrupted();
      next(std::string(std::invoke(name, item)));
      work(item);
    }
  } catch (const Interrupted&) {
  }

  /// Tells the finished share of the item, from 0 to 1, and the detail in work.
  void at(double part, std::string detail = "");

  /// Writes lines that are not overwritten.
  void tell(const std::string& lines);

 private:
  /// Does nothing if a bar was shown less than `seconds_since_bar` ago, or a line less than 15 seconds ago.
  void show(double seconds_since_bar);

  ProgressOutput output_;
  double started_ = 0, stage_started_ = 0, shown_ = 0;
  std::string stage_, item_, detail_;
  std::size_t items_ = 0, done_ = 0;
  double part_ = 0;
  bool line_is_open_ = false;
};

}  // namespace nipref::verify
