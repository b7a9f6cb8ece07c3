#pragma once
#include <vector>

#include <nipref/fast/partial_slip/internal/zones.hpp>

namespace nipref::fast {

/// A contact by equal elements with constant tractions, for line loads, held to the rollers at their middles: in steady rolling
/// an element slips by how far its surface moves against the roller from the middle of the element before it to its own.
/// The elements that press, stick or slip are found by an active set.
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
};

/// How far elements reach, over half the length of a contact without friction.
inline constexpr double element_reach = 1.3;

/// `elements` of them over so many lengths of a contact of the task's load, which is given. In rare cases they do not settle; the
/// last state is the result.
ElementContact element_contact(const PartialSlipTask& task, int elements);

}  // namespace nipref::fast
