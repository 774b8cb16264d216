"""Builds a show's scene in Blender 3.4, in hazer's units: what Cycles then writes is cd/m2.

Two things of Cycles 3.4 are accounted for. A spot of P watts has the intensity P / (4 pi) * cos(angle from the axis); its
nodes divide by that cosine. And light is attenuated only inside the mesh that holds the volume, so one box holds everything.
"""

import math

import bpy
from mathutils import Vector

# Edge of the box of haze [m].
BOX_M = 400.0
# hazer's pedestal under a soft profile: its PROFILE_CUT.
PROFILE_CUT = 0.005


def add_object(name, data, position=(0, 0, 0)):
    thing = bpy.data.objects.new(name, data)
    thing.location = position
    bpy.context.scene.collection.objects.link(thing)
    return thing


def point_at(thing, direction):
    """Blender's cameras and spots look along their -Z."""
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = Vector(direction).to_track_quat("-Z", "Y")


def nodes_of(owner):
    """An empty node tree, and a way to add to it: node(type, {input: number or socket})."""
    owner.use_nodes = True
    tree = owner.node_tree
    tree.nodes.clear()

    def node(kind, inputs=None, operation=None):
        new = tree.nodes.new(kind)
        if operation:
            new.operation = operation
        for key, value in (inputs or {}).items():
            if isinstance(value, bpy.types.NodeSocket):
                tree.links.new(value, new.inputs[key])
            else:
                new.inputs[key].default_value = value
        return new

    return node


def plane(name, size):
    x, y = size[0] / 2, size[1] / 2
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)], [], [(0, 1, 2, 3)])
    return mesh


def box(name, edge):
    e = edge / 2
    corners = [(x, y, z) for x in (-e, e) for y in (-e, e) for z in (-e, e)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], sides)
    return mesh


def add_haze(haze):
    """Volume Scatter extinguishes what it scatters; the rest of the extinction is absorption."""
    material = bpy.data.materials.new("haze")
    node = nodes_of(material)
    scatter = node(
        "ShaderNodeVolumeScatter",
        {"Color": (1, 1, 1, 1), "Density": haze["scattering"], "Anisotropy": haze["g"]},
    )
    absorb = node(
        "ShaderNodeVolumeAbsorption",
        {"Color": (0, 0, 0, 1), "Density": haze["extinction"] - haze["scattering"]},
    )
    both = node("ShaderNodeAddShader", {0: scatter.outputs[0], 1: absorb.outputs[0]})
    node("ShaderNodeOutputMaterial", {"Volume": both.outputs[0]})
    material.cycles.homogeneous_volume = True
    material.cycles.volume_sampling = "MULTIPLE_IMPORTANCE"
    mesh = box("haze", BOX_M)
    mesh.materials.append(material)
    add_object("haze", mesh)


def add_floor(floor):
    material = bpy.data.materials.new("floor")
    node = nodes_of(material)
    diffuse = node("ShaderNodeBsdfDiffuse", {"Color": (*floor["albedo"], 1), "Roughness": 0.0})
    node("ShaderNodeOutputMaterial", {"Surface": diffuse.outputs[0]})
    mesh = plane("floor", floor["size"])
    mesh.materials.append(material)
    add_object("floor", mesh, floor["position"])


def exponent_of(light):
    """Of the super-Gaussian that has 50 % at one angle and 10 % at the other."""
    return math.log(math.log(10) / math.log(2)) / math.log(light["half_angle"] / light["beam_half_angle"])


def profile(node, light, cosine):
    """Intensity over its peak as a socket or a number: 1, or hazer's super-Gaussian of the angle from the axis."""
    if light["beam_half_angle"] is None:
        return 1.0
    angle = node("ShaderNodeMath", {0: cosine}, "ARCCOSINE").outputs[0]
    relative = node("ShaderNodeMath", {0: angle, 1: math.radians(light["beam_half_angle"])}, "DIVIDE").outputs[0]
    power = node("ShaderNodeMath", {0: relative, 1: exponent_of(light)}, "POWER").outputs[0]
    gauss = node("ShaderNodeMath", {0: 0.5, 1: power}, "POWER").outputs[0]
    lowered = node("ShaderNodeMath", {0: gauss, 1: PROFILE_CUT}, "SUBTRACT").outputs[0]
    shown = node("ShaderNodeMath", {0: lowered, 1: 0.0}, "MAXIMUM").outputs[0]
    return node("ShaderNodeMath", {0: shown, 1: 1.0 - PROFILE_CUT}, "DIVIDE").outputs[0]


def color_of(light):
    """The light's colour with luminance 1 (Rec. 709), as hazer has it."""
    luminance = sum(share * c for share, c in zip((0.2126, 0.7152, 0.0722), light["color"]))
    return [c / luminance for c in light["color"]]


def cone_half_angle(light):
    """Where the light ends [rad]: a soft beam where its profile has sunk to the pedestal."""
    if light["beam_half_angle"] is None:
        return math.radians(light["half_angle"])
    return math.radians(light["beam_half_angle"]) * math.log2(1 / PROFILE_CUT) ** (1 / exponent_of(light))


def add_light(light):
    lamp = bpy.data.lights.new("lamp", "SPOT")
    lamp.energy = 4 * math.pi * light["candela"]
    lamp.color = color_of(light)
    lamp.shadow_soft_size = 0.0
    lamp.spot_size = 2 * cone_half_angle(light)
    lamp.spot_blend = 0.0
    node = nodes_of(lamp)
    along = node("ShaderNodeTexCoord").outputs["Normal"]
    z = node("ShaderNodeSeparateXYZ", {0: along}).outputs["Z"]
    cosine = node("ShaderNodeMath", {0: z}, "ABSOLUTE").outputs[0]
    strength = node("ShaderNodeMath", {0: profile(node, light, cosine), 1: cosine}, "DIVIDE").outputs[0]
    emission = node("ShaderNodeEmission", {"Strength": strength})
    node("ShaderNodeOutputLight", {"Surface": emission.outputs[0]})
    point_at(add_object("lamp", lamp, light["position"]), light["direction"])


def add_camera(camera):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.lens = data.sensor_height / 2 / math.tan(math.radians(camera["fov"]) / 2)
    data.clip_start = 1e-6  # the air before it is not drawn
    data.clip_end = 1e4
    thing = add_object("camera", data, camera["position"])
    point_at(thing, [t - p for t, p in zip(camera["target"], camera["position"])])
    bpy.context.scene.camera = thing


def build(show):
    """The show alone, in a dark world."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    world = bpy.data.worlds.new("dark")
    world.color = (0, 0, 0)
    bpy.context.scene.world = world
    add_haze(show["haze"])
    for floor in show["floors"]:
        add_floor(floor)
    for light in show["lights"]:
        add_light(light)
    add_camera(show["camera"])
