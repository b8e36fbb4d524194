"""open3d_filters.py FILTERS PARAMETER INPUT.ply OUTPUT.ply

Applies filters of Open3D and prints the seconds that they took, without reading and writing.
PARAMETER is the size of a voxel or the number of points.
"""

import sys
import time

import open3d


def without_outliers(cloud):
    inliers, _ = cloud.remove_statistical_outlier(nb_neighbors=20, std_ratio=0.3)
    return inliers


FILTERS = {
    "voxel": lambda cloud, size: cloud.voxel_down_sample(float(size)),
    "farthest_point": lambda cloud, count: cloud.farthest_point_down_sample(int(count)),
    "outliers_voxel": lambda cloud, size: without_outliers(cloud).voxel_down_sample(float(size)),
}

name, parameter, input_name, output_name = sys.argv[1:]
cloud = open3d.io.read_point_cloud(input_name)
start = time.perf_counter()
output = FILTERS[name](cloud, parameter)
print(time.perf_counter() - start)
if not open3d.io.write_point_cloud(output_name, output):
    sys.exit("Open3D cannot write its output")
