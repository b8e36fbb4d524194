// run_pcl_filters keep|remove voxel_grid|uniform SIZE RADIUS INPUT OUTPUT
//
// Applies filters of PCL one after the other: statistical outlier removal, if asked for; centroids
// or a subset by cells of SIZE; moving least squares of RADIUS, unless that is 0. Prints the
// seconds that they took, without reading and writing. Files are plain arrays of float x y z.

#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/uniform_sampling.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl/surface/mls.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr read(const std::string& name)
{
  const Cloud::Ptr cloud(new Cloud);
  std::ifstream file(name, std::ios::binary);
  float p[3];
  while (file.read(reinterpret_cast<char*>(p), sizeof p))
    cloud->push_back({p[0], p[1], p[2]});
  if (cloud->empty())
    throw std::runtime_error("no points in " + name);
  return cloud;
}

void write(const std::string& name, const Cloud& cloud)
{
  std::ofstream file(name, std::ios::binary);
  for (const pcl::PointXYZ& p : cloud)
    file.write(reinterpret_cast<const char*>(p.data), 3 * sizeof(float));
  if (!file.flush())
    throw std::runtime_error("cannot write " + name);
}

template <class Filter>
Cloud::Ptr filtered(Filter& filter, const Cloud::Ptr& cloud)
{
  const Cloud::Ptr output(new Cloud);
  filter.setInputCloud(cloud);
  filter.filter(*output);
  return output;
}

Cloud::Ptr without_outliers(const Cloud::Ptr& cloud)
{
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setMeanK(20);
  filter.setStddevMulThresh(0.3);
  return filtered(filter, cloud);
}

Cloud::Ptr sampled(const Cloud::Ptr& cloud, const std::string& sampling, double size)
{
  if (sampling == "uniform")
  {
    pcl::UniformSampling<pcl::PointXYZ> filter;
    filter.setRadiusSearch(size);
    return filtered(filter, cloud);
  }
  if (sampling != "voxel_grid")
    throw std::invalid_argument("no sampling is called " + sampling);
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  const float leaf = static_cast<float>(size);
  filter.setLeafSize(leaf, leaf, leaf);
  return filtered(filter, cloud);
}

// The surface is that of all points, not of the samples alone. PCL does this only for a "distinct
// cloud"; its function setSearchSurface has no effect on moving least squares.
Cloud::Ptr projected(const Cloud::Ptr& samples, const Cloud::Ptr& cloud, double radius)
{
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> filter;
  filter.setInputCloud(cloud);
  filter.setUpsamplingMethod(decltype(filter)::DISTINCT_CLOUD);
  filter.setDistinctCloud(samples);
  filter.setCacheMLSResults(true);
  filter.setSearchRadius(radius);
  filter.setNumberOfThreads(std::thread::hardware_concurrency());
  const Cloud::Ptr output(new Cloud);
  filter.process(*output);
  return output;
}

} // namespace

int main(int argc, char* argv[])
try
{
  if (argc != 7)
    throw std::invalid_argument("expected keep|remove voxel_grid|uniform SIZE RADIUS INPUT OUTPUT");
  const double size = std::stod(argv[3]), radius = std::stod(argv[4]);
  const Cloud::Ptr input = read(argv[5]);

  const auto start = std::chrono::steady_clock::now();
  const Cloud::Ptr cloud = argv[1] == std::string("remove") ? without_outliers(input) : input;
  Cloud::Ptr output = sampled(cloud, argv[2], size);
  if (radius > 0.)
    output = projected(output, cloud, radius);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;

  write(argv[6], *output);
  std::cout << time.count() << std::endl;
}
catch (const std::exception& e)
{
  std::cerr << e.what() << std::endl;
  return EXIT_FAILURE;
}
