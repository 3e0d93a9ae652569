"""Pieces as meshes of PyVista."""

from __future__ import annotations

import numpy as np

from ._summary import _imported


def surface(piece):
    """Returns the surface of a piece as it lies in the kitchen, points in metres, with every field of its nodes there."""
    pyvista = _imported("pyvista", "viz")
    triangles = piece.surface_triangles
    if len(triangles) == 0:
        raise ValueError(f"a {piece.kind} has no triangles of its surface: it is a body from a surface file")
    pose = piece.pose_m
    points = turned(piece.surface_points_m, pose[3:]) + pose[:3]
    faces = np.column_stack([np.full(len(triangles), 3), triangles]).ravel()
    mesh = pyvista.PolyData(points, faces)
    nodes = piece.surface_nodes
    for name, field in piece.fields().items():
        mesh.point_data[name] = field[nodes]
    return mesh


def turned(points, quaternion):
    """Returns points turned by a unit quaternion, [x, y, z, w]."""
    axis, w = quaternion[:3], quaternion[3]
    once = np.cross(axis, points)
    return points + 2.0 * (w * once + np.cross(axis, once))
