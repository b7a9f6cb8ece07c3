#include <nipref/data/material/seed_solids.hpp>
#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/data/table/index.hpp>

#include "support/test.hpp"

// The constants of the seeds are those that stand above the seeds' tables.

using namespace nipref;

TEST_CASE("steel and graphite epoxy have the constants that stand above the papers' tables") {
  for (const char* id : {"brock2013-1", "brock2013-2", "brock2013-3"}) {
    CAPTURE(id);
    const data::Table table = data::load_table_by_id(id);
    const auto stated = [&](const char* name) { return table.parameter(name).value; };
    const data::TransverselyIsotropicSolid& epoxy = data::seed::graphite_epoxy;
    CHECK(stated("C11") == epoxy.c11);
    CHECK(stated("C33") == epoxy.c33);
    CHECK(stated("C13") == epoxy.c13);
    CHECK(stated("C55") == epoxy.c44);
    CHECK(stated("C66") == epoxy.c66);
    CHECK(stated("rho") == epoxy.density);
    CHECK(stated("mu0") == data::seed::steel.shear);
    CHECK(stated("rho0") == data::seed::steel.density);
    const double poisson = data::seed::steel.poisson;
    CHECK(std::fabs(std::sqrt((2 - 2 * poisson) / (1 - 2 * poisson)) - stated("c_D")) < 5e-5);
  }
}

TEST_CASE("the thesis's roller and its four sheets have the constants that stand above its tables") {
  std::array<int, 4> tables{};
  for (const std::string& id : data::table_ids()) {
    if (!id.starts_with("thesis-")) continue;
    CAPTURE(id);
    const data::Table table = data::load_table_by_id(id);
    CHECK(table.parameter("R").value == data::seed::roller_radius);
    const auto* const thickness =
        std::ranges::find(data::seed::sheet_thicknesses, table.parameter("B").value);
    REQUIRE(thickness != data::seed::sheet_thicknesses.end());
    ++tables[static_cast<std::size_t>(thickness - data::seed::sheet_thicknesses.begin())];
    if (table.has_column("W")) {  // elastic
      CHECK(table.parameter("E").value == data::seed::sheet.young);
      CHECK(table.parameter("poisson").value == data::seed::sheet.poisson);
    } else {
      CHECK(table.parameter("K0").value == data::seed::sheet.young);
      CHECK(table.parameter("G0/K0").value == data::thesis_shear_over_bulk);
    }
  }
  CHECK(tables == std::array{6, 6, 6, 6});
}
