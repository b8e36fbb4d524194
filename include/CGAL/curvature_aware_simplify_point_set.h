// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFY_POINT_SET_H
#define CGAL_CURVATURE_AWARE_SIMPLIFY_POINT_SET_H

#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/simplify_point_set.h>
#include <CGAL/Curvature_aware_simplification_report.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

/*!
\ingroup PkgCurvatureAwareSimplification3Algorithms

\brief simplifies a point set to a given number of points, dense where the surface bends and sparse
where it is flat, that lie on the surface and are spread evenly.

The input may be a raw scan: its outliers, its noise and its density are measured, and there is nothing
to tune. This is the curvature-aware simplification of \cgalCite{cgal:curvature-aware-simplification},
a locally optimal projection started from a curvature-aware random selection, made to adapt to its
input:

-# Where depth was rounded to steps, as by one or several depth cameras, points are moved back to between them.
-# Copies of a place, as of a scanner at rest and in files that differ by rounding, are replaced by their
   mean, unless fewer than \f$N\f$ points, or than 57, would be left.
-# Outliers are found: points that few others have among their \f$k\f$ nearest neighbors, points that are
   far from others and in no layer, and small clusters apart from all else that are as thick as wide. They are
   left out of what follows, unless fewer than \f$N\f$ points, or than half of them, would be left: then
   none are taken for outliers.
-# The standard deviation \f$\sigma\f$ of the noise is estimated, by place, from what local quadrics
   and planes leave. Where it is visible at the distance of the output points, the input points are first
   smoothed, each by a fit to its nearest; of those that are very dense against it, some are left out.
-# The density of the output follows the curvature \f$c\f$ at the distance of the output points, as
   \f$c^{\alpha}\f$, where \f$\sigma\f$ does not explain it, and not the density of the input.
-# Samples are selected at random with this density, evenly along a space-filling curve.
-# Samples are relaxed. Each moves on a local surface, a quadric fitted robustly to its nearest input
   points, instead of towards a mean of them (the first term of eq. 8), and away from a weighted mean of
   the other samples (the second term of eq. 8) in the tangent plane. Samples are not pushed across
   borders.
-# Where there is noise, samples move towards fits to more neighbors, as far as noise explains the
   difference, and then push each other apart once more.
-# If no more than three points and one in 1000 were found to be outliers, copies counted once,
   samples whose fits miss the nearest points, as on thin parts, by more than noise explains move to
   these. Samples next to a sharp edge are moved onto it, and those next to a corner of the border of an
   open surface into the corner. Where no noise is visible, samples that ended far from all points of the
   input go to the nearest one. Of samples that came to the same place, all but one go to where none is.
-# If no noise is visible and no more than those few outliers were found, a share of up to
   \f$0.045 \alpha\f$ of the \f$N\f$ samples was kept back, and is put last where a mesh of the others
   misses most of the input: at tips and on narrow ridges.

Fewer than 57 distinct points, outliers not counted, are too few to fit a surface to. Some of these are
selected evenly along the space-filling curve and none is moved any more; of the parameters, only the
number of points and the seed matter, and where there are outliers, `number_of_neighbors`.

What was found is told by `simplification_report`. The manual has the details.

The input is neither changed nor reordered. The result is the same, bit by bit, for the same input and
seed, whatever the concurrency tag and the number of threads; another compiler, other options or another
version of a library may round differently. It depends neither on the unit and the origin of the
coordinates nor on the order of the points, with two exceptions: where rounding decides, between equal
distances, as on regular grids and where coordinates were rounded, or about whether a point is an outlier,
other samples of the same quality may be selected; and if more points are asked for than are distinct, the order
decides which duplicates are returned.

With \f$M\f$ input and \f$N\f$ output points, the time is \f$O(M (\log M + k) + i N \log M)\f$ for
\f$i\f$ iterations, and the memory \f$O(M)\f$.

<b>The settings of the paper</b> are available with `settings_of_the_paper(true)`. Instead of these steps,

-# the surface variation \f$\kappa\f$ and the density \f$\rho\f$ of every input point are computed from
   its nearest neighbors, see `CGAL::estimate_surface_variation()`;
-# points are selected at random with a probability that grows with \f$\kappa\f$ and with
   \f$1/\rho\f$ (section 4.1), see `CGAL::curvature_aware_random_simplify_point_set()`;
-# in each iteration, every sample \f$x\f$ moves to
   \f[ x' = \frac{\sum_j \alpha_j \phi_1(\kappa_j) \, p_j}{\sum_j \alpha_j \phi_1(\kappa_j)}
   + \mu \frac{\sum_i \beta_i \phi_2(\kappa, \kappa_i) (x - x_i)}{\sum_i \beta_i
   \phi_2(\kappa, \kappa_i)} \f]
   (eq. 8), attracted by the input points \f$p_j\f$ and repelled by the other samples \f$x_i\f$, with
   \f$\alpha_j = \theta(r) / r\f$ for \f$r = \| x - p_j \|\f$, \f$\beta_i = \theta(r) / r\f$ for
   \f$r = \| x - x_i \|\f$, and \f$\theta(r) = \exp(-16 r^2 / h^2)\f$. The weights
   \f$\phi_1(\kappa) = 0.1 + 1 / (\kappa^{-d} + 0.75)\f$ and \f$\phi_2(\kappa, \kappa') = (a(\kappa)
   + a(\kappa')) / 2\f$ with \f$a(\kappa) = 0.1 + 1 / (\kappa^d + 0.75)\f$ take \f$\kappa\f$ scaled
   to \f$[0, 20]\f$ (eq. 3 to 6).

All defaults are those of the paper then, except for `neighbor_radius`. The paper's \f$h = 4 \sqrt{D /
M}\f$, with \f$D\f$ the length of the diagonal of the input's bounding box, depends on the unit; it
becomes \f$4 D / \sqrt{M}\f$ for an input scaled to \f$D = 1\f$. It does not depend on \f$N\f$ either,
and holds no other sample when few are asked for, so that nothing is spread. The default here follows
the spacing of the output instead. Random numbers are a function of the position of a point in the
input then, so that a permutation of the input gives another selection. With \f$n\f$ points in a ball of
the radius \f$h\f$, the time is \f$O(M (\log M + k) + i N (\log M + n))\f$, with
`require_uniform_sampling` \f$O(M n)\f$ more, and with `recompute_curvature` \f$O(i N k)\f$ more.

\tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
        `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. The result is the same.
        `Parallel_tag` requires the program to be linked with \ref thirdpartyTBB, and does not compile
        otherwise. The number of threads is that of TBB, see `tbb::global_control`.
\tparam PointRange is a model of `ConstRange` that has the nested type `iterator` as well, as containers and
        `CGAL::Iterator_range` do. The value type of its iterator is the key type of the named parameter
        `point_map`.
\tparam OutputIterator is a model of `OutputIterator` that accepts objects of type
        `geom_traits::Point_3`.

\param points input point range, neither changed nor reordered
\param output iterator where the output points are put, exactly as many as asked for. Their order is
       that of a space-filling curve through the selected points; those that are put where a mesh of the others
       misses most come last. All of `points` is read before the first of them is put, so that they may be
       appended to the container of the input.
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
    \cgalParamDescription{percentage of points to return}
    \cgalParamType{floating scalar value, above 0 and at most 100}
    \cgalParamDefault{`5`}
    \cgalParamExtra{The number of points is rounded down, but is at least 1. 100 does not clean a scan: see
                    `number_of_output_points`.}
  \cgalParamNEnd

  \cgalParamNBegin{number_of_output_points}
    \cgalParamDescription{number of points to return; if it is given, `select_percentage` is ignored}
    \cgalParamType{an integer from 1 to the number of input points}
    \cgalParamDefault{unused}
    \cgalParamExtra{If as many as all distinct points are asked for, these are returned as they are, up to
                    the rounding of their coordinates, with their noise and outliers: there is nothing to
                    choose. If more are asked for than would be left without the outliers, none are
                    left out. With the settings of the paper, all are moved.}
  \cgalParamNEnd

  \cgalParamNBegin{adaptivity}
    \cgalParamDescription{how strongly the density of the result depends on the curvature: the exponent
                          \f$\alpha\f$}
    \cgalParamType{floating scalar value from 0 to 1}
    \cgalParamDefault{`2. / 3.`}
    \cgalParamExtra{With 0, the result is uniform. For a piecewise linear surface through the result, 0.5
                    gives the least mean error, 1 the least largest error. With the settings of the
                    paper, it is the weight \f$\alpha\f$ in the probabilities of section 4.1, and with 0
                    all points are equally likely.}
  \cgalParamNEnd

  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{largest number of iterations of the relaxation}
    \cgalParamType{an integer from 0 to 4294967295}
    \cgalParamDefault{`10`}
    \cgalParamExtra{More iterations give a more regular result but increase the running time. The
                    relaxation ends earlier when samples rest: when they move by less than a
                    thousandth of their spacing in the mean. At edges and in noise, some may never
                    rest. With the settings of the paper, it does not.}
  \cgalParamNEnd

  \cgalParamNBegin{repulsion_weight}
    \cgalParamDescription{the factor \f$\mu\f$ of the repulsion}
    \cgalParamType{floating scalar value, at least 0 and below 0.5}
    \cgalParamDefault{`0.45`}
    \cgalParamExtra{The first of several iterations takes 2.5 times this factor, which shrinks evenly until the
                    tenth, or the last if there are fewer; with the settings of the paper, it is always the same.}
  \cgalParamNEnd

  \cgalParamNBegin{number_of_neighbors}
    \cgalParamDescription{the number \f$k\f$ of neighbors, the point itself not counted, by which
                          outliers are found, and the density of the input and its surface variation are
                          computed}
    \cgalParamType{an integer from 2 to 4294967295}
    \cgalParamDefault{`16`}
    \cgalParamExtra{Clusters of up to 32 times as many outliers are found, if they are farther from all else
                    than they are wide. More neighbors make the surface variation robust
                    against noise and blind to details smaller than the neighborhood. With less than about 8,
                    points of clean surfaces look like outliers: of random points on a torus 8 % with 2, 2 %
                    with 3, 0.15 % with 5. Three points are always in a plane: with 2, neither edges nor
                    outliers far from all else are seen.}
  \cgalParamNEnd

  \cgalParamNBegin{settings_of_the_paper}
    \cgalParamDescription{if `true`, the literal method of the paper is used, which knows neither the
                          noise nor the outliers of the input}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{The next five parameters matter only then; they are checked, but have no effect
                    otherwise.}
  \cgalParamNEnd

  \cgalParamNBegin{curvature_weight}
    \cgalParamDescription{with the settings of the paper, the weight \f$w_\kappa\f$ of the surface
                          variation in the selection; that of the inverse density is
                          \f$w_\rho = 1 - w_\kappa\f$}
    \cgalParamType{floating scalar value from 0 to 1}
    \cgalParamDefault{`0.75`}
    \cgalParamExtra{With 0, the selection knows no curvature. With `adaptivity(1)` as well, it makes up for
                    an uneven density of the input.}
  \cgalParamNEnd

  \cgalParamNBegin{curvature_dependence}
    \cgalParamDescription{with the settings of the paper, how strongly the relaxation gathers samples
                          where the surface bends: the exponent \f$d\f$ of \f$\phi_1\f$ and
                          \f$\phi_2\f$}
    \cgalParamType{floating scalar value, at least 0 and finite}
    \cgalParamDefault{`2`}
    \cgalParamExtra{With 0, the relaxation knows no curvature and spreads the samples uniformly.
                    Together with `adaptivity(0)`, this is LOP with the repulsion of \cgalCite{wlop-2009}.}
  \cgalParamNEnd

  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{with the settings of the paper, the radius \f$h\f$ of the ball in which input
                          points attract and other samples repel a sample, in the unit of the
                          coordinates}
    \cgalParamType{floating scalar value, above 0 and finite}
    \cgalParamDefault{twice the spacing of the selected points, so that the ball holds two rings of
                      them}
    \cgalParamExtra{A larger radius removes more noise and detail and takes more time.}
  \cgalParamNEnd

  \cgalParamNBegin{require_uniform_sampling}
    \cgalParamDescription{with the settings of the paper, if `true`, the terms of eq. 8 are weighted
                          by the local densities as in WLOP \cgalCite{wlop-2009}, which evens out an
                          input of very uneven density}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Takes a ball query more for each input point, and one for each sample and
                    iteration.}
  \cgalParamNEnd

  \cgalParamNBegin{recompute_curvature}
    \cgalParamDescription{with the settings of the paper, if `true`, the surface variation of a
                          sample is computed from the input points around it in every iteration
                          (section 5.3), which helps with noise; if `false`, it is that of the nearest
                          input point (section 4.2)}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Takes a query of `number_of_neighbors` points more for each sample and iteration.}
  \cgalParamNEnd

  \cgalParamNBegin{random_seed}
    \cgalParamDescription{seed of the random numbers: same input and seed, same result}
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
                    returned as it was, nor to the report: only the callback knows. It may throw: the
                    exception is passed on, and nothing is written either.}
  \cgalParamNEnd

  \cgalParamNBegin{simplification_report}
    \cgalParamDescription{receives what was found in the input, such as the noise and the number of
                          outliers, and the time of each stage}
    \cgalParamType{`std::reference_wrapper<CGAL::Curvature_aware_simplification_report>`}
    \cgalParamDefault{unused}
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

\return the iterator behind the last point written

\throws std::invalid_argument if `points` is empty, a coordinate is not finite (the message tells the
        index of the first such point), points are so far from many others that these would be as one, as if
        the largest number stood for a missing measurement (the message tells the index of one, the manual
        how far is too far), or a parameter is out of its range (the message tells its name, its value and
        what is allowed); nothing is written then. What the property map, the callback or the output iterator
        throws is passed on, as is `std::bad_alloc`.

\sa `CGAL::wlop_simplify_and_regularize_point_set()`
\sa `CGAL::curvature_aware_random_simplify_point_set()`
\sa `CGAL::estimate_surface_variation()`
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator
curvature_aware_simplify_point_set(const PointRange& points, OutputIterator output,
                                   const NamedParameters& np = parameters::default_values())
{
  namespace internal = Curvature_aware_simplification_3::internal;
  return internal::simplify_point_set<ConcurrencyTag>(points, output, np,
                                                      internal::default_settings);
}

} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFY_POINT_SET_H
