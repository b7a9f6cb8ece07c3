#include <chrono>

#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

/// A round evaluates the first `count` arguments `passes` times.
struct Round {
  std::size_t count;
  std::size_t passes;
};

/// The seconds for `passes` times the first `count` evaluations.
double seconds_of_passes(const Contender& contender, std::size_t count, std::size_t passes) {
  if (contender.seconds) return contender.seconds(count, passes);
  return seconds_of([&] {
    for (std::size_t pass = 0; pass < passes; ++pass) contender.run(count);
  });
}

/// Plans a round that takes the given time. The very first run may fill caches, so its time is not used.
Round plan(const Contender& contender, double seconds) {
  std::size_t count = std::min(contender.least, contender.most);
  double taken = seconds_of_passes(contender, count, 1);
  while (count < contender.most && taken < seconds / 2) {
    count = std::min(2 * count, contender.most);
    taken = seconds_of_passes(contender, count, 1);
  }
  if (count == contender.least) taken = seconds_of_passes(contender, count, 1);
  return {count, std::max<std::size_t>(1, static_cast<std::size_t>(seconds / taken))};
}

/// The passes of a fast contender follow one that is not timed and fills the processor's caches.
double seconds_per_evaluation(const Contender& contender, const Round& round) {
  if (round.passes > 1) contender.run(round.count);
  return seconds_of_passes(contender, round.count, round.passes) /
         static_cast<double>(round.count * round.passes);
}

}  // namespace

double quantile(std::vector<double> numbers, double share) {
  std::ranges::sort(numbers);
  return numbers[static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1) + 0.5)];
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Timing> time_interleaved(const std::vector<Contender>& contenders, int rounds,
                                     double seconds_per_round) {
  const auto plans = mapped(contenders, [&](const Contender& one) { return plan(one, seconds_per_round); });
  std::vector<std::vector<double>> samples(contenders.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i)
      samples[i].push_back(seconds_per_evaluation(contenders[i], plans[i]));
  return mapped(std::views::iota(std::size_t{0}, samples.size()), [&](std::size_t i) -> Timing {
    const std::vector<double>& all = samples[i];
    return {quantile(all, 0.5), quantile(all, 0.25), quantile(all, 0.75), plans[i].count, all};
  });
}

}  // namespace nipref::verify
