#include <nipref/data/directory.hpp>
#include <nipref/data/scene/file.hpp>

#include "support/scratch.hpp"

using namespace nipref;

TEST_CASE("a sweep's keys are read with dots and in quotes, as lists or as ranges") {
  const data::SceneSweep sweep = data::scene_sweep(
      {"given",
       "[sweep]\npoints = 7\nload.per_length = [50, 1e2, 0.1]\n"
       "\"material.poisson\" = \"0..0.5:linear\"\nfriction.model = [\"none\", \"full\"]\n"});
  CHECK(sweep.points == 7);
  CHECK(sweep.keys ==
        std::vector<std::pair<std::string, std::string>>{{"friction.model", "none, full"},
                                                         {"load.per_length", "50, 100, 0.1"},
                                                         {"material.poisson", "0..0.5:linear"}});
  CHECK(data::scene_sweep({"given", "title = \"a nip\"\n"}).keys.empty());
}

TEST_CASE("a scene with a sweep is one contact only with a value for each swept key") {
  const ScratchFile file(text_of_file(data::example_scene("thick-frictionless")) +
                         "[sweep]\nload.per_length = [50, 100]\n");
  CHECK_REFUSED(data::load_scene(file.path()),
                file.path() +
                    ":26: sweep.load.per_length = 50, 100: must be solved by nipref solve, or have "
                    "one value given beside the file");
  CHECK(data::load_scene(file.path(), {{"load.per_length", "75"}}).wanted.size() == 4);
}

TEST_CASE("what is no list of numbers or texts is refused with its line") {
  for (const char* wrong :
       {"a = 1", "a = []", "a = [[1]]", "a = [\"x,y\"]", "a = [\"\"]", "a = [true]", "a = [1, {}]",
        "points = 1.5", "points = \"3\"", "points = 0", "points = -1", "points = 10000001"}) {
    CAPTURE(wrong);
    CHECK_REFUSED(data::scene_sweep({"given", std::string("[sweep]\n") + wrong + "\n"}), ":2: sweep.");
  }
}
