#include <fstream>
#include <stdexcept>

#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/witness/witness.hpp>

namespace nipref::verify {
namespace {

/// The finite-element program CalculiX (ccx) as an independent check of contacts, if it is installed.
namespace calculix {

/// The prescribed displacements of the strip's surface for 0 <= y <= contact_end: u = indentation - y^2/(2 radius)
/// towards the middle plane and, if it sticks, v = creep y. The rest of the surface is free. The strip is symmetric
/// about the middle plane and about y = 0.
struct IndentedStrip {
  double young, poisson, half_thickness, contact_end, indentation, radius;
  std::optional<double> creep;
};

struct SurfaceDisplacement {
  double normal;      ///< towards the middle plane
  double tangential;  ///< along y
};

struct Response {
  double reaction;                                ///< of the prescribed nodes, against the indentation
  std::map<double, SurfaceDisplacement> surface;  ///< by y
};

/// The positions of nodes along a side: corners alternate with the midpoints between them.
using Side = std::vector<double>;

/// Distances from 0 to `length` in steps that start with `first` and grow by 1.15 up to `largest`. All steps are
/// scaled so that the last one ends at `length`.
std::vector<double> graded(double length, double first, double largest) {
  std::vector<double> distances{0};
  for (double step = first; distances.back() < length; step = std::min(1.15 * step, largest))
    distances.push_back(distances.back() + step);
  const double stretch = length / distances.back();
  for (double& distance : distances) distance *= stretch;
  return distances;
}

/// The same from the other end: the first step is the last before `length`.
std::vector<double> graded_towards(double length, double first, double largest) {
  std::vector<double> positions = graded(length, first, largest);
  for (double& position : positions) position = length - position;
  std::ranges::reverse(positions);
  return positions;
}

Side with_middles(const std::vector<double>& corners) {
  Side side{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    side.push_back((corners[i - 1] + corners[i]) / 2);
    side.push_back(corners[i]);
  }
  return side;
}

/// Eight-node elements of half a sheet in plane strain: y >= 0 along the sheet from the middle of the nip, z from the
/// middle plane, 0, to the surface, `half_thickness`. The elements are smallest at the contact's end, where the
/// tractions end like square roots. The strip ends four thicknesses beyond, where the effect of the load has decayed
/// to e^{-2.1 8}.
struct StripMesh {
  StripMesh(double half_thickness, double contact_end) {
    const double first = contact_end / 1000;
    const double largest = half_thickness / 6;
    std::vector<double> corners = graded_towards(contact_end, first, largest);
    contact_nodes = 2 * corners.size() - 1;
    const std::vector<double> outwards = graded(8 * half_thickness, first, largest);
    for (std::size_t i = 1; i < outwards.size(); ++i) corners.push_back(contact_end + outwards[i]);
    along = with_middles(corners);
    across = with_middles(graded_towards(half_thickness, first, largest));
  }

  /// The number of the node in column i and row k; rows of midpoints have nodes in every second column only.
  [[nodiscard]] std::size_t number(std::size_t i, std::size_t k) const { return 1 + i + along.size() * k; }
  [[nodiscard]] std::size_t surface_number(std::size_t i) const { return number(i, across.size() - 1); }

  Side along, across;
  std::size_t contact_nodes;  ///< columns 0 .. contact_nodes - 1 are prescribed
};

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
    if (!forces && numbers >> node >> along >> across)
      response.surface[mesh.along.at(node - mesh.surface_number(0))] = {-across, along};
  }
  return response;
}

bool is_installed() { return std::system("command -v ccx >/dev/null 2>&1") == 0; }

/// The solution by CalculiX, which runs in a temporary folder. Throws std::runtime_error if the program fails.
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

}  // namespace calculix

/// Gives the program the shape of the surface in the contact. Compares the surfaces there and as far again beside it.
Witnessed witness_of(double thickness, data::Friction friction) {
  constexpr double load = 100, accuracy = 1e-9;
  const data::ElasticNipProblem problem{
      .nip = data::seed::nip(thickness), .given = data::GivenLoad{load}, .friction = friction};
  const SolvedInDouble contact = solve_nip(problem, accuracy);
  const auto value = [&](ResultId id) { return contact->number(id).value; };
  const bool is_gripped = friction == data::Friction::full;
  calculix::IndentedStrip strip{.young = problem.nip.material.young,
                                .poisson = problem.nip.material.poisson,
                                .half_thickness = problem.nip.half_thickness(),
                                .contact_end = value(ResultId::contact_length) / 2,
                                .indentation = value(ResultId::indentation),
                                .radius = problem.nip.roller_radius,
                                .creep = {}};
  if (is_gripped) strip.creep = value(ResultId::creep_ratio);
  const calculix::Response response = calculix::respond(strip);
  double normal = 0, tangential = 0, largest_tangential = 0;
  for (const auto& [y, there] : response.surface) {
    if (y >= 2 * strip.contact_end) break;
    const double u = contact->at(ResultId::normal_displacement, y).value,
                 v = contact->at(ResultId::tangential_displacement, y).value;
    normal = std::max(normal, std::fabs(there.normal - u));
    tangential = std::max(tangential, std::fabs(there.tangential - v));
    largest_tangential = std::max(largest_tangential, std::fabs(v));
  }
  return {thickness, is_gripped, std::fabs(2 * response.reaction / load - 1), normal / strip.indentation,
          tangential / largest_tangential};
}

}  // namespace

bool Witnessed::agrees() const {
  return load <= load_limit && normal <= normal_limit && tangential <= tangential_limit;
}

bool Witness::agrees() const { return std::ranges::all_of(contacts, &Witnessed::agrees); }

Witness outside_witness() {
  if (!calculix::is_installed()) return {};
  return {true,
          {witness_of(1.0, data::Friction::none), witness_of(0.0625, data::Friction::none),
           witness_of(0.25, data::Friction::full), witness_of(0.0625, data::Friction::full)}};
}

Json witness_json(const Witness& witness) {
  if (!witness.installed) return {};
  return json_list(witness.contacts, [](const Witnessed& contact) {
    return Json{{"thickness", contact.thickness},
                {"friction", contact.gripped ? "full" : "none"},
                {"load", contact.load},
                {"normal_displacement", contact.normal},
                {"tangential_displacement", contact.tangential},
                {"agrees", contact.agrees()}};
  });
}

}  // namespace nipref::verify
