#!/usr/bin/env python3
"""Drops a file on a window as a file browser does (XDND version 3, which JUCE knows).

    drop_file.py WINDOW X Y FILE

X and Y are places of the window. Exits with 0 when the window has taken the file. Needs
python3-xlib.
"""
import pathlib
import sys
import time

from Xlib import X, Xatom, display
from Xlib.protocol import event

PATIENCE_SECONDS = 10


class Drop:
    def __init__(self, window_id, path):
        self.display = display.Display()
        self.root = self.display.screen().root
        self.target = self.display.create_resource_object("window", window_id)
        self.source = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.data = pathlib.Path(path).resolve().as_uri().encode() + b"\r\n"
        self.uri_list = self.atom("text/uri-list")
        self.source.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)

    def atom(self, name):
        return self.display.intern_atom(name)

    def send(self, name, *words):
        message = event.ClientMessage(
            window=self.target, client_type=self.atom(name),
            data=(32, [self.source.id, *words, *[0] * (4 - len(words))]))
        self.target.send_event(message)
        self.display.flush()

    def wait_for(self, name):
        """Waits for a message and serves the data meanwhile. Returns the words of the message."""
        until = time.monotonic() + PATIENCE_SECONDS
        while time.monotonic() < until:
            while self.display.pending_events():
                happened = self.display.next_event()
                if happened.type == X.SelectionRequest:
                    self.serve(happened)
                elif (happened.type == X.ClientMessage
                      and happened.client_type == self.atom(name)):
                    return happened.data[1]
            time.sleep(0.01)
        sys.exit(f"The window did not answer with {name}.")

    def serve(self, request):
        if request.target == self.uri_list:
            request.requestor.change_property(request.property, self.uri_list, 8, self.data)
        elif request.target == self.atom("TARGETS"):
            request.requestor.change_property(request.property, Xatom.ATOM, 32, [self.uri_list])
        request.requestor.send_event(event.SelectionNotify(
            time=request.time, requestor=request.requestor, selection=request.selection,
            target=request.target, property=request.property))
        self.display.flush()

    def at(self, x, y):
        corner = self.root.translate_coords(self.target, 0, 0)
        place = ((corner.x + x) << 16) | (corner.y + y)
        copy = self.atom("XdndActionCopy")
        self.send("XdndEnter", 3 << 24, self.uri_list)
        accepted = 0
        for _ in range(3):  # the first reply may find the window still asking for the data
            self.send("XdndPosition", 0, place, X.CurrentTime, copy)
            accepted = self.wait_for("XdndStatus")[1] & 1
            time.sleep(0.1)
        if not accepted:
            sys.exit("The window does not take the file.")
        self.send("XdndDrop", 0, X.CurrentTime)
        self.wait_for("XdndFinished")


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    Drop(int(sys.argv[1], 0), sys.argv[4]).at(int(sys.argv[2]), int(sys.argv[3]))
