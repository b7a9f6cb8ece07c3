#pragma once
#include "support/test.hpp"

/// What refuses the call; "accepted" if nothing does.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const nipref::data::BadInput& error) {
    return error.what();
  }
  return "accepted";
}
