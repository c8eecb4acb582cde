# SPDX-License-Identifier: MIT
"""Installs the program and the engine, moves them elsewhere, runs the one and builds example/ on the other.

installed_test.py BUILD SOURCE COMPILER: everything is made in a temporary folder, which stays where something fails.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

build, source, compiler = (pathlib.Path(argument) for argument in sys.argv[1:])
folder = pathlib.Path(tempfile.mkdtemp(prefix="secondlight_installed_"))
environment = {name: value for name, value in os.environ.items() if not name.startswith("SECONDLIGHT_")}


def run(*command):
    """Standard output of a command that must succeed."""
    done = subprocess.run([str(part) for part in command], cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def check(holds, sentence):
    print(("ok: " if holds else "FAILED: ") + sentence, flush=True)
    if not holds:
        sys.exit(f"see {folder}")


class Picture:
    def __init__(self, file):
        self.width, self.height = map(int, run("identify", "-format", "%w %h", file).split())
        self.bytes = subprocess.run(["convert", str(file), "-depth", "8", "rgb:-"], check=True, capture_output=True).stdout

    def pixel(self, x, y):
        at = 3 * (y * self.width + x)
        return tuple(self.bytes[at:at + 3])


def shown(radiance, ev100):
    """What a PNG holds of a radiance (nit): shader/shared/tonemap.h in other words."""
    def channel(nit):
        x = 0.6 * nit / (1.2 * 2**ev100)
        linear = min(max(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0), 1.0)
        return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear**(1 / 2.4) - 0.055)
    return tuple(channel(nit) for nit in radiance)


def near(pixel, radiance):
    """Within two levels: the G-buffer keeps albedo in 8 bits."""
    return all(abs(a - b) <= 2 for a, b in zip(pixel, shown(radiance, ev100=11)))


def install():
    run("cmake", "--install", build, "--prefix", folder / "first")
    prefix = folder / "moved elsewhere"
    (folder / "first").rename(prefix)
    told = [file for file in prefix.rglob("*") if file.suffix in (".cmake", ".h") and str(source) in file.read_text(encoding="utf-8")]
    check(not told, f"no header and no CMake file names the source folder {told}")
    return prefix


def program_runs_from_its_prefix(prefix):
    program, data = prefix / "bin/secondlight", prefix / "share/secondlight"
    shutil.copy(data / "game/scenes/cornell.json", data / "game/scenes/own_scene.json")
    check("own_scene" in run(program, "list", "scenes"), "the program lists the scenes of its prefix")
    shader = data / "shader/passes/tonemap.frag"
    text = shader.read_text()
    shader.write_text("nonsense\n")
    refused = subprocess.run([program, "capture", "--scene", "own_scene", "--gi", "off", "-o", folder / "own.png"],
                             cwd=folder, env=environment, capture_output=True, text=True, check=False)
    check(refused.returncode != 0 and "passes/tonemap.frag" in refused.stderr, "and reads the shaders of its prefix")
    shader.write_text(text)
    run(program, "capture", "--scene", "own_scene", "--gi", "rsm_disc", "--size", "64x64", "-o", folder / "own.png")
    check(sum(Picture(folder / "own.png").pixel(32, 32)) > 60, "with which it draws")


def only_its_own_version_is_found(prefix):
    asked = folder / "versions"
    asked.mkdir()
    (asked / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(versions LANGUAGES NONE)\n"
        "find_package(Secondlight 0.2 QUIET)\nmessage(STATUS \"found ${Secondlight_FOUND}, looked at ${Secondlight_CONSIDERED_VERSIONS}\")\n")
    said = run("cmake", "-S", asked, "-B", asked / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    check("found 0, looked at 0.1.0" in said, "version 0.2 is asked for and not found")


def example_draws(prefix):
    example = folder / "example"
    shutil.copytree(source / "example", example)
    run("cmake", "-S", example, "-B", example / "build", f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={compiler}",
        "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    command = json.loads((example / "build/compile_commands.json").read_text())[0]["command"]
    ours = [flag for flag in ("-Werror", "-Wall", "-march", "-fsanitize", "-ffp-contract", "cmake_pch") if flag in command]
    check(not ours, f"flags of ours do not reach programs that use the engine {ours}")
    check("GLM_FORCE_DEPTH_ZERO_TO_ONE" in command, "what changes the meaning of headers does")
    run("cmake", "--build", example / "build")
    run(example / "build/hemisphere", example / "scene.json", folder / "example.png")
    picture = Picture(folder / "example.png")
    floor, block = (750, 1000, 1500), (0.8 * 950, 0.05 * 1150, 0.05 * 1600)
    check(near(picture.pixel(160, 170), floor), f"GI method: the floor has the light of the sky above it {picture.pixel(160, 170)}")
    check(near(picture.pixel(240, 125), block), f"component and system: after a second the block is on the right {picture.pixel(240, 125)}")
    check(near(picture.pixel(80, 125), floor), f"and no longer on the left {picture.pixel(80, 125)}")
    check(near(picture.pixel(160, 10), (300, 700, 2500)), f"pass: the sky above is blue {picture.pixel(160, 10)}")
    red, green, blue = picture.pixel(160, 88)
    check(red > green > blue, f"and orange at the horizon {red, green, blue}")


prefix = install()
program_runs_from_its_prefix(prefix)
only_its_own_version_is_found(prefix)
example_draws(prefix)
shutil.rmtree(folder)
