// Catalogue entries of the viscoelastic sheet: fast against ref, the material by name, refusals.
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

using namespace nipref;

TEST_CASE("the memory's integrals keep 4 units in the last place, the moving load's displacements 8") {
  const auto check = [](const char* name, std::size_t points) {
    CAPTURE(name);
    const auto result = verify::audit(verify::find_quantity(name), {points, {}, {}});
    CHECK(result.points >= 4 * points / 5);
    CHECK(result.kept());
    CHECK(result.max_error_ulp > 0);
  };
  for (const char* name : {"J1", "J2", "J3", "J4", "J5", "J6"}) check(name, 500);
  for (const char* name : {"Un", "Vn", "Un_steady", "Vn_steady"}) check(name, 24);
}

TEST_CASE("passing times lie on both sides of the start and of the present, and near them") {
  verify::Random random("passing times");
  int behind = 0, ahead = 0, before = 0, close = 0;
  for (int i = 0; i < 1000; ++i) {
    const double T = verify::draw_passing_time(1, random);
    CHECK(T != 1);
    before += T < 0;
    behind += T > 0 && T < 1;
    ahead += T > 1;
    close += std::fabs(T - 1) < 1e-10;
  }
  for (const int count : {behind, ahead, before, close}) CHECK(count > 50);
}

TEST_CASE("the solid is known by its name, on the command line and in JSON") {
  const Outcome defined = run("eval Un t=3 T=2 'material=standard-linear-solid(relaxation_time=0.5)' --json");
  const Outcome thesis = run("eval Un t=3 T=2 'material=thesis-misprint(relaxation_time=0.5)' --json");
  CHECK(defined.status == 0);
  CHECK(thesis.status == 0);
  CHECK(contains(defined.out, "\"material\": \"standard-linear-solid(bulk=1, relaxation_time=0.5)\""));
  CHECK(contains(thesis.out, "\"material\": \"thesis-misprint(bulk=1, relaxation_time=0.5)\""));
}
