#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/sweep.hpp>

#include "reading.hpp"

using namespace nipref;

void read_given(const std::string& text, const GivenFile&) {
  take_or_refuse([&] { static_cast<void>(data::parse_scene(text, "given")); });
  take_or_refuse([&] { static_cast<void>(data::scene_sweep({"given", text})); });
}
