# SPDX-License-Identifier: MIT
"""Models and scene files in the game's window, from the command line and dropped onto it."""
import json
import struct
import time

from square_model import square_model
from window_driver import PATIENCE, Game, check, redness, run


def open_files(screen, program, folder):
    print("models: from the command line, and dropped onto the window", flush=True)
    middle, files = "100x60+190+105", folder / "files"
    files.mkdir(parents=True, exist_ok=True)
    red, broken = square_model(files / "red.gltf", (0.9, 0.05, 0.05)), files / "broken.glb"
    broken.write_bytes(b"glTF but nothing more")
    done = run(program, "play", str(broken), env=screen.env, timeout=PATIENCE)
    check(done.returncode == 1 and "broken.glb" in done.stderr, f"a broken model ends the game with its name ({done.stderr.strip()[-200:]})")
    with Game(screen, program, folder / "models", str(red), "--size", "480x270") as game:
        game.shot_when("red", "the red square is seen, in the sun", lambda p: redness(p, middle) > 0.2)
        game.drop(files / "broken.glb")
        game.wait("the log tells what is wrong with it", lambda: "broken.glb" in game.log())
        game.shot_when("still_red", "and the square stays", lambda p: redness(p, middle) > 0.2)
        game.drop(square_model(files / "green.gltf", (0.05, 0.9, 0.05)))
        game.shot_when("green", "a green square takes its place", lambda p: redness(p, middle) < -0.2)
        game.drop(scene_with(files / "scene.json", "red.gltf"))
        game.shot_when("scene", "then a scene file that shows the red one", lambda p: redness(p, middle) > 0.2)
        game.drop(scene_with(files / "wrong.json", "nowhere.gltf"))
        game.wait("a scene whose model is not there is told", lambda: "nowhere.gltf" in game.log())
        game.shot_when("still_scene", "and changes nothing", lambda p: redness(p, middle) > 0.2)
        game.quit(expected_errors=("broken.glb", "nowhere.gltf"))
    with Game(screen, program, folder / "models", str(files / "scene.json"), "--size", "480x270") as game:
        game.shot_when("from_the_start", "a scene file with a model opens from the command line", lambda p: redness(p, middle) > 0.2)
        game.quit()
    done = run(program, "play", str(files / "wrong.json"), env=screen.env, timeout=PATIENCE)
    check(done.returncode == 1 and "nowhere.gltf" in done.stderr, f"without its model a scene ends the game ({done.stderr.strip()[-200:]})")


def scene_with(path, model):
    """A scene file with a camera before a model, and a sun behind it."""
    path.write_text(json.dumps({"secondlight_scene": 1, "entities": [
        {"name": "camera", "transform": {"translation": [0, 0, 2]}, "camera": {"auto_exposure": True}},
        {"name": "sun", "transform": {}, "directional_light": {}, "sun": {"azimuth": 3.5, "elevation": 0.5}},
        {"name": "sky", "sky": {}}, {"name": "square", "transform": {}, "model": {"file": model}}]}))
    return path


def let_the_last_drop_win(screen, program, folder):
    print("models: what is dropped while another one is still being read", flush=True)
    middle, files = "100x60+190+105", folder / "files_in_turn"
    files.mkdir(parents=True, exist_ok=True)
    slow, plain = slow_model(files / "slow.gltf", (0.9, 0.05, 0.05)), scene_without_models(files / "plain.json")
    red = lambda p: redness(p, middle) > 0.2
    with Game(screen, program, folder / "drops", "empty", "--size", "480x270") as game:
        began = time.monotonic()
        game.drop(slow)
        game.shot_when("slow", "a slow model comes", red)
        seconds = time.monotonic() - began
        game.drop(plain)
        game.shot_when("plain", "a scene without models takes its place", lambda p: redness(p, middle) < -0.2)
        game.drop(slow)
        game.drop(plain)
        # The model would be there by then.
        time.sleep(2.0 * seconds)
        check(redness(game.shot("still_plain"), middle) < -0.2, "dropped while the model is read again, it stays")
        game.quit()


def scene_without_models(path):
    """A scene file with a camera before a green box, and a sun behind it."""
    path.write_text(json.dumps({"secondlight_scene": 1, "entities": [
        {"name": "camera", "transform": {"translation": [0, 0, 2]}, "camera": {"auto_exposure": True}},
        {"name": "sun", "transform": {}, "directional_light": {}, "sun": {"azimuth": 3.5, "elevation": 0.5}},
        {"name": "sky", "sky": {}},
        {"name": "box", "transform": {"translation": [0, 0, -1]}, "shape": {"kind": "box", "size": [2, 2, 2]}, "material": {"base_colour": [0.05, 0.9, 0.05]}}]}))
    return path


def slow_model(path, colour):
    """A square, beside a mesh of a million others that no node shows and that takes seconds to read."""
    model = json.loads(square_model(path, colour).read_text())
    data = struct.pack("<18f", -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0) * 1_000_000
    path.with_suffix(".bin").write_bytes(data)
    model["buffers"].append({"byteLength": len(data), "uri": path.with_suffix(".bin").name})
    model["bufferViews"].append({"buffer": 1, "byteLength": len(data)})
    model["accessors"].append({"bufferView": 2, "componentType": 5126, "count": len(data) // 12, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]})
    model["meshes"].append({"primitives": [{"attributes": {"POSITION": 2}}]})
    path.write_text(json.dumps(model))
    return path
