#pragma once
#include <cstddef>
#include <functional>
#include <string>

namespace nipref::verify {

/// Where progress is printed, and how.
struct ProgressOutput {
  std::function<void(const std::string&)> write;  ///< empty: nothing is printed
  std::function<double()> seconds;                ///< now
  /// Columns of a terminal on which a line can be overwritten; 0: whole lines are written, now and then.
  std::function<std::size_t()> columns;
};

/// Standard error: nothing if `quiet`; a line that overwrites itself on a terminal; lines now and then
/// elsewhere and where TERM is dumb or not set.
ProgressOutput standard_error(bool quiet);

/// Tells how far a long run is: "audit 12/57 [####....] I6, 95 s, about 360 s left" in as many columns as
/// there are, or every 15 seconds "nipref: audit: 12 of 57 done, now I6, 95 s, about 360 s left": the time so
/// far, and what is left of this part of the run.
class Progress {
 public:
  explicit Progress(ProgressOutput output);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the line that overwrites itself.
  ~Progress();

  /// A new part of the run, with so many items.
  void begin(std::string stage, std::size_t items);
  /// The next item.
  void next(std::string item);
  /// Where it is: so much of the item is done, 0 to 1, and `detail` is at hand.
  void at(double part, std::string detail = "");

 private:
  void tell(double seconds_since_bar);  ///< unless there was a bar, or a line, not so long ago
  [[nodiscard]] double share() const;   ///< of the stage, done
  [[nodiscard]] std::string time_text(double now) const;
  [[nodiscard]] std::string item_text() const;
  [[nodiscard]] std::string bar(std::size_t columns, double now) const;

  ProgressOutput output_;
  double started_ = 0, stage_started_ = 0, told_ = 0;
  std::string stage_, item_, detail_;
  std::size_t items_ = 0, done_ = 0;
  double part_ = 0;
  bool line_is_open_ = false;
};

}  // namespace nipref::verify
