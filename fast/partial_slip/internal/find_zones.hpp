#pragma once
#include <cmath>
#include <optional>

#include <nipref/fast/partial_slip/internal/zone_contact.hpp>

namespace nipref::fast {

/// The contact that meets the conditions of stick and slip, or nothing if none is found. The search starts from the
/// guesses of plain_zones.hpp and finds the boundaries of these zones by Newton's method. It adds a zone wherever
/// shear in a zone of stick is larger than friction or slip has the direction of the shear, until there is no such
/// place. `nats`: as for ZoneMesh, at least rough_nats; a zone of slip at an end that is shorter than e^-nats of its
/// neighbour is left out.
std::optional<ZoneContact> find_zones(const PartialSlipTask& task, double nats);
/// This search from a contact that is nearly right.
std::optional<ZoneContact> find_zones(const PartialSlipTask& task, const ZoneContact& near, double nats);

/// The least accuracy with which zones are sought. With fewer nats, zones next to much shorter ones are not found, and
/// with little friction the errors of pressures, which are like e^(-0.9 nats), are larger than shears.
double rough_nats(double friction);

/// How much each sample of a contact violates its condition, 0 if not at all. In zones of stick: the shear beyond
/// friction over friction, up to the next sample. In zones of slip: slip along the shear over the largest slip.
std::vector<double> excesses(const ZoneContact& contact, double friction);
/// The excess that a contact of accuracy e^-nats may have although its zones are right: at the midpoints next to an end
/// tractions are like t^(1/2) = e^(-nats/2), with errors like e^-nats.
inline double left_by_accuracy(double nats) { return std::exp(-nats / 2); }
/// The mean of the excesses over the contact.
double mean_excess(const ZoneContact& contact, double friction);

}  // namespace nipref::fast
