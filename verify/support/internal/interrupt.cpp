#include <atomic>
#include <csignal>

#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
namespace {

std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may take no lock");

}  // namespace

void stop_gently_on_interrupt() {
  struct sigaction now = {};
  sigaction(SIGINT, nullptr, &now);
  if (now.sa_handler == SIG_IGN) return;
  struct sigaction gentle = {};
  gentle.sa_handler = [](int) { noted = true; };
  gentle.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &gentle, nullptr);
}

bool interrupted() { return noted; }

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace nipref::verify
