// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ESTIMATE_SURFACE_VARIATION_H
#define CGAL_ESTIMATE_SURFACE_VARIATION_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/read_cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/read_parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgCurvatureAwareSimplification3Algorithms

\brief estimates the surface variation \cgalCite{cgal:pgk-esops-02} at each point of a point set.

The surface variation of a point is \f$\kappa = \lambda_0 / (\lambda_0 + \lambda_1 + \lambda_2)\f$,
where \f$\lambda_0 \le \lambda_1 \le \lambda_2\f$ are the eigenvalues of the covariance matrix of the
point and its `k` nearest neighbors. It has no unit, and ranges from 0, where they lie in a plane, to
1/3, where they are spread evenly in all directions. For a smooth surface that is sampled densely it
grows with the square of the curvature: with neighborhoods of radius \f$r\f$, it is near
\f$r^2 / (24 R^2)\f$ on a sphere and \f$r^2 / (32 R^2)\f$ on a cylinder of radius \f$R\f$. It is part
of the method of \cgalCite{cgal:curvature-aware-simplification} (section 4.1, step 1).

Points that are exact duplicates of each other are counted once in every neighborhood, and get the
same value. Values below the rounding error of the coordinates are set to 0: that of floats, if all
of them may have been floats.

The complexity is \f$O(M (\log M + k))\f$ for \f$M\f$ points.

\tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
        `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. The result is the same.
        `Parallel_tag` requires the program to be linked with \ref thirdpartyTBB, and does not compile
        otherwise. The number of threads is that of TBB, see `tbb::global_control`.
\tparam PointRange is a model of `ConstRange` that has the nested type `iterator` as well, as containers and
        `CGAL::Iterator_range` do. The value type of its iterator is the key type of the named parameter
        `point_map`.
\tparam SurfaceVariationMap is a model of `WritablePropertyMap` whose key type is the value type of
        the iterator of `PointRange` and to whose value type `double` converts.

\param points input point range, an lvalue, of which nothing but the surface variation map is written
\param k number of neighbors of a neighborhood, the point itself not counted, from 2 to 4294967295. If there
       are fewer distinct points, all of them are used.
\param surface_variation_map a property map that receives the surface variation of each point; it is
       written after the last value is known, on the calling thread, in the order of the range
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

  \cgalParamNBegin{callback}
    \cgalParamDescription{a mechanism to get feedback on the advancement of the algorithm while it's
                          running and to interrupt it if needed}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{unused}
    \cgalParamExtra{It is called on the calling thread with the current advancement, from 0 to 1,
                    which never decreases. If it returns `false`, nothing is written. It may throw: the
                    exception is passed on, and nothing is written either.}
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

\return `true`, or `false` if the callback stopped the computation

\throws std::invalid_argument if `points` is empty, a coordinate is not finite (the message tells the
        index of the first such point), points are so far from many others that these would be as one, as if
        the largest number stood for a missing measurement (the manual tells how far is too far), or `k` is below 2 or above 4294967295; nothing is written then
*/
template <typename ConcurrencyTag, typename PointRange, typename SurfaceVariationMap,
          typename NamedParameters = parameters::Default_named_parameters>
bool estimate_surface_variation(PointRange& points, std::size_t k,
                                SurfaceVariationMap surface_variation_map,
                                const NamedParameters& np = parameters::default_values())
{
  namespace internal = Curvature_aware_simplification_3::internal;
  using boost::put; // of pointers, which are property maps as well
  using Types = internal::Input_types<std::remove_const_t<PointRange>, NamedParameters>;

  if (internal::number_of_elements(points) == 0)
    internal::throw_empty_range();
  internal::checked_count("k", k, 2, internal::largest_count, internal::count_from(2));
  const std::function<bool(double)> callback = internal::read_callback(np);

  try
  {
    const internal::Progress progress(callback);
    progress.report(0.);
    const internal::Cloud cloud =
        internal::read_cloud<ConcurrencyTag>(points, np, progress.part(0., 0.1));
    const internal::Features features =
        internal::compute_features<ConcurrencyTag, typename Types::Diagonalize_traits>(
            cloud, k, progress.part(0.1, 1.));
    const std::vector<std::size_t> distinct_index =
        internal::distinct_indices<ConcurrencyTag>(cloud);
    std::size_t i = 0;
    for (auto&& element : points)
      put(surface_variation_map, element, features.surface_variation[distinct_index[i++]]);
    return true;
  }
  catch (const internal::Cancelled&)
  {
    return false;
  }
}

} // namespace CGAL

#endif // CGAL_ESTIMATE_SURFACE_VARIATION_H
