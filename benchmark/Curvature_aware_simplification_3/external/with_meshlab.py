"""MeshLab, by its command line program, which applies a script of filters."""

import math
from xml.etree import ElementTree

import numpy

from .job import Result, Setting, read_output
from .ply import read_points, read_values
from .process import run_headless
from .search import search

# two seconds each; the number of points jumps by some tenths of a percent between similar radii
TRIES = 12

# for normals; more than MeshLab's default of 10, against noise
NEIGHBORS = 16

CURVATURES = ("Mean", "Gauss", "K1", "K2", "ApproxMean")


# --- Filters, with all their parameters: the program refuses a script that omits one -------------

TYPES = {bool: "RichBool", int: "RichInt", float: "RichFloat", str: "RichString"}


def plain(name, value):
    text = str(value).lower() if isinstance(value, bool) else str(value)
    return {"name": name, "type": TYPES[type(value)], "value": text}


def layer(name, index):
    return {"name": name, "type": "RichMesh", "value": str(index)}


def make_filter(name, *parameters):
    element = ElementTree.Element("filter", name=name)
    for parameter in parameters:
        ElementTree.SubElement(element, "Param", parameter)
    return element


def normals():
    return make_filter(
        "Compute normals for point sets",
        plain("K", NEIGHBORS), plain("smoothIter", 0), plain("flipFlag", False),
        {"name": "viewPos", "type": "RichPoint3f", "x": "0", "y": "0", "z": "0"})


# accuracy, iterations and sphere are MeshLab's defaults
def surface(scale):
    return (plain("SelectionOnly", False), plain("FilterScale", float(scale)),
            plain("ProjectionAccuracy", 1e-4), plain("MaxProjectionIters", 15),
            plain("SphericalParameter", 1.0))


def curvature(scale):
    """mean curvature as the quality of the points"""
    names = {f"enum_val{i}": name for i, name in enumerate(CURVATURES)}
    return make_filter(
        "Colorize curvature (APSS)", *surface(scale),
        {"name": "CurvatureType", "type": "RichEnum", "value": "0",
         "enum_cardinality": str(len(CURVATURES)), **names})


def quality(expression):
    return make_filter("Per Vertex Quality Function", plain("q", expression),
                       plain("normalize", False), plain("map", False), plain("onselected", False))


def clamped_quality(low, high):
    return make_filter(
        "Clamp Vertex Quality", plain("minVal", float(low)), plain("maxVal", float(high)),
        {"name": "perc", "type": "RichDynamicFloat", "value": "0", "min": "0", "max": "100"},
        plain("zeroSym", False))


def poisson_disk(count, radius=0.0, variance=1.0, best_sample=True):
    """a subset in a new layer; it has `count` points, up to 0.5 %, unless a radius is given"""
    return make_filter(
        "Poisson-disk Sampling", plain("SampleNum", count),
        {"name": "Radius", "type": "RichAbsPerc", "value": f"{radius:.9g}", "min": "0", "max": "1"},
        plain("MontecarloRate", 20), plain("SaveMontecarlo", False),
        plain("ApproximateGeodesicDistance", False), plain("Subsample", True),
        plain("RefineFlag", False), layer("RefineMesh", 0),
        plain("BestSampleFlag", best_sample), plain("BestSamplePool", 10),
        plain("ExactNumFlag", radius == 0.0), plain("RadiusVariance", variance))


def projection(scale, surface_layer, points_layer):
    return make_filter(
        "MLS projection (APSS)", layer("ControlMesh", surface_layer),
        layer("ProxyMesh", points_layer), *surface(scale), plain("AccurateNormal", True),
        plain("MaxSubdivisions", 0), plain("ThAngleInDegree", 2.0))


# --- Methods ------------------------------------------------------------------------------------


def apply(job, filters, input_name, output_name, saved=()):
    """seconds that the program takes; it saves the layer that was made last"""
    script_name = job.folder / "meshlab.mlx"
    script = ElementTree.Element("FilterScript")
    script.extend(filters)
    script_name.write_bytes(b"<!DOCTYPE FilterScript>\n" + ElementTree.tostring(script))
    output_name.unlink(missing_ok=True)
    attributes = ["-m", *saved] if saved else []
    _, seconds = run_headless(
        ["meshlabserver", "-i", str(input_name), "-o", str(output_name), *attributes,
         "-s", str(script_name)], job.folder, job.deadline)
    return seconds


def simplify(job, filters):
    output = job.folder / "meshlab.ply"
    seconds = apply(job, filters, job.input, output)
    return Result(read_output(output, "MeshLab"), seconds, "process")


def poisson(job):
    yield Setting(f"exact number {job.count}",
                  lambda: simplify(job, [poisson_disk(job.count)]))


# FilterScale 6, where MeshLab's default is 2: wide enough for the noise of scans
def poisson_projected(job):
    yield Setting(f"exact number {job.count}, APSS projection FilterScale 6",
                  lambda: simplify(job, [normals(), poisson_disk(job.count), projection(6, 0, 1)]))


# Radii grow with the quality, from one radius to sqrt(3) of it: densities of 3 to 1, as those that
# curvature makes in the paper's selection between a point of mean surface variation and a flat one.
# The quality is hence the negative size of the curvature.
VARIANCE = math.sqrt(3.0)


def negative_size_of_curvature():
    return [normals(), curvature(4), quality("-abs(q)")]


# Half of the points count as flat, and the hundredth with the largest curvature, which may be
# noise, as no more curved than the rest; a user would read these bounds off the histogram.
QUANTILES = (0.01, 0.5)


def adaptive_poisson(job):
    curved = job.folder / "meshlab_curvature.ply"
    apply(job, negative_size_of_curvature(), job.input, curved, ["vq"])
    low, high = numpy.quantile(read_values(curved, "quality"), QUANTILES)

    def sampling(radius):
        return [clamped_quality(low, high), poisson_disk(job.count, radius, VARIANCE, False)]

    def count_at(radius):
        output = job.folder / "meshlab_search.ply"
        apply(job, sampling(radius), curved, output)
        return len(read_points(output))

    radius = search(count_at, job.count, job.diagonal, TRIES)
    yield Setting(
        f"radius {radius:.6g}, variance sqrt(3), APSS curvature FilterScale 4"
        f" between {-high:.6g} and {-low:.6g}",
        lambda: simplify(job, negative_size_of_curvature() + sampling(radius)))


METHODS = {
    "meshlab_poisson": poisson,
    "meshlab_adaptive_poisson": adaptive_poisson,
    "meshlab_poisson_projected": poisson_projected,
}
