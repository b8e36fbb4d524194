// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_REPORT_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_REPORT_H

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgCurvatureAwareSimplification3Classes

\brief What `CGAL::curvature_aware_simplify_point_set()` found in its input and did.

Pass an object with the named parameter `simplification_report`, wrapped in `std::ref`. It is filled
when the function succeeds, and left as it is if it throws or the callback cancels it. Lengths are in the
unit of the input, times in seconds of wall time.

What is not measured is 0. If all distinct points are returned, or there are fewer than 57 of them, only
the numbers of points and the time of sorting are measured; if outliers leave fewer than 57, there is
no time from the selection on. With the settings of the paper, neither steps of the depth nor copies of
places nor outliers nor noise are looked for, and samples are moved in any case.
*/
struct Curvature_aware_simplification_report
{
  /// number of input points
  std::size_t number_of_input_points = 0;
  /// number of input points that differ from each other, relative to the center of their bounding box
  std::size_t number_of_distinct_points = 0;
  /// by how many distinct points there are fewer since copies of the same place were merged: nearer to
  /// each other by far than to the points around; 0 where that would leave fewer than are asked for
  std::size_t number_of_merged_points = 0;
  /// number of points written
  std::size_t number_of_output_points = 0;

  /// typical distance of neighboring output points: that of a hexagonal lattice of their mean
  /// density, where the area that an input point represents counts up to that of 0.85 output points, or
  /// twice its share if that is more, so that a few far points do not matter; or, with the settings of
  /// the paper, of the median density of the selected points; the
  /// nearest of the neighbors is nearer, on four scans at 0.80 to 0.88 of it in the mean
  double output_spacing = 0.;
  /// with the settings of the paper, the radius \f$h\f$ that was used, given or derived; otherwise 0
  double neighbor_radius = 0.;
  /// largest surface variation measured at an input point; nearby points of a flat part share one
  /// measurement, unless the settings of the paper are used
  double maximum_surface_variation = 0.;

  /// typical step to which the depth of the points was rounded, as by a depth camera, and which was undone; 0 if
  /// they show none. The median over the points, where steps differ by place; of several cameras, the largest step there.
  double depth_step = 0.;
  /// number of distinct input points that were taken for outliers and left out; copies of a place count once
  std::size_t number_of_outliers = 0;
  /// standard deviation of the distance of the other input points to the surface, as estimated: the median
  /// over the points, where it differs by place; at least about a tenth of `depth_step`, which is what is left when steps are
  /// undone; 0 if the points are too few to tell noise from shape
  double noise_level = 0.;

  /// copying, checking and sorting the points, building the search tree, undoing the rounding of depth,
  /// and merging copies of places
  double sorting_time = 0.;
  /// surface variation and density of all input points
  double features_time = 0.;
  /// finding outliers
  double outliers_time = 0.;
  /// estimating the noise level, and leaving out points that are very dense against it
  double noise_time = 0.;
  /// smoothing the points, if there is noise to see
  double smoothing_time = 0.;
  /// stochastic selection, and what it depends on
  double selection_time = 0.;
  /// fitting surfaces to the samples, and all iterations of the relaxation
  double relaxation_time = 0.;
  /// final projection of the samples, their way to sharp edges, corners of borders and points of the
  /// input, and those that are put on tips and ridges
  double projection_time = 0.;
};

} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_REPORT_H
