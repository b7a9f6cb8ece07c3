#include "data/scene_results.hpp"

#include <algorithm>
#include <array>

namespace nipref::data {
namespace {

constexpr std::array results{
    SceneResult{"contact_length", "length", "length L of the contact", false},
    SceneResult{"load", "force/length", "load W per unit width", false},
    SceneResult{"indentation", "length", "approach d0 of roller and middle plane", false},
    SceneResult{"edge_displacement", "length",
                "normal displacement d1 = d0 - L^2/(8R) at the ends of the contact", false},
    SceneResult{"creep_ratio", "1",
                "strain v' of the surface in the contact; without friction its mean, (2/L) v(L/2)", false},
    SceneResult{"peak_pressure", "stress", "largest pressure", false},
    SceneResult{"peak_shear", "stress", "largest magnitude of the shear", false},
    SceneResult{"pressure", "stress", "pressure", true},
    SceneResult{"shear", "stress", "shear on the sheet along Y", true},
    SceneResult{"normal_displacement", "length", "displacement u towards the middle plane", true},
    SceneResult{"tangential_displacement", "length",
                "displacement v along Y, relative to the middle of the nip", true},
};

}  // namespace

std::span<const SceneResult> scene_results() { return results; }

const SceneResult* find_scene_result(std::string_view name) {
  const auto found = std::ranges::find(results, name, &SceneResult::name);
  return found == results.end() ? nullptr : &*found;
}

}  // namespace nipref::data
