# SPDX-License-Identifier: MIT
"""Drops files onto a window as a file manager does (XDND version 5): drop_files.py WINDOW FILE..."""
import pathlib
import sys
import time

from Xlib import X, display
from Xlib.protocol import event

PATIENCE = 60.0  # s; a frame of a software rasterizer is long


def main():
    screen = display.Display()
    target = screen.create_resource_object("window", int(sys.argv[1]))
    source = screen.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
    atom = screen.intern_atom
    selection, uri_list, copy = atom("XdndSelection"), atom("text/uri-list"), atom("XdndActionCopy")
    uris = "".join(pathlib.Path(file).absolute().as_uri() + "\r\n" for file in sys.argv[2:]).encode()
    source.set_selection_owner(selection, X.CurrentTime)

    def tell(name, *words):
        data = (32, [source.id, *words] + [0] * (4 - len(words)))
        target.send_event(event.ClientMessage(window=target, client_type=atom(name), data=data))
        screen.flush()

    place = target.translate_coords(screen.screen().root, 0, 0)
    tell("XdndEnter", 5 << 24, uri_list)
    tell("XdndPosition", 0, ((40 - place.x) << 16) | (40 - place.y), X.CurrentTime, copy)
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if not screen.pending_events():
            time.sleep(0.05)
            continue
        message = screen.next_event()
        if message.type == X.SelectionRequest:
            message.requestor.change_property(message.property, message.target, 8, uris)
            message.requestor.send_event(event.SelectionNotify(time=message.time, requestor=message.requestor, selection=message.selection,
                                                               target=message.target, property=message.property))
            screen.flush()
        elif message.type == X.ClientMessage and message.client_type == atom("XdndStatus"):
            if not message.data[1][1] & 1:
                sys.exit("the window takes no files")
            tell("XdndDrop", 0, X.CurrentTime)
        elif message.type == X.ClientMessage and message.client_type == atom("XdndFinished"):
            return
    sys.exit("the window does not answer")


main()
