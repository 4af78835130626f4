# SPDX-License-Identifier: MIT
"""Draws the active object in pen and ink: an add-on for Blender 3.4, with a panel "Pen and Ink" in the 3D view's sidebar.

Blender's Python must find the package hrbfnpr; see README.md.
"""

import warnings

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, IntProperty, PointerProperty

bl_info = {
    "name": "Pen and Ink (hrbfnpr)",
    "author": "the hrbfnpr contributors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Pen and Ink",
    "description": "Draws an object in pen and ink, and makes its marks a point cloud",
    "category": "Render",
}

IMAGE = "Pen and Ink"
NODES = "Pen and Ink Points"
NORMAL = "surface_normal"  # attribute of points; Blender uses the name "normal" itself
STYLES = (
    "stipple", "hatch", "cross-hatch", "combing", "silhouette", "contour-and-stipple", "xray", "full", "engraving",
    "etching", "woodcut", "scientific-stipple", "sketch", "blueprint", "archaeological")
WITH_SURFACE = {"MESH", "CURVE", "SURFACE", "META", "FONT"}


class Settings(bpy.types.PropertyGroup):
    """The settings in the panel, saved with the scene."""

    style: EnumProperty(
        name="Style", items=[(name, name.replace("-", " ").title(), "") for name in STYLES],
        default="contour-and-stipple")
    samples: IntProperty(
        name="Samples", default=0, min=0, soft_max=8000,
        description="Number of surface points to draw from. 0: as many as the shape needs")
    budget: IntProperty(
        name="Marks", default=0, min=0, soft_max=500_000,
        description="Largest number of marks in each layer. 0: as many as the darkest tone needs")
    width: IntProperty(name="Width", default=640, min=1, max=32768, subtype="PIXEL")
    height: IntProperty(name="Height", default=480, min=1, max=32768, subtype="PIXEL")
    scene_camera: BoolProperty(
        name="Scene Camera", default=False,
        description="Draw what the camera of the scene sees. Otherwise the object fills the picture, seen from the front "
                    "and above")


def array(collection, attribute, components, dtype=np.float32):
    """An attribute of all elements as an array of shape (n, components)."""
    values = np.empty(len(collection) * components, dtype)
    collection.foreach_get(attribute, values)
    return values.reshape(-1, components)


def source_of(hrbfnpr, context):
    """The active object with its modifiers in world space: a mesh, or points with normals in an attribute."""
    shown = context.object.evaluated_get(context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    try:
        points = array(mesh.vertices, "co", 3).astype(float)
        given = mesh.attributes.get(NORMAL)
        with_normals = given is not None and (given.data_type, given.domain) == ("FLOAT_VECTOR", "POINT")
        normals = array(given.data, "vector", 3).astype(float) if with_normals else None
        mesh.calc_loop_triangles()
        triangles = array(mesh.loop_triangles, "vertices", 3, np.int32).astype(np.int64)
        is_sharp = array(mesh.edges, "use_edge_sharp", 1, bool)[:, 0]
        sharp = array(mesh.edges, "vertices", 2, np.int32)[is_sharp].astype(np.int64)
    finally:
        shown.to_mesh_clear()
    world = np.array(shown.matrix_world)
    points = points @ world[:3, :3].T + world[:3, 3]
    if normals is not None:
        return hrbfnpr.shapes.Shape(points, normals @ np.linalg.inv(world[:3, :3]))
    if np.linalg.det(world[:3, :3]) < 0:  # a mirrored object, whose faces would look inward
        triangles = triangles[:, ::-1]
    return hrbfnpr.shapes.Shape(points, triangles=triangles, sharp_edges=sharp if len(sharp) else None)


def camera_of(hrbfnpr, context):
    """The scene's camera, or None if there is no camera or the object should fill the picture."""
    settings = context.scene.hrbfnpr
    size = settings.width, settings.height
    chosen = context.scene.camera
    if not settings.scene_camera or chosen is None:
        return None
    projection = chosen.calc_matrix_camera(context.evaluated_depsgraph_get(), x=size[0], y=size[1])
    return hrbfnpr.Camera(chosen.matrix_world.normalized().inverted(), projection, (0, 0, *size))


def picture_of(hrbfnpr, context, in_one_surface):
    """Draws the active object with the library."""
    settings, window = context.scene.hrbfnpr, context.window_manager
    camera = camera_of(hrbfnpr, context)
    view = {"camera": camera} if camera else {"direction": (0, 1, -1), "size": (settings.width, settings.height)}
    return hrbfnpr.draw(
        source_of(hrbfnpr, context), settings.style, **view, up=(0, 0, 1), samples=settings.samples or None,
        marks=settings.budget or None, together=in_one_surface, keep_marks=in_one_surface,
        progress=lambda doing, share: window.progress_update(100 * share))


def image_of(pixels):
    """Writes rows of RGBA8, top row first, to the image datablock."""
    height, width = pixels.shape[:2]
    image = bpy.data.images.get(IMAGE)
    if image is None:
        image = bpy.data.images.new(IMAGE, width, height, alpha=True)
    elif tuple(image.size) != (width, height):
        image.scale(width, height)
    image.pixels.foreach_set((pixels[::-1].astype(np.float32) / 255).ravel())  # Blender's rows start at the bottom
    image.update()
    image.pack()  # saved with the file
    return image


def units_per_pixel(camera, places):
    """The length across the view that a pixel covers, at one or several places."""
    row = (camera.projection @ camera.view)[3]
    depth = np.asarray(places, float) @ row[:3] + row[3]
    return 2 * np.abs(depth) / (camera.projection[1, 1] * camera.size[1])


def attributes_of(marks, style, pixel):
    """Name, type and values of all attributes of the marks, layer after layer."""
    def joined(values):
        return np.concatenate([values(layer) for layer in marks.layers])

    def radius(layer):
        width = layer.widths if len(layer.widths) else np.ones(len(layer), np.float32)
        return width * style.style_of(layer.kind, layer.name).radius * pixel

    return [
        (NORMAL, "FLOAT_VECTOR", joined(lambda layer: layer.normals)),
        ("direction", "FLOAT_VECTOR", joined(lambda layer: layer.directions)),
        ("rank", "FLOAT", joined(lambda layer: layer.ranks)),
        ("radius", "FLOAT", joined(radius)),
        ("level", "INT", joined(lambda layer: layer.levels)),
        ("stroke", "INT", joined(lambda layer: layer.stroke_places[:, 0])),
        ("place", "INT", joined(lambda layer: layer.stroke_places[:, 1])),
        ("layer", "INT", joined(lambda layer: np.full(len(layer), layer.number))),
    ]


def mesh_to_points():
    """Geometry nodes that turn vertices into a point cloud with the radii of the attribute `radius`."""
    tree = bpy.data.node_groups.get(NODES)
    if tree is not None:
        return tree
    tree = bpy.data.node_groups.new(NODES, "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Vertices")
    tree.outputs.new("NodeSocketGeometry", "Points")
    vertices, points, result = (
        tree.nodes.new(kind) for kind in ("NodeGroupInput", "GeometryNodeMeshToPoints", "NodeGroupOutput"))
    radius = tree.nodes.new("GeometryNodeInputNamedAttribute")
    radius.data_type = "FLOAT"
    radius.inputs["Name"].default_value = "radius"
    tree.links.new(vertices.outputs[0], points.inputs["Mesh"])
    tree.links.new(next(socket for socket in radius.outputs if socket.enabled), points.inputs["Radius"])
    tree.links.new(points.outputs[0], result.inputs[0])
    return tree


def points_object(name, marks, attributes):
    """The marks as a point cloud. Blender 3.4 cannot create one from a script, so geometry nodes convert vertices."""
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(marks))
    positions = np.concatenate([layer.positions for layer in marks.layers])
    mesh.vertices.foreach_set("co", positions.ravel())
    for title, kind, values in attributes:
        data = mesh.attributes.new(title, kind, "POINT").data
        dtype = np.int32 if kind == "INT" else np.float32
        data.foreach_set("vector" if kind == "FLOAT_VECTOR" else "value", values.astype(dtype).ravel())
    mesh.update()
    result = bpy.data.objects.new(name, mesh)
    result.location = marks.origin
    result.modifiers.new("Points", "NODES").node_group = mesh_to_points()
    return result


def places_of(line, camera):
    """The world positions of a drawn stroke. Its "position" is that of the marks, and smooth hatching passes beside them."""
    x, y, depth = line["window"].astype(float).T
    width, height = camera.size
    clip = np.stack([2 * x / width - 1, 1 - 2 * y / height, 2 * depth - 1, np.ones_like(x)], axis=1)
    places = clip @ np.linalg.inv(camera.projection @ camera.view).T
    return places[:, :3] / places[:, 3:]


def strokes_object(name, drawing, camera):
    """The visible strokes as round curves in the world, with the drawn width at each point."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions, curve.bevel_depth, curve.use_fill_caps = "3D", 1, True  # so the radius of a point is in world units
    for line in drawing.polylines():
        if line["hidden_layers"][0] > 0:
            continue
        spline = curve.splines.new("POLY")
        spline.points.add(len(line) - 1)  # a new spline has one point
        places = places_of(line, camera)
        radii = line["radius"] * units_per_pixel(camera, places)
        rows = np.append(places, np.ones((len(places), 1)), axis=1)
        spline.points.foreach_set("co", rows.astype(np.float32).ravel())
        spline.points.foreach_set("radius", radii.astype(np.float32))
    return bpy.data.objects.new(name, curve)


class OfActiveObject:
    """Base class of operators that draw the active object. It reports the library's errors and notes."""

    bl_options = {"REGISTER", "UNDO"}
    in_one_surface = False

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type in WITH_SURFACE

    def execute(self, context):
        try:
            import hrbfnpr
        except ImportError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        context.window_manager.progress_begin(0, 100)
        try:
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always", hrbfnpr.DrawingWarning)
                picture = picture_of(hrbfnpr, context, self.in_one_surface)
            for warning in told:
                self.report({"WARNING"}, str(warning.message))
            for note in picture.notes:
                self.report({"INFO"}, note)
            self.make(picture, context)
        except (hrbfnpr.Error, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            context.window_manager.progress_end()
        return {"FINISHED"}


class HRBFNPR_OT_draw(OfActiveObject, bpy.types.Operator):
    bl_idname = "hrbfnpr.draw"
    bl_label = "Draw"
    bl_description = f'Draw the active object on the image "{IMAGE}"'

    def make(self, picture, context):
        self.report({"INFO"}, f'{picture!r} is on the image "{image_of(picture.image).name}"')


class HRBFNPR_OT_marks(OfActiveObject, bpy.types.Operator):
    bl_idname = "hrbfnpr.marks"
    bl_label = "Marks as Point Cloud"
    bl_description = "Make a point cloud of the active object's marks, with attributes for geometry nodes"
    in_one_surface = True  # otherwise each crossing part would have its own marks, and only those of this camera

    def make(self, picture, context):
        marks = picture.marks
        low, high = marks.bounds
        pixel = units_per_pixel(picture.camera, (np.array(low) + high) / 2)
        result = points_object(f"{context.object.name} marks", marks, attributes_of(marks, picture.style, pixel))
        context.collection.objects.link(result)
        self.report({"INFO"}, f"{len(marks)} marks in {result.name}")


class HRBFNPR_OT_strokes(OfActiveObject, bpy.types.Operator):
    bl_idname = "hrbfnpr.strokes"
    bl_label = "Strokes as Curves"
    bl_description = "Make curves of the strokes and lines that the camera sees, with a radius for each point"

    def make(self, picture, context):
        result = strokes_object(f"{context.object.name} strokes", picture.drawing, picture.camera)
        context.collection.objects.link(result)
        self.report({"INFO"}, f"{len(result.data.splines)} strokes in {result.name}")


class HRBFNPR_PT_panel(bpy.types.Panel):
    bl_label = "Pen and Ink"
    bl_category = "Pen and Ink"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context):
        settings, layout = context.scene.hrbfnpr, self.layout
        layout.use_property_split = True
        for name in ("style", "samples", "budget", "width", "height", "scene_camera"):
            layout.prop(settings, name)
        layout.operator(HRBFNPR_OT_draw.bl_idname)
        layout.operator(HRBFNPR_OT_marks.bl_idname)
        layout.operator(HRBFNPR_OT_strokes.bl_idname)
        if IMAGE in bpy.data.images:
            layout.label(text=f'See the image "{IMAGE}" in an image editor', icon="IMAGE_DATA")


CLASSES = (Settings, HRBFNPR_OT_draw, HRBFNPR_OT_marks, HRBFNPR_OT_strokes, HRBFNPR_PT_panel)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.hrbfnpr = PointerProperty(type=Settings)


def unregister():
    del bpy.types.Scene.hrbfnpr
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
