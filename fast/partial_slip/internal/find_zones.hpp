#pragma once
#include <cmath>
#include <optional>

#include <nipref/fast/partial_slip/internal/zone_contact.hpp>

namespace nipref::fast {

/// The contact that sticks and slips where it should: the zones of few elements (plain_zones.hpp) to begin with, Newton's method
/// for their boundaries, then a zone more wherever shear in a zone that sticks is larger than friction allows, or slip goes
/// along the shear, until there is no such place. Nothing if none is found. nats: as for a ZoneMesh; a zone of slip at an end that is
/// shorter than e^-nats of its neighbour is left out.
std::optional<ZoneContact> find_zones(const PartialSlipTask& task, double nats);
/// The same from a contact that is nearly right.
std::optional<ZoneContact> find_zones(const PartialSlipTask& task, const ZoneContact& near, double nats);

/// How far each sample of a contact is from what it should be, where it sticks with what follows up to the next: the shear
/// beyond friction where it sticks, over friction, and slip along the shear over the largest slip; 0 in the contact itself.
std::vector<double> excesses(const ZoneContact& contact, double friction);
/// What a contact made for an accuracy of e^-nats may leave of them where its zones are right.
inline double left_by_accuracy(double nats) { return std::exp(-nats / 2); }
/// Their mean over the contact.
double wrongness(const ZoneContact& contact, double friction);

}  // namespace nipref::fast
