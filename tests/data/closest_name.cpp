#include <nipref/data/closest_name.hpp>

#include "support/test.hpp"

using nipref::data::did_you_mean;

TEST_CASE("the nearest names are suggested, and no others") {
  CHECK(did_you_mean("radios", {"radius", "speed"}) == "did you mean radius? ");
  CHECK(did_you_mean("evla", {"eval", "solve"}) == "did you mean eval? ");
  CHECK(did_you_mean("I9", {"J1", "I1", "I2", "un", "I3", "I4"}, 3) == "did you mean I1, I2 or I3? ");
  CHECK(did_you_mean("speeed", {"spe", "speed", "speedy"}, 9) == "did you mean speed? ");
  CHECK(did_you_mean("CREEP", {"creep"}) == "did you mean creep? ");
  CHECK(did_you_mean("length", {"radius", "contact_length"}) == "did you mean contact_length? ");
  CHECK(did_you_mean("un", {"root.un"}).empty());
  CHECK(did_you_mean("P", {"Q"}).empty());
  CHECK(did_you_mean("", {"Q"}).empty());
  CHECK(did_you_mean("frobnicate", {"eval", "audit"}).empty());
  CHECK(did_you_mean("eval", {}).empty());
}
