#pragma once
#include <complex>
#include <vector>

#include <nipref/data/material/viscoelastic.hpp>

namespace nipref::fast {

/// The tangential or normal displacement of the viscoelastic sheet's surface as the thesis computes it: the first
/// `terms` residues of (6.23)-(6.28) as printed. The truncation error of one of their sums, that after the contact,
/// decreases only like 0.2/terms. The class serves to reproduce the thesis's tables and to compare speed and accuracy.
///
/// Lengths are in half-thicknesses b and times in b/speed, so that a time is the distance that the load moves in it. A
/// point that the load reaches at T is at the distance alpha = T - t from the load. Each sum depends on one distance,
/// so that many displacements share it.
class PlainMovingLoad {
 public:
  /// terms: 1 to most_residue_terms (plain_series.hpp); speed, half_thickness > 0; real rates only: otherwise BadInput.
  /// The normal displacement's sum after the contact ends with its first term below `smallest_term` times the
  /// instantaneous theta1 + theta2; if smallest_term is 0, it has all terms.
  PlainMovingLoad(const data::ViscoelasticMaterial& material, double speed, double half_thickness, int terms,
                  double smallest_term = 0);

  /// The residue sums at one distance x >= 0.
  struct Sums {
    double kernel;               ///< sum Re c_n e^(i z_n x): the elastic kernel without its constant
    std::vector<double> ahead;   ///< for each rate: sum Re c_n e^(i z_n x)/(rate - i z_n)
    std::vector<double> behind;  ///< for each rate: sum Re c_n e^(i z_n x)/(rate + i z_n)
  };
  [[nodiscard]] Sums normal_sums(double distance) const { return sums(normal_, distance); }

  /// The normal displacement due to a unit normal load that started at t = 0, 1/stress. `at_alpha` and `at_T` are
  /// normal_sums(|T - t|) and normal_sums(|T|). (thesis 6.23, 6.25)
  [[nodiscard]] double normal_displacement(double t, double T, const Sums& at_alpha, const Sums& at_T) const;
  [[nodiscard]] double normal_displacement(double t, double T) const;
  /// The tangential displacement due to this load, relative to the pinned point, which the load reaches at t0.
  /// (thesis 6.24, 6.26-6.28)
  [[nodiscard]] double tangential_displacement(double t, double T, double t0) const;

 private:
  /// A kernel: parity, its constant at infinity and its residue coefficients.
  struct Kernel {
    double parity;
    double constant;
    std::vector<std::complex<double>> residues;
  };
  /// A material function with times in units of b/speed.
  struct Memory {
    double instantaneous;
    std::vector<double> amplitude;  ///< for each of rates_
  };
  [[nodiscard]] Sums sums(const Kernel& kernel, double distance) const;
  [[nodiscard]] double after(const Kernel& kernel, const Memory& memory, double distance) const;
  [[nodiscard]] double remembered(const Kernel& kernel, const Memory& memory, double t, double T,
                                  const Sums& at_alpha, const Sums& at_T) const;
  [[nodiscard]] double remembered(const Kernel& kernel, const Memory& memory, double t, double T) const;
  [[nodiscard]] Memory memory(const data::MaterialFunction& function, double speed,
                              double half_thickness) const;

  std::vector<double> rates_;  ///< the rates of both material functions
  std::vector<std::complex<double>> roots_;
  double smallest_term_;
  /// 1/(rate - i z_n) and 1/(rate + i z_n), for each rate.
  std::vector<std::vector<std::complex<double>>> ahead_, behind_;
  Kernel normal_;
  Kernel tangential_, sign_, pinned_theta1_, pinned_theta2_;  ///< I3, I2, I5, I4
  Memory theta1_, theta2_, both_;
};

}  // namespace nipref::fast
