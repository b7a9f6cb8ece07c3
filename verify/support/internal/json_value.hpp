#pragma once
#include <nlohmann/json.hpp>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

struct Json::Value {
  nlohmann::ordered_json tree;
};

}  // namespace nipref::verify
