#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/mpi/ranks.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
namespace {

/// The message to a rank with the block to compute. If `work` is the number of works, the rank has to end.
using Order = std::array<std::uint64_t, 2>;

/// The message from a rank, as JSON: {} at the start, the findings of its block, or an error.
struct Report {
  int rank;
  Json json;
};

Report take_report() {
  MPI_Status status;
  // MPI_Probe would use a whole core while it waits.
  for (int there = 0; there == 0;) {
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
    if (there == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), ' ');
  MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return {status.MPI_SOURCE, Json::parse(text)};
}

void give_order(int rank, Order order) {
  MPI_Send(order.data(), static_cast<int>(order.size()), MPI_UINT64_T, rank, 0, MPI_COMM_WORLD);
}

void refuse_failed(const Json& json) {
  if (json.has("refused")) {
    const std::vector<Json> parts = json.at("refused").items();
    throw data::BadInput(parts[0].as_text(), parts[1].as_text(), parts[2].as_text());
  }
  if (json.has("failed")) throw std::runtime_error(json.at("failed").as_text());
}

/// Ends every rank at its next message.
class Ranks {
 public:
  Ranks(int ranks, std::size_t works) : working_(ranks - 1), at_home_{works, 0} {}
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks() {
    while (are_working()) send_home(take_report().rank);
  }

  [[nodiscard]] bool are_working() const { return working_ > 0; }
  void send_home(int rank) {
    give_order(rank, at_home_);
    --working_;
  }

 private:
  int working_;
  Order at_home_;
};

Json report_of(BlockWork& work, std::size_t block) try {
  return {{"found", work.do_block(block, {})}};
} catch (const data::BadInput& error) {
  return {{"refused", std::vector<Json>{error.argument(), error.value(), error.allowed()}}};
} catch (const Interrupted&) {
  return Json::object();
} catch (const std::exception& error) {
  return {{"failed", error.what()}};
}

void report(const Json& json) {
  const std::string text = json.line();
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, 0, MPI_COMM_WORLD);
}

}  // namespace

void hand_out_blocks(AuditRun& run, int count, Progress& progress) {
  const std::vector<BlockWork*>& works = run.works();
  Ranks ranks(count, works.size());
  std::vector<std::optional<BlockAt>> doing(static_cast<std::size_t>(count));
  progress.begin("audit", works.size());
  std::size_t begun = 0;  // works
  while (ranks.are_working()) {
    const auto [rank, json] = take_report();
    auto& block = doing[static_cast<std::size_t>(rank)];
    std::optional<BlockAt> next;
    try {
      refuse_failed(json);
      if (block && json.has("found")) {
        works[block->work]->add(block->block, json.at("found"));
        run.keep(*block, json.at("found"));
      }
      if (!interrupted()) next = run.next();
    } catch (...) {
      ranks.send_home(rank);
      throw;
    }
    block = next;
    if (!block) {
      ranks.send_home(rank);
      continue;
    }
    for (; begun <= block->work; ++begun) progress.next(works[begun]->name());
    progress.at(static_cast<double>(block->block) / static_cast<double>(works[block->work]->blocks()));
    give_order(rank, {block->work, block->block});
  }
}

void do_blocks_of_ranks(const std::vector<BlockWork*>& works) {
  for (Json found = Json::object();;) {
    report(found);
    Order order;
    MPI_Recv(order.data(), static_cast<int>(order.size()), MPI_UINT64_T, 0, 0, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    if (order[0] == works.size()) return;
    found = report_of(*works[order[0]], order[1]);
  }
}

}  // namespace nipref::verify
