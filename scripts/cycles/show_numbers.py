"""The numbers of a show that a picture of it by Cycles needs; what Cycles cannot draw alike is refused."""

import tomllib

PHASE_OF_ONE_LOBE = "haze.phase must be one lobe, {g = ...}: Cycles' Volume Scatter has no second one"


class NotComparable(Exception):
    """A show that Cycles would not draw by the same equations."""


def require(condition, why):
    if not condition:
        raise NotComparable(why)


def read_haze(haze):
    extinction = haze.get("extinction", 0.01)
    require("g" in haze.get("phase", {}), PHASE_OF_ONE_LOBE)
    require(haze.get("noise", 0) == 0, "haze.noise must be 0")
    require(not haze.get("delta_eddington", False), "haze.delta_eddington must be false")
    return {"extinction": extinction, "scattering": haze.get("scattering", extinction), "g": haze["phase"]["g"]}


def read_light(light):
    require("candela" in light, "the light must be given in candela")
    require("gobo" not in light, "a light with a gobo is not compared")
    require(light.get("lens_radius", 0) == 0, "lens_radius must be 0: a spot of Cycles is a point")
    profile = light.get("profile", "flat")
    require(profile in ("flat", "soft"), f"profile '{profile}' is not compared")
    require(light["half_angle"] < 85, "half_angle must be below 85 degrees: a spot of Cycles ends at 90")
    if "target" in light:
        direction = [t - p for t, p in zip(light["target"], light["position"])]
    else:
        direction = light["direction"]
    return {
        "position": light["position"],
        "direction": direction,
        "candela": light["candela"],
        "half_angle": light["half_angle"],
        "beam_half_angle": light["beam_half_angle"] if profile == "soft" else None,
        "color": light.get("color", [1, 1, 1]),
    }


def read_floor(thing):
    require(thing["type"] == "floor", f"objects must be floors, not '{thing['type']}'")
    require("rotation" not in thing, "a floor must not be turned")
    require(thing.get("specular", 0.04) == 0, "specular must be 0: only diffuse reflection is the same everywhere")
    return {
        "position": thing.get("position", [0, 0, 0]),
        "size": thing.get("size", [20, 20]),
        "albedo": thing.get("albedo", thing.get("color", [0.5, 0.5, 0.5])),
    }


def read_show(file, camera_name):
    """Haze, lights, floors and the camera of that name. Raises NotComparable."""
    with open(file, "rb") as stream:
        show = tomllib.load(stream)
    require("fixture" not in show, "fixtures are not compared, bare lights are")
    require("ambient" not in show and "background" not in show, "the room must be dark but for its lights")
    cameras = {camera["name"]: camera for camera in show.get("camera", [])}
    require(camera_name in cameras, f"there is no camera '{camera_name}'")
    return {
        "haze": read_haze(show.get("haze", {})),
        "lights": [read_light(light) for light in show.get("light", [])],
        "floors": [read_floor(thing) for thing in show.get("object", [])],
        "camera": cameras[camera_name],
    }
