"""Writes the files of this folder with the programs their formats come from: VTK 9.7 and NumPy. pip install vtk numpy

Two polylines of 40 and 3 points: a helix and a corner, besides a vertex that is no line."""

import os
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

os.chdir(os.path.dirname(os.path.abspath(__file__)))
t = np.arange(40) / 4.0
helix = np.stack([np.floor(64 * np.cos(t)) / 64, np.floor(64 * np.sin(t)) / 64, t], 1)
corner = np.array([[5.0, 0.0, 0.0], [5.0, 1.0, 0.0], [5.0, 1.0, 2.5]])
np.savetxt("expected.txt", np.concatenate([helix, corner]), header="x y z")  # with a mark of comment before the header

points = vtk.vtkPoints()
points.SetDataTypeToDouble()
points.SetData(numpy_to_vtk(np.concatenate([helix, corner]), deep=1))
lines, verts = vtk.vtkCellArray(), vtk.vtkCellArray()
for first, count in [(0, len(helix)), (len(helix), len(corner))]:
    lines.InsertNextCell(count)
    for i in range(count):
        lines.InsertCellPoint(first + i)
verts.InsertNextCell(1)
verts.InsertCellPoint(0)
data = vtk.vtkPolyData()
data.SetPoints(points)
data.SetLines(lines)
data.SetVerts(verts)
speed = numpy_to_vtk(np.arange(len(helix) + len(corner), dtype=float), deep=1)
speed.SetName("speed")
data.GetPointData().AddArray(speed)

for version, name in [(42, "4"), (51, "5")]:
    for binary in [False, True]:
        writer = vtk.vtkPolyDataWriter()
        writer.SetInputData(data)
        writer.SetFileVersion(version)
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
        writer.SetFileName(f"legacy-{name}-{'binary' if binary else 'ascii'}.vtk")
        writer.Write()

def xml(writer, name, mode, compressor, encode, header):
    getattr(writer, f"SetDataModeTo{mode}")()
    writer.SetCompressor(vtk.vtkZLibDataCompressor() if compressor else None)
    writer.SetBlockSize(1024)
    writer.SetEncodeAppendedData(encode)
    getattr(writer, f"SetHeaderTypeTo{header}")()
    writer.SetFileName(name)
    writer.Write()

kinds = [
    ("ascii", "Ascii", False, 0, "UInt32"),
    ("inline", "Binary", False, 0, "UInt32"),
    ("inline-zlib", "Binary", True, 0, "UInt64"),
    ("appended", "Appended", False, 1, "UInt64"),
    ("appended-zlib", "Appended", True, 1, "UInt32"),
    ("appended-raw", "Appended", False, 0, "UInt32"),
    ("appended-raw-zlib", "Appended", True, 0, "UInt64"),
]
for name, mode, compressor, encode, header in kinds:
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    if name == "appended-raw":
        writer.SetByteOrderToBigEndian()
    xml(writer, f"{name}.vtp", mode, compressor, encode, header)

grid = vtk.vtkUnstructuredGrid()
grid.SetPoints(points)
grid.InsertNextCell(vtk.VTK_TRIANGLE, 3, [0, 1, 2])
for first, count in [(0, len(helix)), (len(helix), len(corner))]:
    grid.InsertNextCell(vtk.VTK_POLY_LINE, count, list(range(first, first + count)))
writer = vtk.vtkXMLUnstructuredGridWriter()
writer.SetInputData(grid)
xml(writer, "grid.vtu", "Appended", True, 1, "UInt32")
writer = vtk.vtkUnstructuredGridWriter()
writer.SetInputData(grid)
writer.SetFileTypeToBinary()
writer.SetFileName("grid.vtk")
writer.Write()

np.save("helix-fortran.npy", np.asfortranarray(helix))
np.save("helix-big-endian.npy", helix.astype(">f8"))
