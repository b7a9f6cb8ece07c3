#pragma once

namespace nipref::data {

/// Friction between roller and sheet: none (complete slip, the thesis's Case B) or full (no slip anywhere, its
/// Case A). (thesis chapter II, conditions (iii) and (iv))
enum class Friction { none, full };

}  // namespace nipref::data
