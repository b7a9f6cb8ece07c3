#pragma once
#include <functional>

namespace nipref::verify {

/// A callback that is told which part of some work is finished, from 0 to 1. It may be empty.
using OnProgress = std::function<void(double part)>;

}  // namespace nipref::verify
