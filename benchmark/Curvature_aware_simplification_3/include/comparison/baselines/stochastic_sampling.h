#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_STOCHASTIC_SAMPLING_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_STOCHASTIC_SAMPLING_H

#include <comparison/types.h>

#include <CGAL/curvature_aware_random_simplify_point_set.h>

#include <cstddef>
#include <cstdint>
#include <iterator>

namespace comparison {

// Geometry-aware stochastic sampling (Boubekeur and Alexa 2009): each of the M points is drawn with
// the probability
//
//   (n / M) (1 + alpha (kappa_i / mean(kappa) - 1)),
//
// then points are removed or inserted at random until there are n. This is the package's selection
// without its term of the density. kappa is the surface variation of 17 points.
inline Points stochastic_sampling(const Points& points, std::size_t n, double alpha = 2. / 3.,
                                  std::uint64_t seed = 0)
{
  Points result;
  CGAL::curvature_aware_random_simplify_point_set<Tag>(points, std::back_inserter(result),
                                                       CGAL::parameters::number_of_output_points(n)
                                                           .curvature_weight(1.)
                                                           .adaptivity(alpha)
                                                           .random_seed(seed));
  return result;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_STOCHASTIC_SAMPLING_H
