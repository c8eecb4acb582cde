# SPDX-License-Identifier: MIT
"""Worlds and settings that outlast the game's window."""
import json
import pathlib
import shutil
import time

from window_driver import Game, brightness, check, difference, run


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
