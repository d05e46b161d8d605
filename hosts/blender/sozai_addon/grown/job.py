# SPDX-License-Identifier: Apache-2.0
"""`sozai grow` beside Blender: how far it is, cancelling it, and what it wrote. No part of
Blender is used here."""
import os
import re
import shutil
import subprocess
import tempfile
import threading

from ..program import Problem

try:
    import pty  # the program draws its bar on terminals alone
except ImportError:
    pty = None

CLEARED = re.compile(rb"\r(?:\x1b\[K)?")
BAR = re.compile(rb"\[[# ]*\]\s+(\d+)% ([^\r\n\x1b]*)")
PATIENCE = 3.0  # seconds from asking the program to end to ending it

running = set()


class Job:
    """Begins at once; to be closed, whatever comes of it."""

    def __init__(self, program, kind, arguments, ending, prepare=None, where=None):
        """prepare: called with the folder, gives more arguments. Problem when it cannot begin."""
        self.folder = tempfile.mkdtemp(prefix="sozai-", dir=where)
        self.path = os.path.join(self.folder, kind + ending)
        self.said, self.process = b"", None
        try:
            more = prepare(self.folder) if prepare else []
            self.start([program, "grow", kind, "-o", self.path, *arguments, *more])
        except BaseException:
            self.close()
            raise
        running.add(self)

    def start(self, command):
        ours, theirs = pty.openpty() if pty else os.pipe()
        try:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL,
                                            stdout=subprocess.DEVNULL, stderr=theirs)
        except OSError as error:
            os.close(ours)
            raise Problem("sozai: cannot run '%s': %s" % (command[0], error.strerror)) from error
        finally:
            os.close(theirs)
        self.listener = threading.Thread(target=self.listen, args=(ours,), daemon=True)
        self.listener.start()

    def listen(self, ours):
        while True:
            try:
                heard = os.read(ours, 4096)
            except OSError:  # a terminal's end
                heard = b""
            if not heard:
                break
            self.said = (self.said + heard)[-65536:]
        os.close(ours)

    def progress(self):
        """Share that is done and what is being done, as the program's bar has it; or None."""
        found = BAR.findall(self.said)
        return (int(found[-1][0]) / 100, found[-1][1].decode("utf-8", "replace")) if found else None

    def finished(self):
        return self.process.poll() is not None

    def result(self):
        """Waits. The file's path; Problem with the program's own words when it failed."""
        code = self.process.wait()
        self.listener.join()
        if code != 0:
            text = BAR.sub(b"", CLEARED.sub(b"\n", self.said)).decode("utf-8", "replace")
            lines = [line.strip() for line in text.splitlines() if line.strip()]
            raise Problem(lines[-1] if lines else "sozai: ended with code %d" % code)
        if not os.path.isfile(self.path):
            raise Problem("sozai: wrote no '%s'" % self.path)
        return self.path

    def close(self):
        """Ends the program if it still runs; nothing of it is left."""
        if self.process and self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        running.discard(self)
        shutil.rmtree(self.folder, ignore_errors=True)


def close_all():
    for job in list(running):
        job.close()
