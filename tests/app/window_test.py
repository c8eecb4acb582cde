# SPDX-License-Identifier: MIT
"""Opens the game's window under Xvfb, plays it with xdotool and compares screenshots.

window_test.py PROGRAM FOLDER: screenshots and logs stay in FOLDER. Exits with 77 where a tool is missing.
"""
import json
import pathlib
import shutil
import sys
import time

from square_model import square_model
from window_driver import PATIENCE, TOOLS, Game, Screen, brightness, check, difference, redness, run, size_of


def play_cornell(screen, program, folder):
    print("cornell: pictures, panel, keys, sizes", flush=True)
    picture, panel = "330x230+300+60", "200x300+430+30"
    # A method that draws the same whatever was drawn before.
    with Game(screen, program, folder / "cornell", "cornell", "--size", "640x360", "--gi", "rsm_disc") as game:
        game.shot_when("start", "the picture is not black", lambda p: brightness(p, picture) > 0.02)
        lit = game.settled_shot("lit", picture)
        captured = game.capture("--size", "640x360", "--gi", "rsm_disc")
        # The same program on the same rasterizer draws the same, byte for byte. A thousandth allows for rasterizers that
        # differ between a window's context and one without; a wrong frame, size or colour space is far above it.
        check(all(difference(lit, captured, part) < 0.001 for part in ("300x360+340+0", "640x160+0+200")),
              "right of the crosshair and below the texts the window shows what capture draws")

        game.xdotool("key", "F1")
        game.shot_when("panel", "F1 shows the panel", lambda p: difference(lit, p, panel) > 0.1)
        game.xdotool("key", "F1")
        game.shot_when("panel_closed", "F1 hides it", lambda p: difference(lit, p, panel) < 0.01)
        game.xdotool("key", "h")
        game.shot_when("help", "H shows the keys", lambda p: difference(lit, p, "300x200+180+80") > 0.05)
        game.xdotool("key", "h")

        game.xdotool("key", "o")
        game.shot_when("gi_off", "O darkens the picture",
                       lambda p: brightness(p, picture) < 0.9 * brightness(lit, picture))
        game.xdotool("key", "o")
        game.shot_when("gi_on", "O brings the light back", lambda p: difference(lit, p, picture) < 0.01)
        game.switch_to("facets")
        game.switch_to("rsm_disc")
        game.shot_when("methods_round", "G goes round all methods and comes back to the first",
                       lambda p: difference(lit, p, picture) < 0.01)

        game.xdotool("key", "F12")
        saved = game.folder / "out" / "play_0001.png"
        game.wait("F12 saves a picture", lambda: saved.exists() and size_of(saved) == "640x360")

        below = "300x60+150+385"
        game.xdotool("windowsize", game.window, "820", "460")
        game.shot_when("larger", "a larger window is filled", lambda p: brightness(p, below) > 0.01)
        for width, height in ((1, 1), (333, 77), (640, 360)):
            game.xdotool("windowsize", game.window, str(width), str(height))
            time.sleep(0.5)
        game.shot_when("first_size", "the first size gives the first picture",
                       lambda p: difference(lit, p, picture) < 0.01)

        game.xdotool("windowunmap", game.window)
        game.shot_when("hidden", "the window is gone", lambda p: brightness(p, picture) == 0.0)
        game.xdotool("windowmap", game.window)
        game.shot_when("shown_again", "it comes back", lambda p: difference(lit, p, picture) < 0.01)

        game.xdotool("windowfocus", game.window)
        game.xdotool("key", "F11")
        game.wait("F11 fills the screen",
                  lambda: "1024x640" in game.xdotool("getwindowgeometry", game.window))
        game.shot_when("fullscreen", "with a picture", lambda p: brightness(p, "200x200+700+300") > 0.01)
        game.xdotool("key", "F11")
        game.wait("F11 gives the window back",
                  lambda: "640x360" in game.xdotool("getwindowgeometry", game.window))
        game.shot_when("windowed", "with its picture", lambda p: difference(lit, p, picture) < 0.01)
        game.quit()


def play_outdoor(screen, program, folder):
    print("outdoor: mouse and blocks", flush=True)
    picture, middle = "230x200+245+60", "80x80+200+95"
    with Game(screen, program, folder / "outdoor", "outdoor", "--size", "480x270",
              "--set", "sun.azimuth=3.74") as game:  # ahead, so that the walls seen in a hole lie in shade
        game.shot_when("start", "the picture is not black", lambda p: brightness(p, picture) > 0.05)
        game.xdotool("mousemove", "240", "135", "click", "1")
        time.sleep(2.0)
        for _ in range(7):  # the pointer cannot leave the window, and is put back to its middle at each frame
            game.xdotool("mousemove_relative", "--", "0", "60")
            time.sleep(0.6)
        ground = game.settled_shot("ground", middle)

        game.xdotool("click", "1")
        game.shot_when("broken", "left click breaks a block", lambda p: difference(ground, p, middle) > 0.02)
        hole = game.settled_shot("hole", middle)
        # No sun reaches this wall. Light from sunlit sides of the hole makes it 0.017 bright; with maps from before the hole,
        # in which the ground faces away from it, only far-off trees would: 0.005.
        wall = "12x6+228+145"
        game.shot_when("lit", "indirect light comes into the hole", lambda p: brightness(p, wall) > 0.01)
        hole = game.settled_shot("hole", middle)
        game.toggle_gi()
        game.shot_when("hole_gi_off", "without it the hole's wall is black", lambda p: brightness(p, wall) == 0.0)
        game.toggle_gi()
        # As before, but for noise that went on to fade meanwhile.
        game.shot_when("hole_gi_on", "and with it as before", lambda p: difference(hole, p, middle) < 0.005)
        game.xdotool("key", "8")
        game.xdotool("click", "3")
        game.shot_when("placed", "right click places a block", lambda p: difference(hole, p, middle) > 0.02)
        glowing = game.settled_shot("block", middle)

        game.xdotool("keydown", "w")
        time.sleep(0.7)
        game.xdotool("keyup", "w")
        game.shot_when("moved", "W moves the camera", lambda p: difference(glowing, p, picture) > 0.02)
        before_sun = game.settled_shot("before_sun", picture)
        game.xdotool("keydown", "bracketright")
        time.sleep(1.5)
        game.xdotool("keyup", "bracketright")
        game.shot_when("sun", "] turns the sun", lambda p: difference(before_sun, p, picture) > 0.005)

        # Hidden while the mouse is captured: the window loses the focus and must let the mouse go.
        game.xdotool("windowunmap", game.window)
        time.sleep(1.0)
        game.xdotool("windowmap", game.window)
        game.xdotool("windowfocus", game.window)
        time.sleep(1.0)
        still = game.settled_shot("free", picture)
        game.xdotool("mousemove_relative", "--", "60", "-30")
        time.sleep(1.5)
        check(difference(still, game.shot("free_moved"), picture) < 0.005, "without focus the mouse is let go")
        game.quit()


def edit_settings(screen, program, folder):
    print("cornell: a setting is dragged in the panel, undone and done again", flush=True)
    picture, panel = "140x220+110+100", "300x60+300+65"
    with Game(screen, program, folder / "edited", "cornell", "--size", "640x360", "--gi", "rsm_disc") as game:
        game.shot_when("start", "the picture is not black", lambda p: brightness(p, picture) > 0.02)
        game.xdotool("key", "F1")
        game.shot_when("panel", "F1 shows the panel", lambda p: brightness(p, panel) > 0.05)
        before = game.settled_shot("before", picture)
        # The slider of the indirect light's strength, from 1 in small steps to the right, as a hand would.
        game.xdotool("mousemove", "460", "332")
        time.sleep(0.5)
        game.xdotool("mousedown", "1")
        for x in (490, 520, 550):
            time.sleep(0.4)
            game.xdotool("mousemove", str(x), "332")
        time.sleep(0.4)
        game.xdotool("mouseup", "1")
        stronger = lambda p: brightness(p, picture) > 1.2 * brightness(before, picture)
        game.shot_when("stronger", "the slider makes indirect light stronger", stronger)
        game.xdotool("key", "ctrl+z")
        game.shot_when("undone", "one Ctrl+Z undoes the whole drag", lambda p: difference(before, p, picture) < 0.002)
        game.xdotool("key", "ctrl+y")
        game.shot_when("done_again", "Ctrl+Y does it again", stronger)
        game.quit(unsaved=True)


def look_into_the_frame(screen, program, folder):
    print("cornell: the light at one point, and an image of the frame", flush=True)
    picture, table, lines = "140x220+110+100", "200x100+350+190", "100x60+150+300"
    with Game(screen, program, folder / "seen", "cornell", "--size", "640x360", "--gi", "rsm_disc") as game:
        game.shot_when("start", "the picture is not black", lambda p: brightness(p, picture) > 0.02)
        game.xdotool("key", "F1")
        game.shot_when("panel", "F1 shows the panel", lambda p: brightness(p, table) > 0.02)
        game.click(435, 60)
        before = game.settled_shot("before", table)
        game.click(200, 350)
        game.shot_when("measured", "a click measures a point: a table and lines",
                       lambda p: difference(before, p, table) > 0.02 and difference(before, p, lines) > 0.005)
        game.click(495, 83)
        game.click(440, 118)
        game.shot_when("image", "the chosen image covers the picture", lambda p: difference(before, p, picture) > 0.05)
        game.quit()


def compare_sides(screen, program, folder):
    print("cornell: live light beside the path-traced truth, and the bar between them is dragged", flush=True)
    left, right, tab = "50x60+60+250", "60x90+140+230", "200x60+270+160"
    with Game(screen, program, folder / "compared", "cornell", "--size", "640x360", "--gi", "rsm_disc") as game:
        game.shot_when("start", "the picture is not black", lambda p: brightness(p, right) > 0.02)
        game.xdotool("key", "F1")
        game.shot_when("panel", "F1 shows the panel", lambda p: brightness(p, tab) > 0.02)
        game.click(385, 60)
        before = game.settled_shot("before", right)
        game.click(272, 83)
        # The panel hides the middle: the bar stands in the middle of what it leaves free, at 128.
        game.shot_when("compared", "right of the bar is the truth, and left of it the live light",
                       lambda p: difference(before, p, right) > 0.03 and difference(before, p, left) < 0.005)
        game.xdotool("mousemove", "128", "300")
        time.sleep(0.7)
        game.xdotool("mousedown", "1")
        for x in (150, 180, 220):
            time.sleep(0.4)
            game.xdotool("mousemove", str(x), "300")
        time.sleep(0.4)
        game.xdotool("mouseup", "1")
        game.shot_when("dragged", "the bar is dragged past it: there is live light", lambda p: difference(before, p, right) < 0.01)
        game.quit()


def play_broken_shaders(screen, program, folder):
    print("cornell: a shader is broken and mended while playing", flush=True)
    shaders = folder / "shader"
    shutil.rmtree(shaders, ignore_errors=True)
    shutil.copytree(pathlib.Path(__file__).parents[2] / "shader", shaders)
    tonemap = shaders / "passes" / "tonemap.frag"
    good = tonemap.read_text()
    screen.env["SECONDLIGHT_SHADERS"] = str(shaders)
    picture, message = "200x120+300+100", "400x40+10+315"
    with Game(screen, program, folder / "shaders", "cornell", "--size", "640x360", "--gi", "rsm_disc") as game:
        game.shot_when("start", "the picture is not black", lambda p: brightness(p, picture) > 0.02)
        lit = game.settled_shot("lit", message)
        tonemap.write_text(good.replace("void main", "void broken_main"))
        game.shot_when("broken", "the error is shown", lambda p: difference(lit, p, message) > 0.05)
        check(difference(lit, game.shot("last_good"), picture) < 0.01, "over the last good picture")
        tonemap.write_text(good)
        game.shot_when("mended", "and goes away when it is mended", lambda p: difference(lit, p, message) < 0.01)

        # A program that was never good: there is no picture until somebody writes the file again.
        gather = shaders / "gi" / "rsm_grid.frag"
        good = gather.read_text()
        gather.write_text("#error broken")
        time.sleep(1.0)
        game.switch_to("rsm_grid")
        game.shot_when("never_good", "a shader that was never good gives no picture",
                       lambda p: brightness(p, "200x60+300+60") == 0.0)
        game.switch_to("rsm_disc")
        game.shot_when("other_method", "another method gives one again",
                       lambda p: difference(lit, p, picture) < 0.01)
        game.switch_to("rsm_grid")
        gather.write_text(good)
        game.shot_when("mended_again", "mended, it gives one too", lambda p: brightness(p, "200x60+300+60") > 0.02)
        game.xdotool("windowfocus", game.window)
        game.xdotool("key", "ctrl+q")
        check(game.process.wait(PATIENCE) == 0, "it ends with code 0")
        bad = [line for line in game.log().splitlines() if "OpenGL:" in line]
        check(not bad, f"the driver saw no error {bad}")
    del screen.env["SECONDLIGHT_SHADERS"]


def play_without_camera(screen, program, folder):
    print("empty: no camera", flush=True)
    with Game(screen, program, folder / "empty", "empty", "--size", "640x360", "--set", "camera.active=false") as game:
        game.shot_when("message", "the window says why it is empty", lambda p: brightness(p, "400x40+120+160") > 0.01)
        game.quit()


def keep_a_world(screen, program, folder):
    print("world: a block is broken, the game killed, and the block is still broken", flush=True)
    world, flags = folder / "kept.world", ("--size", "480x270", "--set", "sun.azimuth=3.74")
    world.unlink(missing_ok=True)
    # Beside it is the outline of the block behind, which is only there while the mouse is captured.
    middle, beside_outline = "80x80+200+95", "20x20+206+122"
    with Game(screen, program, folder / "world", "outdoor", "--world", world, "--new", *flags) as game:
        game.xdotool("mousemove", "240", "135", "click", "1")
        time.sleep(2.0)
        for _ in range(4):
            game.xdotool("mousemove_relative", "--", "0", "60")
            time.sleep(0.6)
        ground = game.settled_shot("ground", middle)
        game.xdotool("click", "1")
        game.shot_when("broken", "left click breaks a block", lambda p: difference(ground, p, middle) > 0.02)
        time.sleep(2.0)  # the place of the player is saved each second
        hole = game.settled_shot("hole", middle)
        check(difference(ground, hole, beside_outline) > 0.05, "the hole can be seen where the pictures are compared")
        done = run(program, "play", "--world", world, env=screen.env)
        check(done.returncode == 1 and "another process" in done.stderr, f"a second game in this world is refused ({done.stderr.strip()})")
        game.kill()
    with Game(screen, program, folder / "world_again", None, "--world", world, *flags) as game:
        game.shot_when("again", "after a kill the hole is there, and the player where it was", lambda p: difference(hole, p, beside_outline) < 0.02)
        game.quit()
    world.write_bytes(b"no world" * 100)
    done = run(program, "play", "--world", world, env=screen.env)
    check(done.returncode == 1 and str(world) in done.stderr and "no world" in done.stderr, f"what is no world is refused ({done.stderr.strip()})")


def change_settings(screen, program, folder):
    print("menu: it stops the game, and what is changed in it is kept", flush=True)
    settings, picture = pathlib.Path(screen.env["XDG_CONFIG_HOME"]) / "secondlight" / "settings.json", "100x30+200+328"
    broken = settings.with_name("settings.json.broken")
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text('{"secondlight_settings": 1, "controls": {"mouse_sensitivity": "high"}}')
    with Game(screen, program, folder / "menu", "cornell", "--size", "640x360", "--gi", "off") as game:
        lit = game.settled_shot("lit", picture)
        check("/controls/mouse_sensitivity" in game.log() and not broken.exists(), "a wrong setting is told, and its file left alone")
        game.xdotool("key", "Escape")
        menu = game.shot_when("menu", "Escape opens the menu", lambda p: brightness(p, picture) < 0.8 * brightness(lit, picture))
        for key in ("Down", "Down", "Return"):  # to the settings
            game.xdotool("key", key)
            time.sleep(0.5)
        page = game.shot_when("settings", "it leads to the settings", lambda p: difference(menu, p, "500x300+70+30") > 0.02)
        for key in ("Down", "Down", "space", "Right", "Right", "Right"):  # past Keys and Back, to the sensitivity of the mouse
            game.xdotool("key", key)
            time.sleep(0.5)
        game.xdotool("key", "space")
        game.shot_when("changed", "a setting is changed with the keyboard", lambda p: difference(page, p, "300x60+250+100") > 0.01)
        game.wait("the wrong file is kept", broken.exists)
        for key in ("Escape", "Escape"):
            game.xdotool("key", key)
            time.sleep(0.5)
        game.shot_when("resumed", "and Escape leads back into the game", lambda p: difference(lit, p, picture) < 0.01)
        game.quit()
    sensitivity = json.loads(settings.read_text())["controls"]["mouse_sensitivity"]
    check(1 < sensitivity <= 10, f"the file has the new value ({sensitivity})")
    settings.unlink()


def change_worlds(screen, program, folder):
    print("menu: another world is made and played, and the first one again", flush=True)
    worlds = pathlib.Path(screen.env["XDG_DATA_HOME"]) / "secondlight" / "worlds"
    shutil.rmtree(worlds, ignore_errors=True)
    worlds.mkdir(parents=True)
    (worlds / "Damaged.world").write_bytes(b"no world" * 100)
    with Game(screen, program, folder / "worlds", None, "--size", "640x360") as game:

        def is_played(name):
            return (worlds / f"{name}.world-wal").exists()  # only then its log lies beside it

        def choose(*keys):
            for key in keys:
                game.xdotool("key", key)
                time.sleep(0.7)

        game.wait("the game begins in the valley", lambda: is_played("valley"))
        game.shot_when("valley", "which is drawn", lambda p: brightness(p, "200x100+400+120") > 0.05)
        choose("Escape", "Down", "Return", "Return", "Return")  # worlds, a new one, with the name and scene that are proposed
        game.wait("a new world is played", lambda: is_played("World 1"))
        check(not is_played("valley"), "and the first one is closed")
        time.sleep(2.0)
        choose("Escape", "Down", "Return", "Down", "Down", "Down", "Return")  # past New world, Back and the one that is played
        game.wait("the first one is played again", lambda: is_played("valley") and not is_played("World 1"))
        game.shot_when("again", "and drawn", lambda p: brightness(p, "200x100+400+120") > 0.05)
        game.quit()
    check((worlds / "Damaged.world").read_bytes() == b"no world" * 100, "a damaged world was left as it is")


def refuse(screen, program):
    print("no window to be had", flush=True)
    blind = {key: value for key, value in screen.env.items() if key != "DISPLAY"}
    done = run(program, "play", env=blind)
    check(done.returncode == 1 and "tour" in done.stderr, f"without a display play says what to do ({done.stderr.strip()})")
    done = run(program, "--context", "egl", "play", env=screen.env)
    check(done.returncode == 1 and "window" in done.stderr, f"nor does it open without one ({done.stderr.strip()})")


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


def main():
    program, folder = str(pathlib.Path(sys.argv[1]).absolute()), pathlib.Path(sys.argv[2]).absolute()
    missing = [tool for tool in TOOLS if not shutil.which(tool)]
    if missing:
        print(f"skipped: install {', '.join(missing)} (packages xvfb, xdotool, imagemagick)")
        return 77
    with Screen() as screen:
        screen.env["XDG_DATA_HOME"] = str(folder / "data")
        screen.env["XDG_CONFIG_HOME"] = str(folder / "config")
        shutil.rmtree(folder / "config", ignore_errors=True)
        refuse(screen, program)
        play_cornell(screen, program, folder)
        edit_settings(screen, program, folder)
        look_into_the_frame(screen, program, folder)
        compare_sides(screen, program, folder)
        play_outdoor(screen, program, folder)
        play_broken_shaders(screen, program, folder)
        play_without_camera(screen, program, folder)
        keep_a_world(screen, program, folder)
        change_settings(screen, program, folder)
        change_worlds(screen, program, folder)
        open_files(screen, program, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
