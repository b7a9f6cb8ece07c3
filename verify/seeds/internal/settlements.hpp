#pragma once
#include <functional>
#include <map>
#include <string_view>

#include <nipref/verify/seeds/errata.hpp>

namespace nipref::verify {

/// By the erratum's id.
using Settlements = std::map<std::string_view, std::function<Settlement()>>;

Settlements thesis_settlements();
Settlements half_space_settlements();    ///< whose quantities have a row in the catalogue
Settlements inversion_settlements();     ///< of brock2012 and brock2013: integrals over the contact
Settlements rolling_line_settlements();  ///< of brock2012: the equations of a rolling sphere on one line
Settlements transform_settlements();     ///< of brock2013: the transformed solid

}  // namespace nipref::verify
