#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/cli/run_folder.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr std::size_t most_shards = 1'000'000;

[[noreturn]] void refuse_env(const std::string& why) { throw BadInput("shard", "env", why); }

std::optional<std::size_t> number_of(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stopped == end && !text.empty() ? std::optional(number) : std::nullopt;
}

std::optional<std::size_t> number_in(const Environment& variable, const std::string& name) {
  const auto text = variable(name);
  if (!text) return std::nullopt;
  const auto number = number_of(*text);
  if (!number) refuse_env(fmt::format("must find a whole number in {}, where {} is", name, *text));
  return number;
}

/// What two variables say; nothing where neither is set.
std::optional<Shard> pair_in(const Environment& variable, const std::string& index,
                             const std::string& count) {
  const auto which = number_in(variable, index), of = number_in(variable, count);
  if (!which && !of) return std::nullopt;
  if (!which || !of)
    refuse_env(fmt::format("must find {} set beside {}", which ? count : index, which ? index : count));
  if (*which >= *of || *of > most_shards)
    refuse_env(fmt::format("must find {} below {}, and that at most {}: they are {} and {}", index, count,
                           most_shards, *which, *of));
  return Shard{*which, *of};
}

/// The one of two that is set, or both alike.
std::optional<Shard> either(const std::optional<Shard>& one, const std::string& ones,
                            const std::optional<Shard>& other, const std::string& others) {
  if (one && other && !(*one == *other))
    refuse_env(fmt::format("must find no contradiction: {} say {}/{}, {} say {}/{}", ones, one->index + 1,
                           one->of, others, other->index + 1, other->of));
  return one ? one : other;
}

/// A shell of Slurm's has a number of tasks and is none of them; a script without tasks has an id and no number.
std::optional<Shard> slurm_task(const Environment& variable) {
  if (!variable("SLURM_PROCID") || !variable("SLURM_NTASKS")) return std::nullopt;
  return pair_in(variable, "SLURM_PROCID", "SLURM_NTASKS");
}

std::optional<Shard> slurm_array(const Environment& variable) {
  const auto id = number_in(variable, "SLURM_ARRAY_TASK_ID");
  const auto count = number_in(variable, "SLURM_ARRAY_TASK_COUNT");
  if (!id && !count) return std::nullopt;
  const std::size_t least = number_in(variable, "SLURM_ARRAY_TASK_MIN").value_or(0);
  const std::size_t step = number_in(variable, "SLURM_ARRAY_TASK_STEP").value_or(1);
  if (!id || !count || *id < least || step == 0 || (*id - least) % step != 0 ||
      (*id - least) / step >= *count)
    refuse_env(
        "must find SLURM_ARRAY_TASK_ID, _COUNT, _MIN and _STEP of an array without gaps, as --array=0-99 is");
  return Shard{(*id - least) / step, *count};
}

Shard shard_of_environment(const Environment& variable) {
  const auto mpi = either(pair_in(variable, "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
                          "OMPI_COMM_WORLD_RANK and _SIZE", pair_in(variable, "PMI_RANK", "PMI_SIZE"),
                          "PMI_RANK and PMI_SIZE");
  const auto rank = mpi ? mpi : slurm_task(variable);
  const auto job = either(slurm_array(variable), "SLURM_ARRAY_TASK_ID and _COUNT",
                          pair_in(variable, "JOB_COMPLETION_INDEX", "JOB_COMPLETIONS"),
                          "JOB_COMPLETION_INDEX and JOB_COMPLETIONS");
  if (!rank && !job)
    refuse_env(
        "must be started by Open MPI, MPICH, Slurm or as an indexed job of Kubernetes, whose variables are not "
        "set; or be i/N");
  const Shard inner = rank.value_or(Shard{}), outer = job.value_or(Shard{});
  return {outer.index * inner.of + inner.index, outer.of * inner.of};
}

}  // namespace

std::optional<std::string> environment(const std::string& name) {
  const char* const text = std::getenv(name.c_str());
  return text == nullptr ? std::nullopt : std::optional<std::string>(text);
}

Shard parse_shard(const std::string& text, const Environment& variable) {
  if (text == "env") return shard_of_environment(variable);
  const std::size_t slash = text.find('/');
  const auto index = number_of(text.substr(0, slash));
  const auto of = slash == std::string::npos ? std::nullopt : number_of(text.substr(slash + 1));
  if (!index || !of || *index < 1 || *index > *of || *of > most_shards)
    throw BadInput("shard", text, fmt::format("must be i/N with 1 <= i <= N <= {}, or env", most_shards));
  return {*index - 1, *of};
}

}  // namespace nipref::verify
