#pragma once
#include <vector>

#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// The same contact by equal elements with constant tractions, held to the rollers at their middles: in steady rolling
/// an element slips by how far its surface moves against the roller from the middle of the element before it to its own.
/// The elements that press, stick or slip are found by an active set. First order in the elements' width: it says which
/// zones there are.
struct ElementContact {
  struct Element {
    double e;  ///< of its middle, from the line through the rollers' centres, along the motion
    bool presses;
    int sign;                ///< as a Zone's
    double pressure, shear;  ///< 0 if it does not press
  };
  std::vector<Element> elements;
  double width, creep, approach;
  bool settled;  ///< whether all conditions are met

  [[nodiscard]] double length() const;
  /// Zones of whole elements, from the first that presses to the last one.
  [[nodiscard]] Zones zones() const;
};

/// How far elements reach, over half the length of a contact without friction.
inline constexpr double element_reach = 1.3;

/// `elements` of them over so many lengths of a contact of about the task's load or length. In rare cases they do not
/// settle; the last state is the result.
ElementContact element_contact(const PartialSlipTask& task, int elements);

/// The load of a frictionless contact of about this length.
double load_guess(double length);

}  // namespace nipref::fast
