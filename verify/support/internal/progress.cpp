#include <unistd.h>

#include <chrono>

#include <nipref/verify/support/internal/progress.hpp>
#include <nipref/verify/support/text.hpp>

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

}  // namespace

ProgressOutput standard_error(bool quiet) {
  if (quiet) return {};
  return {[](const std::string& text) { fmt::print(stderr, "{}", text); },
          [] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
          },
          [overwrites = can_overwrite()] { return overwrites ? columns_of(STDERR_FILENO) : 0; }};
}

Progress::Progress(ProgressOutput output) : output_(std::move(output)) {
  if (output_.write) started_ = shown_ = output_.seconds();
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
  show(0);
}

void Progress::at(double part, std::string detail) {
  part_ = std::min(part, 1.0);
  detail_ = std::move(detail);
  show(seconds_between_bars);
}

void Progress::tell(const std::string& lines) {
  if (output_.write && !lines.empty()) output_.write((line_is_open_ ? start_and_wipe : "") + lines);
  line_is_open_ = false;
}

void Progress::show(double seconds_since_bar) {
  if (!output_.write) return;
  const double now = output_.seconds();
  const std::size_t columns = output_.columns();
  if (now - shown_ < (columns > 0 ? seconds_since_bar : seconds_between_lines)) return;
  shown_ = now;
  line_is_open_ = columns > 0;
  const double share = items_ == 0 ? 0 : (static_cast<double>(done_) + part_) / static_cast<double>(items_);
  const double left = (now - stage_started_) * (1 / share - 1);
  const std::string item = detail_.empty() ? item_ : item_ + " " + detail_;
  const std::string time =
      fmt::format("{:.0f} s{}", now - started_, share > 0 ? fmt::format(", about {:.0f} s left", left) : "");
  if (columns == 0)
    return output_.write(
        fmt::format("nipref: {}: {} of {} done, now {}, {}\n", stage_, done_, items_, item, time));
  const std::string before = fmt::format("{} {}/{} ", stage_, done_, items_);
  const std::string after = fmt::format(" {}, {}", item, time);
  const std::size_t taken = before.size() + after.size() + 3;
  // The last column stays empty, because terminals go on to the next line there.
  if (taken + narrowest_bar > columns)
    return output_.write(start_and_wipe + (before + after.substr(1)).substr(0, columns - 1));
  const std::size_t length = std::min(columns - taken, widest_bar);
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(length));
  output_.write(
      fmt::format("{}{}[{:#<{}}{:.<{}}]{}", start_and_wipe, before, "", filled, "", length - filled, after));
}

}  // namespace nipref::verify
