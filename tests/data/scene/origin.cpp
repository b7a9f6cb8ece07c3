#include <nipref/data/scene/origin.hpp>

#include "support/test.hpp"

using namespace nipref;

TEST_CASE("what is refused again keeps its value and its domain, whatever separators are in them") {
  data::SceneOrigin origin("my = scene: 1.toml");
  origin.note("sliding.speed", 7);
  const data::BadInput error("speed = v: cross", "a: b = c", "must be < critical: one = that");
  try {
    origin.refuse_as("sliding.speed", error);
  } catch (const data::BadInput& again) {
    CHECK(again.argument() == "my = scene: 1.toml:7: sliding.speed");
    CHECK(again.value() == "a: b = c");
    CHECK(again.allowed() == "must be < critical: one = that");
  }
  // Refused again under another name.
  try {
    origin.refuse_as("load", data::BadInput(origin.locate("sliding.speed"), 0.5, "must be 0"));
  } catch (const data::BadInput& again) {
    CHECK(std::string(again.what()) == "my = scene: 1.toml: load = 0.5: must be 0");
  }
}
