#pragma once
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>

#include "support/test.hpp"

/// Kinds of converged contacts that both paths solve.
namespace nipref::test {

using Places = std::vector<double>;
template <class Number>
using Numbers = std::map<std::string, Number>;

/// The results of a contact of either path by their names, also at places Y.
template <class Contact>
auto numbers_of(const Contact& contact, const Places& places) {
  Numbers<decltype(contact.load())> all{{"contact_length", contact.contact_length()},
                                        {"leading_length", contact.leading_length()},
                                        {"trailing_length", contact.trailing_length()},
                                        {"load", contact.load()},
                                        {"indentation", contact.indentation()},
                                        {"leading_displacement", contact.leading_displacement()},
                                        {"trailing_displacement", contact.trailing_displacement()},
                                        {"rolling_resistance", contact.rolling_resistance()},
                                        {"creep_ratio", contact.creep_ratio()},
                                        {"peak_pressure", contact.peak_pressure()},
                                        {"peak_shear", contact.peak_shear()}};
  for (const double y : places) {
    const std::string at = " at " + std::to_string(y);
    all.insert({{"pressure" + at, contact.pressure(y)},
                {"shear" + at, contact.shear(y)},
                {"normal_displacement" + at, contact.normal_displacement(y)},
                {"tangential_displacement" + at, contact.tangential_displacement(y)}});
  }
  return all;
}

/// A kind of nip, solved for a length or for a load.
struct Kind {
  std::string name;
  std::function<ref::ConvergedNip(double given, int digits)> of_length, of_load;
  std::function<fast::ConvergedNip(double given, double accuracy)> fast_of_length, fast_of_load;
};

template <class Nip, class... Options>
Kind kind_of(const std::string& name, const Nip& nip, Options... options) {
  return {name, [=](double x, int digits) { return ref::converged_for_length(nip, options..., x, digits); },
          [=](double x, int digits) { return ref::converged_for_load(nip, options..., x, digits); },
          [=](double x, double accuracy) { return fast::converged_for_length(nip, options..., x, accuracy); },
          [=](double x, double accuracy) { return fast::converged_for_load(nip, options..., x, accuracy); }};
}
inline Kind frictionless(const data::ElasticNip& nip) {
  return kind_of("frictionless", nip, data::Friction::none);
}
inline Kind gripped(const data::ElasticNip& nip) { return kind_of("gripped", nip, data::Friction::full); }
inline Kind rolling(const data::ViscoelasticNip& nip) { return kind_of("rolling", nip); }

}  // namespace nipref::test
