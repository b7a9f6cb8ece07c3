#pragma once
#include <functional>

namespace nipref::verify {

/// A callback that receives the finished part of some work, from 0 to 1. It may be empty.
using OnProgress = std::function<void(double part)>;

}  // namespace nipref::verify
