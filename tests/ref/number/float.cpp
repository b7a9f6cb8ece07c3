#include <thread>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

/// Hilbert's matrix 1/(i + k + 1). The entries of its inverse are integers.
Matrix hilbert(Matrix::Index size) {
  Matrix result(size, size);
  for (Matrix::Index i = 0; i < size; ++i) {
    for (Matrix::Index k = 0; k < size; ++k) result(i, k) = Float(1) / (i + k + 1);
  }
  return result;
}

double largest(const Matrix& x) {
  double result = 0;
  for (Matrix::Index k = 0; k < x.size(); ++k)
    result = std::fmax(result, std::fabs(static_cast<double>(x(k))));
  return result;
}

}  // namespace

TEST_CASE("a Float has the working digits, or those of its operands where they are more") {
  const WorkingDigits many(60);
  const Float third = Float(1) / 3;
  CHECK(bits_of(third) >= 200);
  CHECK(abs(3 * third - 1) <= std::numeric_limits<Float>::epsilon());
  {
    const WorkingDigits few(20);
    CHECK(bits_of(Float(1) / 3) < 80);
    CHECK(working_bits() < 80);
    CHECK(bits_of(third + 1) == bits_of(third));
    // Boost computes in place in a temporary, with the temporary's number of bits.
    const Float three = 3;
    CHECK(bits_of(three * third - 1) == bits_of(third));
    CHECK(bits_of(Float(3) * third) == working_bits());
    CHECK(bits_of(exp(third)) == bits_of(third));
    CHECK(bits_of(hypot(Float(1), third)) == bits_of(third));
    Float sum = 1;
    sum += third;
    CHECK(sum == 1 + third);
    CHECK(bits_of(at_working_precision(third)) < 80);
    CHECK(at_working_precision(third) != third);
  }
  CHECK(bits_of(Float(1) / 3) == bits_of(third));
  CHECK(to_exact(third).value() != mpq_class(1, 3));
  CHECK(to_float(to_exact(third)) == third);
}

TEST_CASE("copies and moves of Floats keep their bits, whatever the working precision") {
  const auto third_of_bits = [](mpfr_prec_t bits) {
    Float third = zero_of_bits(bits);
    mpfr_div_ui(raw(third), raw(zero_of_bits(bits) + 1), 3, MPFR_RNDN);
    return third;
  };
  for (const int digits : {1, 20, 300}) {
    CAPTURE(digits);
    const WorkingDigits working(digits);
    for (const mpfr_prec_t bits : {2, 53, 64, 65, 66, 67, 200, 1001}) {
      CAPTURE(bits);
      Float third = third_of_bits(bits);
      CHECK(bits_of(third) == bits);
      Float copy(third), assigned, moved = third_of_bits(bits), move_assigned;
      assigned = third;
      move_assigned = std::move(moved);
      std::vector<Float> many(3, third);
      many.resize(100);
      std::swap(many[0], many[99]);
      for (const Float& x : {copy, assigned, move_assigned, many[99], many[1]}) {
        CHECK(bits_of(x) == bits);
        CHECK(x == third);
      }
      moved = 1;
      CHECK(moved + 1 == 2);
    }
  }
}

TEST_CASE("results have all bits of operands that working digits made, at most two less of others") {
  const WorkingDigits least(1);
  for (mpfr_prec_t bits = 20; bits <= 2000; ++bits) CHECK(bits_of(zero_of_bits(bits) + 1) >= bits - 2);
  for (int digits = 16; digits <= 1100; ++digits) {
    Float x;
    {
      const WorkingDigits working(digits);
      x = Float(1) / 3;
    }
    CHECK(bits_of(x) > digits * 3.3219);
    CHECK(bits_of(x + 1) == bits_of(x));
    CHECK(bits_of(sqrt(x) * x) == bits_of(x));
  }
}

TEST_CASE("each thread has its working digits, and its results are those of one thread") {
  const auto third_root = [](int digits) {
    const WorkingDigits working(digits);
    return pow(Float(2), Float(1) / 3);
  };
  std::vector<Float> found(40);
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < found.size(); ++k)
      threads.emplace_back([&, k] { found[k] = third_root(20 + 10 * static_cast<int>(k)); });
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Float here = third_root(20 + 10 * static_cast<int>(k));
    CHECK(bits_of(found[k]) == bits_of(here));
    CHECK(found[k] == here);
  }
}

TEST_CASE("linear systems are solved to the working digits") {
  const WorkingDigits working(60);
  for (const Matrix::Index size : {1, 6, 20}) {
    CAPTURE(size);
    const Matrix matrix = hilbert(size);
    const double loss =
        std::pow(10, 1.55 * static_cast<double>(size));  // Hilbert's matrices are ill-conditioned
    CHECK(largest(matrix * matrix.inverse() - Matrix::Identity(size, size)) <= 1e-60 * loss);
    Vector known(size);
    for (Matrix::Index k = 0; k < size; ++k) known(k) = 1 + k;
    CHECK(largest(solve(matrix, matrix * known) - known) <= 1e-59 * loss);
  }
  CHECK(std::fabs(static_cast<double>(hilbert(5).inverse()(4, 4) - 44100)) < 1e-45);
}
