#pragma once
#include <functional>
#include <map>

#include <nipref/verify/solve/internal/solved_contact.hpp>

/// A contact with given numbers, which may depend on Y.
template <class Number>
struct StatedContact : nipref::verify::SolvedContact<Number> {
  std::map<nipref::data::ResultId, std::function<Number(double y)>> numbers;
  nipref::verify::ContactEnds stated_ends{0, 0};

  [[nodiscard]] nipref::verify::ContactEnds ends() const override { return stated_ends; }

 private:
  void answer(nipref::verify::Asked<Number>& asked) const override {
    for (const auto& [id, at] : numbers) {
      if (asked.places.empty()) asked.set(id, [&] { return at(0); });
      if (!asked.places.empty()) asked.set(id, at);
    }
  }
};
