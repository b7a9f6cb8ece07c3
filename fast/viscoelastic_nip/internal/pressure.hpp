#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/viscoelastic_nip/internal/layout.hpp>
#include <nipref/fast/viscoelastic_nip/internal/operator.hpp>
#include <nipref/fast/viscoelastic_nip/internal/panel_memory.hpp>

namespace nipref::fast {

/// The compliances of a steadily rolling sheet, in units of the instantaneous N: lengths in half-thicknesses,
/// so that rate = (relaxation rate) b/speed, amplitude = (amplitude) b/(speed N_0).
struct ViscoelasticCompliances {
  std::vector<MemoryTerm> normal;  ///< of N beside its instantaneous part 1
  double theta2_instantaneous;     ///< over that of N
  std::vector<MemoryTerm> theta2;  ///< its rates are among those of N = theta1 + theta2
};

/// The contact of a viscoelastic nip, of given length, solved: dimensionless as HalfContact (pressure times
/// 2 R N_0/b, displacements times 2 R/b^2). With d the distance from the leading end the surface follows u =
/// edge_displacement + d (2A - d) + 2 offset d.
class ViscoelasticPressure {
 public:
  ViscoelasticPressure(const ViscoelasticLayout& layout, const ViscoelasticCompliances& material,
                       double tolerance, CountedKernels& kernels);

  /// Of the same length, as rounding could have made it: see SolutionAndTwins.
  std::vector<std::unique_ptr<ViscoelasticPressure>> twins;

  [[nodiscard]] const ViscoelasticLayout& layout() const { return layout_; }
  [[nodiscard]] double half_length() const { return layout_.half_length(); }
  [[nodiscard]] double edge_displacement() const { return edge_displacement_; }  ///< at the leading end
  /// Of the middle of the contact from the line through the rollers' centres, towards the leading side.
  [[nodiscard]] double offset() const { return offset_; }
  [[nodiscard]] double leading_length() const { return half_length() + offset_; }
  [[nodiscard]] double trailing_length() const { return half_length() - offset_; }
  /// Of Y = y, counted from the line through the rollers' centres.
  [[nodiscard]] ContactPlace place(double y) const;
  [[nodiscard]] double load() const { return load_; }
  /// Of the pressure about the middle of the contact, positive if more of it is on the leading side.
  [[nodiscard]] double moment() const { return moment_; }
  [[nodiscard]] double pressure(ContactPlace place) const;  ///< inside the contact
  /// Of its expansions, and of the one at `place`, inside the contact: see expansion_tail.hpp.
  [[nodiscard]] double tail() const { return std::ranges::max(tails_); }
  [[nodiscard]] double tail_at(ContactPlace place) const { return tails_[layout_.panel_of(place)]; }

  /// Normal displacement anywhere: of the roller inside the contact, by quadrature outside.
  [[nodiscard]] double normal_displacement(ContactPlace place, double tolerance,
                                           CountedKernels& kernels) const;
  /// Tangential displacement at `place` less that at `reference`, along the leading direction.
  [[nodiscard]] double tangential_displacement(ContactPlace place, ContactPlace reference, double tolerance,
                                               CountedKernels& kernels) const;
  /// Its derivative towards the leading side, the strain of the surface.
  [[nodiscard]] double strain(ContactPlace place, double tolerance, CountedKernels& kernels) const;
  /// What the parts of the tangential displacement are together over the contact, of which large parts may cancel.
  [[nodiscard]] double tangential_size(double tolerance, CountedKernels& kernels) const;

 private:
  /// instantaneous p + sum of the terms' memories, on each panel, and what of it trails behind the contact.
  struct Response {
    std::vector<Eigen::VectorXd> on_panel;
    std::vector<MemoryTerm> trailing;
  };
  /// One term on all panels.
  struct TermMemory {
    MemoryTerm term;
    std::vector<PanelMemory> on_panel;
  };
  ViscoelasticPressure(const ViscoelasticLayout& layout, const ViscoelasticCompliances& material,
                       const std::vector<TermMemory>& memory, const Eigen::VectorXd& unknowns);
  void take(const ViscoelasticCompliances& material, const std::vector<TermMemory>& memory,
            const Eigen::VectorXd& unknowns);
  [[nodiscard]] SolutionAndTwins solutions(const std::vector<TermMemory>& memory, double tolerance,
                                           CountedKernels& kernels) const;
  [[nodiscard]] Eigen::VectorXd coefficients(std::size_t panel) const;
  [[nodiscard]] Response response(double instantaneous, const std::vector<MemoryTerm>& terms,
                                  const std::vector<TermMemory>& memory) const;
  /// Of the surface itself: what it has left behind the contact too, 0 ahead of it.
  [[nodiscard]] double value(const Response& response, ContactPlace place) const;
  [[nodiscard]] double tangential_part(const Response& response, ViscoelasticKernel kernel,
                                       ContactPlace place, ContactPlace reference,
                                       ViscoelasticOperator& from) const;
  void integrate();

  ViscoelasticLayout layout_;
  Eigen::VectorXd unknowns_;
  double edge_displacement_ = 0;
  double offset_ = 0;
  double load_ = 0;
  double moment_ = 0;
  std::vector<double> tails_;
  Response normal_response_;
  Response theta2_response_;
};

}  // namespace nipref::fast
