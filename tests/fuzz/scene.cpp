#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/sweep.hpp>

#include "reading.hpp"

using namespace nipref;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  take_or_refuse([&] { static_cast<void>(data::parse_scene(text, "given")); });
  take_or_refuse([&] { static_cast<void>(data::scene_sweep({"given", text})); });
  return 0;
}
