# SPDX-License-Identifier: Apache-2.0
"""Strands as Blender's curves: points and radii in the scene's units."""
import bpy
import numpy

from .. import nodes
from ..program import Problem
from . import axes

COLOUR = "colour"  # the attribute that materials read, one to a strand


def make(name, hair, mm, form, materials):
    """A data-block of the form that nobody uses yet. mm: of one of the scene's units."""
    points = numpy.ascontiguousarray(axes.to_blender(hair.points) / mm, "f4")
    radii = numpy.ascontiguousarray(hair.radii / mm, "f4")
    return (hair_curves if form == "HAIR" else poly_curve)(name, hair, points, radii, materials)


def hair_curves(name, hair, points, radii, materials):
    made = bpy.data.hair_curves.new(name)
    try:
        if hasattr(made, "add_curves"):  # Blender 4.2
            made.add_curves(numpy.diff(hair.first).tolist())
        else:
            made = through_a_mesh(made, hair.first)
        if len(made.curves) != len(hair.first) - 1 or len(made.points) != len(points):
            raise Problem("Blender made %d strands of %d points, not %d of %d" % (
                len(made.curves), len(made.points), len(hair.first) - 1, len(points)))
        made.position_data.foreach_set("vector", points.ravel())
        radius = made.attributes.get("radius") or made.attributes.new("radius", "FLOAT", "POINT")
        radius.data.foreach_set("value", radii)
        colour = numpy.ones((len(hair.colours), 4), "f4")
        colour[:, :3] = axes.linear(hair.colours)
        there = made.attributes.new(COLOUR, "FLOAT_COLOR", "CURVE")
        there.data.foreach_set("color", colour.ravel())
        for material in materials:
            made.materials.append(material)
    except BaseException:
        bpy.data.hair_curves.remove(made)
        raise
    return made


def through_a_mesh(curves, first):
    """Before 4.2 Python cannot give hair curves their points, but the node Mesh to Curve can,
    applied: a chain of edges becomes a curve, in the order of the points."""
    chain = numpy.ones(first[-1] - 1, bool)
    chain[first[1:-1] - 1] = False  # none from a strand's last point to the next one's first
    begin = numpy.flatnonzero(chain).astype("i4")
    mesh = bpy.data.meshes.new("sozai: chains")
    chains = bpy.data.objects.new("sozai: chains", mesh)
    holder = bpy.data.objects.new("sozai: strands", curves)
    tree = bpy.data.node_groups.new("sozai: strands", "GeometryNodeTree")
    scene = bpy.context.scene
    try:
        mesh.vertices.add(int(first[-1]))
        mesh.edges.add(len(begin))
        mesh.edges.foreach_set("vertices", numpy.stack((begin, begin + 1), 1).ravel())
        nodes.add_output(tree, "NodeSocketGeometry", "Geometry")
        source = tree.nodes.new("GeometryNodeObjectInfo")
        source.inputs["Object"].default_value = chains
        turned = tree.nodes.new("GeometryNodeMeshToCurve")
        end = tree.nodes.new("NodeGroupOutput")
        tree.links.new(source.outputs["Geometry"], turned.inputs["Mesh"])
        tree.links.new(turned.outputs["Curve"], end.inputs["Geometry"])
        scene.collection.objects.link(holder)
        holder.modifiers.new("sozai", "NODES").node_group = tree
        with bpy.context.temp_override(object=holder, active_object=holder):
            bpy.ops.object.modifier_apply(modifier="sozai")
        return holder.data
    finally:
        bpy.data.objects.remove(holder)
        bpy.data.objects.remove(chains)
        bpy.data.meshes.remove(mesh)
        bpy.data.node_groups.remove(tree)


def poly_curve(name, hair, points, radii, materials):
    """A slot of materials to each colour, for splines have no attributes."""
    made = bpy.data.curves.new(name, "CURVE")
    for material in materials:  # first: a spline's slot must be there
        made.materials.append(material)
    made.dimensions, made.bevel_mode = "3D", "ROUND"
    made.bevel_depth, made.bevel_resolution, made.use_fill_caps = 1.0, 1, True
    slots = colours_of(hair)[1]
    four = numpy.ones((len(points), 4), "f4")
    four[:, :3] = points
    for k in range(len(hair.first) - 1):
        a, b = hair.first[k], hair.first[k + 1]
        spline = made.splines.new("POLY")
        spline.points.add(int(b - a) - 1)
        spline.points.foreach_set("co", four[a:b].ravel())
        spline.points.foreach_set("radius", radii[a:b])
        spline.material_index = int(slots[k])
    return made


def colours_of(hair):
    """Each that there is, as light, and which one every strand has."""
    each, first, slots = numpy.unique(hair.colours, axis=0, return_index=True, return_inverse=True)
    order = numpy.argsort(first)  # in the order of the strands
    place = numpy.empty(len(order), int)
    place[order] = numpy.arange(len(order))
    return axes.linear(each[order]), place[slots.ravel()]
