# SPDX-License-Identifier: MIT
"""A display of its own (Xvfb), the game on it driven with xdotool, and what screenshots (ImageMagick) show."""
import os
import pathlib
import shutil
import subprocess
import time

TOOLS = ("Xvfb", "xdotool", "import", "compare", "convert", "identify")
PATIENCE = 90.0  # s; a software rasterizer on a busy machine is slow


def run(*command, env=None, timeout=60):
    return subprocess.run(command, env=env, timeout=timeout, capture_output=True, text=True)


def check(condition, sentence):
    if not condition:
        raise AssertionError(sentence)
    print(f"  {sentence}: yes", flush=True)


class Screen:
    """A display of its own."""

    def __init__(self):
        reader, writer = os.pipe()
        # Without -noreset the server starts anew when its last window goes, and refuses who comes meanwhile.
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1024x640x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise RuntimeError("Xvfb does not start")
        self.env = {**os.environ, "DISPLAY": f":{number}", "LIBGL_ALWAYS_SOFTWARE": "1"}
        self.env.pop("WAYLAND_DISPLAY", None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Game:
    """A running game; `part` of a screenshot is WIDTHxHEIGHT+LEFT+TOP."""

    def __init__(self, screen, program, folder, scene, *flags):
        self.env, self.program, self.folder, self.scene, self.shots = screen.env, program, folder, scene, 0
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.log_path = self.folder / "log.txt"
        with open(self.log_path, "w") as log:
            self.process = subprocess.Popen([program, "play", *(["--scene", scene] if scene else []), "--no-vsync", *flags],
                                            cwd=self.folder, env=self.env, stdout=log, stderr=log)
        self.window = self.wait("a window opens", self.find_window)
        self.xdotool("windowfocus", self.window)

    def find_window(self):
        found = run("xdotool", "search", "--onlyvisible", "--name", "^Secondlight", env=self.env).stdout.split()
        return found[0] if found else None

    def xdotool(self, *words):
        done = run("xdotool", *words, env=self.env)
        if done.returncode != 0:
            raise AssertionError(f"xdotool {' '.join(words)}: {done.stderr.strip()}")
        return done.stdout

    def click(self, x, y):
        """Into the panel or the picture, slowly enough for widgets to notice the pointer first."""
        self.xdotool("mousemove", str(x), str(y))
        time.sleep(0.7)
        self.xdotool("click", "1")
        time.sleep(0.7)

    def toggle_gi(self):
        """O, and waits until the log tells of it."""
        before = self.log().count("GI: ")
        self.xdotool("key", "o")
        self.wait("O switches indirect light", lambda: self.log().count("GI: ") > before)

    def methods(self):
        """Names of all GI methods, in the order of G."""
        return [line.split()[0] for line in run(self.program, "list", "methods").stdout.splitlines() if line[:1].isalpha()]

    def switch_to(self, method):
        """G until the log tells of `method`; each only when the last was told, for two taps within one frame are one."""
        for _ in self.methods():
            before = self.log().count("GI: ")
            self.xdotool("key", "g")
            self.wait("G changes the method", lambda: self.log().count("GI: ") > before)
            if self.log().rpartition("GI: ")[2].split()[0] == method:
                return
        raise AssertionError(f"G does not lead to {method}")

    def wait(self, sentence, condition, patience=PATIENCE):
        end = time.monotonic() + patience
        while True:
            value = condition()
            if value:
                print(f"  {sentence}: yes", flush=True)
                return value
            if self.process.poll() is not None:
                raise AssertionError(f"the game ended with {self.process.returncode} while waiting for: {sentence}\n"
                                     + self.log())
            if time.monotonic() > end:
                raise AssertionError(f"{sentence}: not within {patience:.0f} s; see {self.folder}")
            time.sleep(0.2)

    def shot(self, name):
        self.shots += 1
        path = str(self.folder / f"{self.shots:02}_{name}.png")
        done = run("import", "-silent", "-window", "root", path, env=self.env)
        if done.returncode != 0:
            raise AssertionError(f"import: {done.stderr.strip()}")
        return path

    def capture(self, *flags):
        """The scene as it is at its start, drawn without a window."""
        path = str(self.folder / "captured.png")
        done = run(self.program, "capture", "--scene", self.scene, "-o", path, *flags, env=self.env)
        check(done.returncode == 0, f"capture draws '{self.scene}' ({done.stderr.strip()[-300:]})")
        return path

    def shot_when(self, name, sentence, condition):
        """The first screenshot that satisfies the condition; the ones before it are not kept."""
        def attempt():
            path = self.shot(name)
            if condition(path):
                return path
            self.shots -= 1
            return None
        return self.wait(sentence, attempt)

    def settled_shot(self, name, part):
        """A screenshot taken when nothing moves any more: texts fade and frames are late."""
        previous = self.shot(name)

        def attempt():
            nonlocal previous
            time.sleep(0.7)
            self.shots -= 1
            latest = self.shot(name + "_")
            same = difference(previous, latest, part) == 0.0
            os.replace(latest, previous)
            return previous if same else None
        return self.wait(f"'{name}' stands still", attempt)

    def drop(self, *files):
        """Files from a file manager; Debian's own Python knows the package python3-xlib."""
        script = pathlib.Path(__file__).with_name("drop_files.py")
        done = run("/usr/bin/python3", str(script), self.window, *map(str, files), env=self.env, timeout=PATIENCE)
        check(done.returncode == 0, f"the window takes {files[0].name} ({done.stderr.strip()[-300:]})")

    def quit(self, unsaved=False, expected_errors=()):
        self.xdotool("windowfocus", self.window)
        self.xdotool("key", "ctrl+q")
        if unsaved:
            self.wait("what no file holds is not left at once", lambda: "nothing was left" in self.log())
            self.xdotool("key", "ctrl+q")
        code = self.process.wait(PATIENCE)
        log = self.log()
        check(code == 0, f"Ctrl+Q ends '{self.scene}' with code 0 (got {code}; {log.strip()[-300:]})")
        bad = [line for line in log.splitlines() if "error" in line.lower() and not any(text in line for text in expected_errors)]
        check(not bad, f"its log has no errors {bad}")

    def kill(self):
        """As a crash or a power cut of the program would end it."""
        self.process.kill()
        self.process.wait(PATIENCE)

    def log(self):
        return self.log_path.read_text()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


def brightness(path, part):
    """Mean grey of a part of a picture, 0 to 1."""
    out = run("convert", path, "-crop", part, "+repage", "-colorspace", "Gray", "-format", "%[fx:mean]", "info:")
    return float(out.stdout)


def redness(path, part):
    """Mean of red less green in a part of a picture, -1 to 1."""
    out = run("convert", path, "-crop", part, "+repage", "-format", "%[fx:mean.r-mean.g]", "info:")
    return float(out.stdout)


def difference(one, other, part):
    """Root mean square difference of a part of two pictures, 0 to 1."""
    out = run("compare", "-metric", "RMSE", "-extract", part, one, other, "null:").stderr
    return float(out[out.index("(") + 1:out.index(")")])


def size_of(path):
    return run("identify", "-format", "%wx%h", str(path)).stdout
