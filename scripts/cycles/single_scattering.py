"""Run inside Blender: draws a show with Cycles, light once scattered, and compares the picture with hazer's.

blender -b --python single_scattering.py -- SHOW CAMERA HAZER.exr CYCLES.exr FINER SAMPLES

Cycles' pixels are means over their area, hazer's hold the ray through their middle: HAZER.exr has FINER x FINER pixels for
each of Cycles', and their mean is compared. Prints one line that begins with RESULT and goes on as JSON.
"""

import json
import sys
from pathlib import Path

import bpy
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
from blender_scene import build  # noqa: E402
from show_numbers import read_show  # noqa: E402

# Below this share of the picture's brightest it is dark: there is nothing to divide by.
LIT_SHARE = 1e-3


def load(file):
    """A linear EXR as rows x columns x RGB, in whatever order of rows Blender has."""
    image = bpy.data.images.load(str(file))
    width, height = image.size
    pixels = numpy.empty(width * height * 4, dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(height, width, 4)[:, :, :3].astype(numpy.float64)


def blocks(picture, finer):
    """The picture cut into blocks of finer x finer pixels: rows x finer x columns x finer x RGB."""
    height, width, channels = picture.shape
    return picture.reshape(height // finer, finer, width // finer, finer, channels)


def set_up_render(width, height, samples, out):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = width
    scene.render.resolution_y = height
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(out)
    scene.view_settings.view_transform = "Raw"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.light_sampling_threshold = 0.0
    cycles.sample_clamp_direct = 0.0
    cycles.sample_clamp_indirect = 0.0
    cycles.max_bounces = 0
    cycles.volume_bounces = 0
    cycles.pixel_filter_type = "BOX"


def compare(fine, cycles):
    """hazer / Cycles: over the pixels that are lit all over, and of the sums of both pictures.

    The edges are in the sums alone: how much of a pixel a beam's edge leaves lit is a matter of a few paths of Cycles.
    """
    hazer = fine.mean(axis=(1, 3))
    lit = fine.max(axis=4).min(axis=(1, 3)) > LIT_SHARE * fine.max()
    ratio = hazer[lit].sum(axis=1) / cycles[lit].sum(axis=1)
    return {
        "pixels": int(lit.sum()),
        "of": int(lit.size),
        "mean": float(ratio.mean()),
        "deviation": float(ratio.std()),
        "least": float(ratio.min()),
        "most": float(ratio.max()),
        "sums": [float(c) for c in hazer.sum(axis=(0, 1)) / cycles.sum(axis=(0, 1))],
    }


def main(show_file, camera, hazer_file, cycles_file, finer, samples):
    fine = blocks(load(hazer_file), int(finer))
    build(read_show(show_file, camera))
    set_up_render(fine.shape[2], fine.shape[0], int(samples), cycles_file)
    bpy.ops.render.render(write_still=True)
    print("RESULT " + json.dumps(compare(fine, load(cycles_file))))


main(*sys.argv[sys.argv.index("--") + 1 :])
