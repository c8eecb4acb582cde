# SPDX-License-Identifier: MIT
"""The panel in the game's window: settings, what lies under the picture, and comparing."""
import time

from window_driver import Game, brightness, difference


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
