# SPDX-License-Identifier: MIT
"""Opens the game's window under Xvfb, plays it with xdotool and compares screenshots.

window_test.py PROGRAM FOLDER: screenshots and logs stay in FOLDER. Exits with 77 where a tool is missing.
"""
import pathlib
import shutil
import sys
import time

from window_driver import PATIENCE, TOOLS, Game, Screen, brightness, check, difference, run, size_of
from window_files import let_the_last_drop_win, open_files
from window_panel import compare_sides, edit_settings, look_into_the_frame
from window_worlds import change_settings, change_worlds, keep_a_world


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


def refuse(screen, program):
    print("no window to be had", flush=True)
    blind = {key: value for key, value in screen.env.items() if key != "DISPLAY"}
    done = run(program, "play", env=blind)
    check(done.returncode == 1 and "tour" in done.stderr, f"without a display play says what to do ({done.stderr.strip()})")
    done = run(program, "--context", "egl", "play", env=screen.env)
    check(done.returncode == 1 and "window" in done.stderr, f"nor does it open without one ({done.stderr.strip()})")


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
        let_the_last_drop_win(screen, program, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
