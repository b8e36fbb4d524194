// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_ADAPTIVE_SETTINGS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_ADAPTIVE_SETTINGS_H

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What the adaptive method does beyond the paper, each idea with a switch or a constant, so that
// the benchmark can tell what it is worth. Users never see them: nothing here depends on the input.
struct Adaptive_settings
{
  // Steps that depth was rounded to are undone, instead of taken for faces.
  bool undo_rounding = true;
  // Also where several cameras rounded depth, each along its own axis.
  bool tell_cameras = true;
  // Copies of a place are merged.
  bool merge_copies = true;
  // Outliers are removed.
  bool find_outliers = true;
  // Sparse parts of a surface are no outliers, even where all their points are thick and far from
  // each other.
  bool keep_sparse_surfaces = true;
  // Parts with so much noise that they look like a volume to their neighborhoods are none either.
  bool keep_noisy_layers = true;
  // Lone points of sparse borders and corners are no outliers.
  bool keep_lone_points = true;
  // Isolated clusters are outliers as well.
  bool find_clusters = true;
  // Noise is measured; without, there is taken to be none.
  bool measure_noise = true;
  // It is measured in layers of several columns, where points are one above the other.
  bool find_columns = true;
  // Each range of the Hilbert curve has the noise of its place; without, all have the median.
  bool noise_by_place = true;
  // Where there is any, it is measured at so many places at most. With 512, a median is that of an
  // eighth of the points: with noise along the rays of a scanner, the mean error is 5 % larger, and
  // samples are 8 to 16 % farther from the surface. 4096 take 8 % of the time of a noisy call.
  std::size_t most_noise_probes = 4096;
  // Where layers are as thick as wide, two sheets are told from one.
  bool tell_two_sheets = true;
  // Noise is no more than is told by layers that are thick by their shape, as those of thin parts
  // are.
  bool limit_noise_by_shape = true;
  // Noise is what fits of quadrics and of planes both show; without, quadrics alone.
  bool noise_around_planes = true;
  // Fits that stand on the surface do not show its noise, as on one line of a scan whose points are
  // no farther apart than noise is large.
  bool tell_standing_fits = true;
  // It is no more than the nearest points of a place can show: next to the other side of a thin
  // part, even if quadrics see only both.
  bool limit_noise_by_planes = true;

  // Points that are too dense against noise are thinned first.
  bool thin_dense_noise = true;
  // With noise, points are first smoothed one by one.
  bool smooth_points = true;
  // They are so by points around their foot points, and not around themselves.
  bool smooth_around_foot_points = true;
  // They are so by less where balls hold more than noise explains, as in thin parts.
  bool spare_thin_parts = true;
  // They are so in balls as wide as the shape allows, as it is seen around places of each range.
  bool smooth_by_shape = true;
  // Residuals of up to so many times the variance of the noise are taken for noise. More are shape,
  // and points are smoothed less. The variance of 24 residuals scatters by a half: by their weights
  // they count as 13, of which 6 are used up. From 2 to 3, the error near the edges of a cube is
  // the same within 3 %. With 2, sharp edges of CAD parts gain more, but of two scans that do not
  // fit together, more remains of the distance between them.
  double residuals_explained_by_noise = 2.5;

  // Radius of the balls in which curvature is measured for the density, in output spacings. Balls
  // of that size also see the other side of a part that is thinner, and make it dense.
  double curvature_radius = 1.5;
  // Curvature is bounded from below by half of its mean: flat parts keep 0.5^(2/3) = 0.63 of the
  // mean density, hence 1.26 times the spacing. Thin flat parts need a spacing below their
  // thickness, and reconstruction wants spacings that vary slowly: with 0.2, a plate of 1.5 % of
  // the diagonal was lost.
  double least_curvature = 0.5;
  // The curvature that counts is the mean over such a ball. Without that, the mean error of clean
  // scans is 1.5 % larger, that of a box with rounded edges 6 %, and 16 % at 1 % of the points.
  // With twice the area, there is no more to gain.
  bool average_curvature = true;
  // Samples for each point of the input, at most: these could not show more. With 0.6, errors are 1
  // to 2 % larger where the density is uneven; with 1, they are as with 0.85, and samples are
  // farther from the surface.
  double densest = 0.85;

  // How far samples repel each other, in spacings. With 1.22, theta is about that of the paper for
  // h of 2 spacings, which knows only the nearest neighbor, and is slow to even out.
  double reach_of_repulsion = 2.;
  // Heights over the tangent plane count so much more in rho^2, so that the two sides of a thin
  // part hardly see each other.
  double weight_of_height = 4.;
  // The sum of the weights of the neighbors counts as this at least, about what it is in a lattice.
  double least_weight_of_neighbors = 1.;
  // In an iteration, samples move in so many turns, each away from where the others have moved
  // before, as in a Gauss-Seidel method: where all moved at once, two neighbors would both leave a
  // place for the same gap. Two turns gain less, eight no more.
  std::size_t turns = 4;
  // The first steps of the relaxation are so many times as long as later ones, and what is between
  // shrinks evenly: long steps carry samples to where they are wanted, short ones let them settle.
  // With 2 or 3, the mean error is the same to 1 %; with steps that stay long, samples never
  // settle.
  double length_of_first_steps = 2.5;
  // Samples are not pushed across a border.
  bool keep_borders = true;

  // Fits on a line of a scan, and with noise between two, take more neighbors.
  bool widen_between_lines = true;
  // Without noise, samples on sparse points go back to one where noise of a point would be more
  // than so many times as large at the height of the fit, as beside wires and poles. With 3,
  // samples in a laser scan are 4 % nearer to the surface, but where the density varies 30 : 1 and
  // more, the mean error is 1 % larger, with 2 2 to 3 %; among dense points, that of open surfaces
  // 3 to 10 %.
  double largest_amplification = 4.;
  // How often the ball of a fit is moved to the foot point. Three moves bring a point
  // from 4 sigma to within the tolerance of sigma / 2.
  int moves_to_foot_point = 3;
  // With noise, each sample moves towards wider fits, as far as noise explains the difference.
  bool denoise = true;
  // The most points of these wider fits: twice those of the largest neighborhood of other fits.
  // Then noise is down to sigma / 10. With half as many, the error with noise is 5 % larger
  // (ablation).
  std::size_t points_of_widest_fit = 578;
  // What narrower fits have missed of the shape, over what the next wider one misses beyond: 1 /
  // (2^(3/2) - 1) if shape grows like the 3/2 power of the number of neighbors, as a cubic does.
  // With 1, as if it grew like their number, the results are the same within 1 %. With 0, the steps
  // to wider fits are those of a Wiener filter, which go too far where shape is fine: with noise,
  // errors of most shapes are 1 to 3 % larger and p99 2 to 4 %, those of smooth parts 2 to 5 %
  // smaller.
  double missed_shape = 0.547;
  // Noise along a bent surface puts fits inside of it: samples are moved back by that.
  bool correct_bias_of_noise = true;
  // Noisy samples are pushed apart once more, after they have been put on the surface.
  bool even_out = true;
  // Without outliers, points of the input are on the surface but for noise, and correct fits that
  // miss them.
  bool correct_by_points = true;
  // Samples on surfaces that are not known stay near points of the input.
  bool stay_near_points = true;
  // Samples next to a sharp edge are moved onto it.
  bool move_to_edges = true;
  // Samples next to a corner of an open surface are moved into it.
  bool move_to_corners = true;
  // alpha times this is the largest part of the samples that is inserted at last, where a mesh of
  // the others misses most: 0.03 by default, and none where they are to be even. With 0.02, half as
  // much is gained, with 0.04 no more.
  double share_to_insert = 0.045;
};

inline constexpr Adaptive_settings default_settings = Adaptive_settings();

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_ADAPTIVE_SETTINGS_H
