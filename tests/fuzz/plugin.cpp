#include <cstring>
#include <vector>

#include <nipref/verify/grade/internal/protocol.hpp>
#include <nipref/verify/grade/plugin.hpp>

#include "reading.hpp"

using namespace nipref;
using verify::protocol::Message;
using verify::protocol::Noticed;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

void append(std::string& answers, const Message& message) {
  const std::size_t size = message.bytes().size();
  answers.append(reinterpret_cast<const char*>(&size), sizeof size);
  answers.append(message.bytes().data(), size);
}

constexpr std::size_t points = 2, passes = 3;

/// What is heard from a host with one sound kernel of I1 when it is opened, closed, opened, asked for values and timed.
std::string sound_answers() {
  const Message opened = Message().put(Noticed{}).put(0);
  const std::vector<double> values(3 * points, 0.5);
  std::string answers;
  append(
      answers,
      Message().put_text("").put(Noticed{}).put(std::size_t{1}).put_text("k").put_text("I1").put(1U).put(0U));
  append(answers, opened);
  append(answers, Message().put(Noticed{}));
  append(answers, opened);
  append(answers, Message().put(Noticed{}).put(0).put_column(values));
  append(answers, Message().put(0).put(1.0));
  return answers;
}

}  // namespace

/// There are no files of answers to begin with.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned) {
  const std::string answers = sound_answers();
  if (size > 1 || most < answers.size()) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, answers.data(), answers.size());
  return answers.size();
}

/// Plugins whose host says what is given, whatever it is asked: it is a stand-in.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  setenv("NIPREF_KERNEL_HOST", NIPREF_STAND_IN, 1);
  const GivenFile answers(data, size);
  take_or_refuse([&] {
    const verify::Plugin plugin{answers.path(), {}, 5};
    const verify::KernelInfo info = verify::kernels_of(plugin).front();
    verify::PluginKernel kernel(plugin, info.name);
    const std::vector<verify::Point> at(points, verify::Point(info.arity));
    std::vector<double> values(points);
    kernel.evaluate(at, values);
    static_cast<void>(kernel.seconds(at, passes));
    static_cast<void>(kernel.faults());
  });
  return 0;
}
