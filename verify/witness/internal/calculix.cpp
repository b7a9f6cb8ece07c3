#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <nipref/verify/witness/internal/calculix.hpp>
#include <nipref/verify/witness/internal/strip_mesh.hpp>

namespace nipref::verify::calculix {
namespace {

void write_geometry(std::ostream& out, const StripMesh& mesh) {
  out << "*NODE\n";
  for (std::size_t k = 0; k < mesh.across.size(); ++k) {
    for (std::size_t i = 0; i < mesh.along.size(); ++i) {
      if (i % 2 == 1 && k % 2 == 1) continue;
      out << fmt::format("{},{:.12e},{:.12e}\n", mesh.number(i, k), mesh.along[i], mesh.across[k]);
    }
  }
  out << "*ELEMENT,TYPE=CPE8,ELSET=STRIP\n";
  std::size_t element = 0;
  for (std::size_t k = 0; k + 2 < mesh.across.size(); k += 2) {
    for (std::size_t i = 0; i + 2 < mesh.along.size(); i += 2) {
      out << fmt::format("{},{},{},{},{},{},{},{},{}\n", ++element, mesh.number(i, k), mesh.number(i + 2, k),
                         mesh.number(i + 2, k + 2), mesh.number(i, k + 2), mesh.number(i + 1, k),
                         mesh.number(i + 2, k + 1), mesh.number(i + 1, k + 2), mesh.number(i, k + 1));
    }
  }
}

void write_sets(std::ostream& out, const StripMesh& mesh) {
  const auto write = [&](const char* name, std::size_t count, auto node) {
    out << "*NSET,NSET=" << name << '\n';
    for (std::size_t i = 0; i < count; ++i) out << node(i) << ",\n";
  };
  write("MIDDLEPLANE", mesh.along.size(), [&](std::size_t i) { return mesh.number(i, 0); });
  write("MIDDLE", mesh.across.size(), [&](std::size_t k) { return mesh.number(0, k); });
  write("CONTACT", mesh.contact_nodes, [&](std::size_t i) { return mesh.surface_number(i); });
  write("SURFACE", mesh.along.size(), [&](std::size_t i) { return mesh.surface_number(i); });
}

void write_step(std::ostream& out, const IndentedStrip& strip, const StripMesh& mesh) {
  out << fmt::format("*MATERIAL,NAME=SHEET\n*ELASTIC\n{:.12e},{:.12e}\n", strip.young, strip.poisson)
      << "*SOLID SECTION,ELSET=STRIP,MATERIAL=SHEET\n*STEP\n*STATIC\n*BOUNDARY\nMIDDLEPLANE,2,2\nMIDDLE,1,1\n";
  for (std::size_t i = 0; i < mesh.contact_nodes; ++i) {
    const double y = mesh.along[i];
    const double u = strip.indentation - y * y / (2 * strip.radius);
    out << fmt::format("{},2,2,{:.12e}\n", mesh.surface_number(i), -u);
    if (strip.creep && i > 0)
      out << fmt::format("{},1,1,{:.12e}\n", mesh.surface_number(i), *strip.creep * y);
  }
  out << "*NODE PRINT,NSET=CONTACT,TOTALS=ONLY\nRF\n*NODE PRINT,NSET=SURFACE\nU\n*END STEP\n";
}

/// Reads the program's printed results.
Response read_response(std::istream& in, const StripMesh& mesh) {
  Response response{NAN, {}};
  std::string line;
  bool forces = false;
  while (std::getline(in, line)) {
    if (line.find("total force") != std::string::npos) forces = true;
    if (line.find("displacements") != std::string::npos) forces = false;
    std::istringstream numbers(line);
    double along = 0;
    double across = 0;
    if (forces && numbers >> along >> across) response.reaction = -across;
    std::size_t node = 0;
    if (!forces && numbers >> node >> along >> across) {
      response.surface[mesh.along.at(node - mesh.surface_number(0))] = {-across, along};
    }
  }
  return response;
}

}  // namespace

bool is_installed() { return std::system("command -v ccx >/dev/null 2>&1") == 0; }

Response respond(const IndentedStrip& strip) {
  std::string folder = (std::filesystem::temp_directory_path() / "nipref-ccx-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no temporary folder for CalculiX");
  const StripMesh mesh(strip.half_thickness, strip.contact_end);
  {
    std::ofstream input(folder + "/strip.inp");
    write_geometry(input, mesh);
    write_sets(input, mesh);
    write_step(input, strip, mesh);
  }
  const int status = std::system(("cd '" + folder + "' && ccx -i strip >strip.out 2>&1").c_str());
  std::ifstream printed(folder + "/strip.dat");
  const Response response = read_response(printed, mesh);
  std::filesystem::remove_all(folder);
  if (status != 0 || response.surface.size() != mesh.along.size())
    throw std::runtime_error("CalculiX did not solve a strip");
  return response;
}

}  // namespace nipref::verify::calculix
