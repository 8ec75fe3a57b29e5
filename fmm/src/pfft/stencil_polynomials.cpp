#include "pfft/stencil_polynomials.hpp"

namespace floe::fmm::pfft {

template <class Real>
StencilPolynomials<Real>::StencilPolynomials(int stencil) : stencil_(stencil) {
  // Multiply out Π_b (t - t_b)/(t_a - t_b), b ≠ a
  const double centre = 0.5 * (stencil - 1);
  for (int a = 0; a < stencil; ++a) {
    double product[kWeights + 1] = {1.0};
    int degree = 0;
    for (int b = 0; b < stencil; ++b) {
      if (b == a) continue;
      ++degree;
      for (int power = degree; power >= 0; --power)
        product[power] =
            ((power > 0 ? product[power - 1] : 0.0) - (b - centre) * product[power]) / (a - b);
    }
    for (int power = 0; power < stencil; ++power)
      coefficient_[power][a] = static_cast<Real>(product[power]);
  }
}

template class StencilPolynomials<float>;
template class StencilPolynomials<double>;

}  // namespace floe::fmm::pfft
