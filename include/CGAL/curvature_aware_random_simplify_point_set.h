// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_RANDOM_SIMPLIFY_POINT_SET_H
#define CGAL_CURVATURE_AWARE_RANDOM_SIMPLIFY_POINT_SET_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/read_cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/select_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/read_parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCurvatureAwareSimplification3Algorithms

\brief selects a random subset of a point set that is denser where the surface bends, and evens out
the density of the input in part.

This is the stochastic selection of \cgalCite{cgal:curvature-aware-simplification} (section 4.1), the
first stage of `CGAL::curvature_aware_simplify_point_set()` with `settings_of_the_paper(true)`, by itself. It
returns elements of the input, hence keeps every attribute that they carry: normals, colors, intensities,
labels. Nothing is moved, so noise and outliers stay what they are.

Each of the \f$M\f$ points is drawn with the probability
\f[ F_i = \frac{N}{M} \left( w_\rho \left(1 + \alpha \left(\frac{1 / \rho_i}{\mathrm{mean}(1 / \rho)}
- 1\right)\right) + w_\kappa \left(1 + \alpha \left(\frac{\kappa_i}{\mathrm{mean}(\kappa)} - 1
\right)\right) \right), \f]
where \f$N\f$ is the number of points asked for, \f$\kappa_i\f$ the surface variation (see
`CGAL::estimate_surface_variation()`), and \f$\rho_i = k / r_i^2\f$ the density, with \f$r_i\f$ the
distance to the \f$k\f$-th nearest neighbor. Points are then removed or inserted at random, all with
the same probability, so that the count is exact. Exact duplicates count as one point, and are
selected only when there are fewer distinct points than asked for.

The complexity is \f$O(M (\log M + k))\f$.

\tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
        `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. The result is the same.
        `Parallel_tag` requires the program to be linked with \ref thirdpartyTBB, and does not compile
        otherwise. The number of threads is that of TBB, see `tbb::global_control`.
\tparam PointRange is a model of `ConstRange` that has the nested type `iterator` as well, as containers and
        `CGAL::Iterator_range` do. The value type of its iterator is the key type of the named parameter
        `point_map`.
\tparam OutputIterator is a model of `OutputIterator` that accepts objects of the value type of the
        iterator of `PointRange`.

\param points input point range, neither changed nor reordered
\param output iterator where copies of the selected elements are put, in the order of the input. It may be
       `points.begin()`, so that the container can be cut off behind the last of them with `erase()`, but must not
       insert elements into `points`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the point set
                          `points`}
    \cgalParamType{a model of `ReadablePropertyMap` whose key type is the value type of the iterator
                   of `PointRange` and whose value type is `geom_traits::Point_3`}
    \cgalParamDefault{`CGAL::Identity_property_map<geom_traits::Point_3>`}
  \cgalParamNEnd

  \cgalParamNBegin{select_percentage}
    \cgalParamDescription{percentage of points to select}
    \cgalParamType{floating scalar value, above 0 and at most 100}
    \cgalParamDefault{`5`}
    \cgalParamExtra{The number of points is rounded down, but is at least 1.}
  \cgalParamNEnd

  \cgalParamNBegin{number_of_output_points}
    \cgalParamDescription{number of points to select; if it is given, `select_percentage` is ignored}
    \cgalParamType{an integer from 1 to the number of input points}
    \cgalParamDefault{unused}
  \cgalParamNEnd

  \cgalParamNBegin{curvature_weight}
    \cgalParamDescription{the weight \f$w_\kappa\f$ of the surface variation in the selection; that
                          of the inverse density is \f$w_\rho = 1 - w_\kappa\f$}
    \cgalParamType{floating scalar value from 0 to 1}
    \cgalParamDefault{`0.75`}
    \cgalParamExtra{With 0, the selection knows no curvature. With `adaptivity(1)` as well, it makes up for
                    an uneven density of the input: where points are twice as dense, each is half as likely.}
  \cgalParamNEnd

  \cgalParamNBegin{adaptivity}
    \cgalParamDescription{how strongly the selection depends on curvature and density: \f$\alpha\f$}
    \cgalParamType{floating scalar value from 0 to 1}
    \cgalParamDefault{`2. / 3.`}
    \cgalParamExtra{With 0, all points are equally likely.}
  \cgalParamNEnd

  \cgalParamNBegin{number_of_neighbors}
    \cgalParamDescription{the number \f$k\f$ of neighbors from which surface variation and density
                          are computed, the point itself not counted}
    \cgalParamType{an integer from 2 to 4294967295}
    \cgalParamDefault{`16`}
    \cgalParamExtra{More neighbors make the estimates robust against noise, and blind to details
                    smaller than the neighborhood.}
  \cgalParamNEnd

  \cgalParamNBegin{random_seed}
    \cgalParamDescription{seed of the random numbers, which are a function of it and of the position
                          of a point in the range: same input and seed, same result}
    \cgalParamType{an integer}
    \cgalParamDefault{`0`}
  \cgalParamNEnd

  \cgalParamNBegin{callback}
    \cgalParamDescription{a mechanism to get feedback on the advancement of the algorithm while it's
                          running and to interrupt it if needed}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{unused}
    \cgalParamExtra{It is called on the calling thread with the current advancement, from 0 to 1,
                    which never decreases. If it returns `false`, nothing is written to `output`, which is
                    returned as it was: only the callback knows. It may throw: the exception is passed on,
                    and nothing is written either.}
  \cgalParamNEnd

  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
  \cgalParamNEnd

  \cgalParamNBegin{diagonalize_traits}
    \cgalParamDescription{the solver that diagonalizes the covariance matrices of which the surface variation is
                          computed}
    \cgalParamType{a class model of `DiagonalizeTraits` with number type `double` and dimension 3; with
                   `Parallel_tag`, several threads call it at the same time}
    \cgalParamDefault{`CGAL::Default_diagonalize_traits<double, 3>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the iterator behind the last element written

\throws std::invalid_argument if `points` is empty, a coordinate is not finite (the message tells the
        index of the first such point), points are so far from many others that these would be as one, as if
        the largest number stood for a missing measurement (the message tells the index of one, the manual
        how far is too far), or a parameter is out of its range (the message tells its name, its value and
        what is allowed); nothing is written then

\sa `CGAL::curvature_aware_simplify_point_set()`
\sa `CGAL::random_simplify_point_set()`
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
curvature_aware_random_simplify_point_set(const PointRange& points, OutputIterator output,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Curvature_aware_simplification_3::internal;
  using Types = internal::Input_types<PointRange, NamedParameters>;

  const internal::Selection_parameters parameters =
      internal::read_selection_parameters(np, internal::number_of_elements(points));

  std::vector<std::size_t> selected;
  try
  {
    const internal::Progress progress(parameters.callback);
    progress.report(0.);
    const internal::Cloud cloud =
        internal::read_cloud<ConcurrencyTag>(points, np, progress.part(0., 0.1));
    const internal::Features features =
        internal::compute_features<ConcurrencyTag, typename Types::Diagonalize_traits>(
            cloud, parameters.number_of_neighbors, progress.part(0.1, 0.9));
    selected = internal::select_points<ConcurrencyTag>(cloud, features, parameters);
    progress.report(1.);
  }
  catch (const internal::Cancelled&)
  {
    return output;
  }

  std::size_t i = 0;
  auto next = selected.begin();
  for (const auto& element : points)
  {
    if (next == selected.end())
      break;
    if (*next == i)
    {
      *output++ = element;
      ++next;
    }
    ++i;
  }
  return output;
}

} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_RANDOM_SIMPLIFY_POINT_SET_H
