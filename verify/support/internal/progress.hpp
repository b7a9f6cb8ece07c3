#pragma once
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {

/// How progress is printed.
struct ProgressOutput {
  std::function<void(const std::string&)> write;  ///< empty: nothing is printed
  std::function<double()> seconds;                ///< now
  /// Columns of a terminal on which a line can be overwritten; 0: whole lines are written, every 15 seconds.
  std::function<std::size_t()> columns;
};

/// Writes to standard error: nothing if `quiet`; on a terminal a line that overwrites itself; whole lines elsewhere, and where
/// TERM is dumb or not set.
ProgressOutput standard_error(bool quiet);

/// Shows the progress of a long run: "audit 12/57 [####....] I6, 95 s, about 360 s left" in the columns of the terminal, or
/// every 15 seconds "nipref: audit: 12 of 57 done, now I6, 95 s, about 360 s left": the time since the start, and the
/// time left for this part of the run.
class Progress {
 public:
  explicit Progress(ProgressOutput output);
  /// On standard error, of work that an interrupt ends gently from now on.
  explicit Progress(bool quiet) : Progress(standard_error(quiet)) { stop_gently_on_interrupt(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the line that overwrites itself.
  ~Progress();

  /// A new part of the run, with so many items.
  void begin(std::string stage, std::size_t items);
  /// The next item.
  void next(std::string item);
  /// A new part of the run: work(item) for each of the items, whose name is shown, until the process is interrupted.
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

  /// The share of the item that is done, 0 to 1, and which detail of it is being worked on.
  void at(double part, std::string detail = "");

  /// Writes lines that stay.
  void tell(const std::string& lines);

 private:
  /// Does nothing if a bar, or a line, was shown not so long ago.
  void show(double seconds_since_bar);

  ProgressOutput output_;
  double started_ = 0, stage_started_ = 0, shown_ = 0;
  std::string stage_, item_, detail_;
  std::size_t items_ = 0, done_ = 0;
  double part_ = 0;
  bool line_is_open_ = false;
};

}  // namespace nipref::verify
