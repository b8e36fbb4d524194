#!/usr/bin/env python3
"""Renders point sets side by side over a surface, with the same camera, to one PNG file.

Each point is a small dark ball. Points of the far side do not shine through: the balls are drawn
over the surface, which is the mesh of the reference, or, where it is a point set, its points as
balls large enough to touch each other.
"""

import argparse
import pathlib

import meshio
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def read(filename):
    """points and triangles of a file"""
    if pathlib.Path(filename).suffix in (".xyz", ".pwn"):
        return numpy.loadtxt(filename, usecols=(0, 1, 2)), numpy.empty((0, 3), int)
    mesh = meshio.read(filename)
    triangles = mesh.cells_dict.get("triangle", numpy.empty((0, 3), int))
    return numpy.asarray(mesh.points, float), numpy.asarray(triangles)


def poly_data(points, triangles=()):
    data = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    data.SetPoints(vtk_points)
    if len(triangles):
        cells = vtk.vtkCellArray()
        records = numpy.hstack([numpy.full((len(triangles), 1), 3), triangles]).astype(numpy.int64)
        cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(records.ravel(), deep=True))
        data.SetPolys(cells)
    return data


def vertices(points):
    """a cell for each point, without which nothing is drawn"""
    glyphs = vtk.vtkVertexGlyphFilter()
    glyphs.SetInputData(poly_data(points))
    glyphs.Update()
    return glyphs.GetOutput()


def spacing(points):
    """median distance to the nearest of a few thousand points, among all"""
    locator = vtk.vtkStaticPointLocator()
    locator.SetDataSet(poly_data(points))
    locator.BuildLocator()
    nearest, distances = vtk.vtkIdList(), []
    for p in points[:: max(1, len(points) // 2000)]:
        locator.FindClosestNPoints(2, p, nearest)
        distances.append(numpy.linalg.norm(points[nearest.GetId(nearest.GetNumberOfIds() - 1)] - p))
    return float(numpy.median(distances))


def actor(mapper, color):
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetColor(*color)
    result.GetProperty().SetSpecular(0.0)
    result.GetProperty().SetAmbient(0.15)
    return result


def balls(points, radius, color):
    mapper = vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(vertices(points))
    mapper.SetRadius(radius)
    return actor(mapper, color)


def surface(points, triangles, smallest_radius):
    gray = (0.85, 0.85, 0.82)
    if not len(triangles):
        return balls(points, max(1.2 * spacing(points), smallest_radius), gray)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(poly_data(points, triangles))
    normals.SplittingOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    return actor(mapper, gray)


def caption_height(size):
    """of the strip below a picture, in pixels"""
    return max(20, size // 16)


def add_caption(strip, text, size):
    caption = vtk.vtkTextActor()
    caption.SetInput(text)
    caption.SetPosition(size // 2, caption_height(size) // 4)
    style = caption.GetTextProperty()
    style.SetJustificationToCentered()
    style.SetColor(0, 0, 0)
    strip.AddActor(caption)
    largest = caption.SetConstrainedFontSize(strip, int(0.96 * size), caption_height(size))
    style.SetFontSize(min(largest, max(12, size // 28)))


def layer(window, left, bottom, width, height):
    """a white part of the window, given in pixels"""
    total_width, total_height = window.GetSize()
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(left / total_width, bottom / total_height,
                         (left + width) / total_width, (bottom + height) / total_height)
    window.AddRenderer(renderer)
    return renderer


def place_camera(camera, points, arguments):
    """looks at all of the points, or at a part of the picture of them; returns half its height"""
    direction = numpy.array(arguments.direction) / numpy.linalg.norm(arguments.direction)
    right = numpy.cross(arguments.up, direction)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(direction, right)
    center, half = numpy.zeros(3), 0.0
    for axis in (right, up):
        low, high = (points @ axis).min(), (points @ axis).max()
        center += axis * (low + high) / 2
        half = max(half, 1.05 * (high - low) / 2)
    center += half * (arguments.focus[0] * right + arguments.focus[1] * up)
    camera.SetFocalPoint(*center)
    camera.SetPosition(*(center + 10 * half * direction))
    camera.SetViewUp(*up)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half / arguments.zoom)
    return half / arguments.zoom


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("reference", help="mesh or point set under the points")
    parser.add_argument("points", nargs="+", help="point sets, one picture each: FILE or FILE=TITLE")
    parser.add_argument("--output", required=True, help="PNG file")
    parser.add_argument("--direction", type=float, nargs=3, default=(0.3, 0.25, 1.0),
                        help="from the object to the camera")
    parser.add_argument("--up", type=float, nargs=3, default=(0, 1, 0))
    parser.add_argument("--focus", type=float, nargs=2, default=(0.0, 0.0),
                        help="the center of a close-up: right and up, from -1 to 1 in the whole picture")
    parser.add_argument("--zoom", type=float, default=1.0)
    parser.add_argument("--columns", type=int, help="pictures in a row; default: all")
    parser.add_argument("--size", type=int, default=600, help="width and height of one picture")
    parser.add_argument("--ball", type=float, default=0.3, help="radius of the balls, in spacings")
    arguments = parser.parse_args()

    reference, triangles = read(arguments.reference)
    low, high = reference.min(axis=0), reference.max(axis=0)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    columns = arguments.columns or len(arguments.points)
    rows = -(-len(arguments.points) // columns)
    size, strip = arguments.size, caption_height(arguments.size)
    window.SetSize(size * columns, (size + strip) * rows)
    for i, item in enumerate(arguments.points):
        filename, _, title = item.partition("=")
        points, _ = read(filename)
        left, bottom = i % columns * size, (rows - 1 - i // columns) * (size + strip)
        add_caption(layer(window, left, bottom, size, strip),
                    title or pathlib.Path(filename).stem, size)
        renderer = layer(window, left, bottom + strip, size, size)
        # coordinates relative to the center: the graphics card computes with floats
        center = (low + high) / 2
        height = place_camera(renderer.GetActiveCamera(), reference - center, arguments)
        smallest_radius = 0.004 * height  # to be seen
        radius = max(min(arguments.ball * spacing(points), 0.02 * height), smallest_radius)
        renderer.AddActor(surface(reference - center, triangles, smallest_radius))
        renderer.AddActor(balls(points - center, radius, (0.1, 0.15, 0.45)))
        renderer.ResetCameraClippingRange()
    window.Render()

    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(arguments.output)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
