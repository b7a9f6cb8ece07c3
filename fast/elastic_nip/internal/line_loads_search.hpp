#pragma once
#include <functional>
#include <optional>

#include <nipref/fast/elastic_nip/line_loads.hpp>

namespace nipref::fast {

/// Contact length at which load_of_length(L) = `load`, for a load that rises with the length: bracketed and
/// interpolated, or by the thesis's iteration. Starts at `trial_length`. BadInput if load or search is out of
/// its domain, or if no such length is found.
double contact_length_for_load(const std::function<double(double)>& load_of_length, double load,
                               double trial_length, const LoadSearch& search);

/// The same near `trial_length`, for a load that is not known to rise, nor to exist everywhere: by secants of
/// ln W over ln L, of which the thesis's iteration is the first. Nothing if it leads where there is no load.
std::optional<double> contact_length_near(const std::function<std::optional<double>(double)>& load_of_length,
                                          double load, double trial_length, const LoadSearch& search);

}  // namespace nipref::fast
