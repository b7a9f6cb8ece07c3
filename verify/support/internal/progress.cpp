#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <nipref/verify/support/internal/progress.hpp>

namespace nipref::verify {
namespace {

constexpr double seconds_between_lines = 15;
constexpr double seconds_between_bars = 0.1;
constexpr std::size_t widest_bar = 30;
constexpr std::size_t narrowest_bar = 6;
constexpr auto start_and_wipe = "\r\x1b[K";

bool can_overwrite() {
  const char* const term = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && term != nullptr && *term != '\0' && std::string_view(term) != "dumb";
}

/// Asked anew each time: windows change.
std::size_t columns_of_terminal() {
  constexpr std::size_t usual = 80;
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

double seconds_of_steady_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressOutput standard_error(bool quiet) {
  if (quiet) return {};
  return {[](const std::string& text) { fmt::print(stderr, "{}", text); }, seconds_of_steady_clock,
          can_overwrite() ? columns_of_terminal : +[] { return std::size_t{0}; }};
}

Progress::Progress(ProgressOutput output) : output_(std::move(output)) {
  if (output_.write) started_ = told_ = output_.seconds();
}

Progress::~Progress() {
  if (line_is_open_) output_.write(start_and_wipe);
}

void Progress::begin(std::string stage, std::size_t items) {
  stage_ = std::move(stage);
  items_ = items;
  done_ = 0;
  item_.clear();
  if (output_.write) stage_started_ = output_.seconds();
}

void Progress::next(std::string item) {
  if (!item_.empty()) ++done_;
  item_ = std::move(item);
  part_ = 0;
  detail_.clear();
  if (output_.write) tell(0);
}

void Progress::at(double part, std::string detail) {
  part_ = std::min(part, 1.0);
  detail_ = std::move(detail);
  if (output_.write) tell(seconds_between_bars);
}

void Progress::tell(double seconds_since_bar) {
  const double now = output_.seconds();
  const std::size_t columns = output_.columns();
  if (now - told_ < (columns > 0 ? seconds_since_bar : seconds_between_lines)) return;
  told_ = now;
  line_is_open_ = columns > 0;
  output_.write(columns > 0 ? start_and_wipe + bar(columns, now)
                            : fmt::format("nipref: {}: {} of {} done, now {}, {}\n", stage_, done_, items_,
                                          item_text(), time_text(now)));
}

double Progress::share() const {
  return items_ == 0 ? 0 : (static_cast<double>(done_) + part_) / static_cast<double>(items_);
}

std::string Progress::item_text() const { return detail_.empty() ? item_ : item_ + " " + detail_; }

std::string Progress::time_text(double now) const {
  const double left = (now - stage_started_) * (1 / share() - 1);
  return fmt::format("{:.0f} s{}", now - started_,
                     share() > 0 ? fmt::format(", about {:.0f} s left", left) : "");
}

/// The last column stays empty: terminals go on to the next line there.
std::string Progress::bar(std::size_t columns, double now) const {
  const std::string before = fmt::format("{} {}/{} ", stage_, done_, items_);
  const std::string after = fmt::format(" {}, {}", item_text(), time_text(now));
  const std::size_t taken = before.size() + after.size() + 3;
  if (taken + narrowest_bar > columns) return (before + after.substr(1)).substr(0, columns - 1);
  const std::size_t length = std::min(columns - taken, widest_bar);
  const auto filled = static_cast<std::size_t>(share() * static_cast<double>(length));
  return fmt::format("{}[{:#<{}}{:.<{}}]{}", before, "", filled, "", length - filled, after);
}

}  // namespace nipref::verify
