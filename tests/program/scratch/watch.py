"""`course check 98 --watch` in a terminal of its own (a pseudo-terminal), as a person would use it: saving, keys, another
size, and every way to end. Run by scratch_course.sh in its copy, where chapter 98 is not started."""

import fcntl
import os
import pty
import re
import signal
import struct
import sys
import termios
import time

EXERCISE = "chapters/98_tiny/tiny.cpp"
KEYS = r"h hint .* q quit"
failures = 0


def fail(what, screen=""):
    global failures
    failures += 1
    if failures > 3:
        sys.exit(1)  # the rest follows from these
    print(f"FAILED: watch: {what}\n" + "".join(f"    {line}\n" for line in screen.splitlines()[-30:]), end="")


class Terminal:
    def __init__(self, *arguments):
        self.process, self.descriptor = pty.fork()
        if self.process == 0:
            os.environ.update({"TERM": "xterm", "NO_COLOR": "1"})
            for number in (signal.SIGINT, signal.SIGHUP):  # as in a terminal, also where the tests run in the background
                signal.signal(number, signal.SIG_DFL)
            os.execv("build/bin/course", ["course", "check", *arguments])
        self.resize(24, 80)
        self.screen = ""

    def resize(self, rows, columns):
        fcntl.ioctl(self.descriptor, termios.TIOCSWINSZ, struct.pack("4H", rows, columns, 0, 0))

    def read(self):
        try:
            self.screen += os.read(self.descriptor, 65536).decode(errors="replace").replace("\r", "")
            return True
        except OSError:  # nobody is at the other end any more
            return False

    def expect(self, name, pattern, seconds=60):
        """Waits until this is on the screen; what is above it is forgotten then."""
        end = time.monotonic() + seconds
        os.set_blocking(self.descriptor, False)
        while not (found := re.search(pattern, self.screen)):
            if time.monotonic() > end:
                return fail(f"{name}: no '{pattern}'", self.screen)
            time.sleep(0.02)
            try:
                self.screen += os.read(self.descriptor, 65536).decode(errors="replace").replace("\r", "")
            except BlockingIOError:
                pass
            except OSError:
                return fail(f"{name}: it has ended", self.screen)
        self.screen = self.screen[found.end():]

    def press(self, keys):
        os.write(self.descriptor, keys.encode())

    def is_raw(self):
        return not termios.tcgetattr(self.descriptor)[3] & (termios.ICANON | termios.ECHO)

    def ended(self, name):
        os.set_blocking(self.descriptor, False)
        for _ in range(600):  # twelve seconds
            try:
                os.read(self.descriptor, 65536)
            except OSError:
                pass
            process, status = os.waitpid(self.process, os.WNOHANG)
            if process:
                if self.is_raw():
                    fail(f"{name}: the terminal is not as it was")
                return os.waitstatus_to_exitcode(status)
            time.sleep(0.02)
        return fail(f"{name}: it has not ended", self.screen)


def save(text):
    """As editors do: beside, then in its place."""
    with open(EXERCISE + "~", "w") as file:
        file.write(text)
    os.replace(EXERCISE + "~", EXERCISE)


def work(start):
    terminal = Terminal("98", "--watch")
    terminal.expect("the first step", r"Watching step 98\.1")
    terminal.expect("it is to do", r"write step 98\.1")
    terminal.expect("the keys", KEYS)
    if not terminal.is_raw():
        fail("keys come without Enter")
    terminal.press("h")
    terminal.expect("a hint", r"Hint 1 of 3: first")
    terminal.expect("the keys again", KEYS)
    terminal.press("\033[A")  # an arrow is no command
    terminal.press("x")
    terminal.resize(10, 40)
    save(start.replace('return todo("98.1");', "return n +;"))
    terminal.expect("a compile error", r"error: ")
    terminal.expect("it goes on", KEYS)
    save(start.replace('return todo("98.1");', "return n + 2;"))
    terminal.expect("a wrong step", r"came out: 3, expected 2")
    terminal.expect("it goes on", KEYS)
    right = start.replace('return todo("98.1");', "return n + 1;")
    save(right)
    terminal.expect("what has passed", r"✓ .*98\.1")
    terminal.expect("on to the next one", r"Watching step 98\.2")
    terminal.expect("the keys", KEYS)
    terminal.press("l")
    terminal.expect("the list", r"✓ 98\.1  (.|\n)*○ 98\.2  After follow")
    terminal.expect("the keys", KEYS)

    # No shell is there to take the terminal over, so the system does not stop it; it comes back to its own screen.
    terminal.press("\032")  # Ctrl-Z
    terminal.expect("it goes on where it was", r"Watching step 98\.2")
    terminal.expect("the keys", KEYS)
    if not terminal.is_raw():
        fail("keys come without Enter again")

    save(right.replace('return todo("98.2");', "return n + 2;"))
    terminal.expect("the chapter has passed", r"✓ .*98\.2")
    terminal.expect("on to another chapter", r"Watching step (?!98)")
    terminal.expect("the keys", KEYS)
    terminal.press("q")
    if terminal.ended("quit") != 0:
        fail("to quit is no failure")


def end(name, how, expected):
    """However it ends, the terminal is as it was."""
    terminal = Terminal("98", "--watch")
    terminal.expect(name, KEYS)
    how(terminal)
    if (status := terminal.ended(name)) != expected:
        fail(f"{name}: status {status}, expected {expected}")


def main():
    with open(EXERCISE) as file:
        start = file.read()
    work(start)
    save(start)
    end("Ctrl-C", lambda terminal: terminal.press("\003"), -signal.SIGINT)
    for number in (signal.SIGTERM, signal.SIGHUP):
        end(number.name, lambda terminal: os.kill(terminal.process, number), -number)
    end("Ctrl-D", lambda terminal: terminal.press("\004"), 0)
    # In the middle of a check: nothing of it is left.
    save(start.replace('return todo("98.1");', "volatile bool on = true; while (on) {} return n;"))
    terminal = Terminal("98", "--watch")
    terminal.expect("a check that takes long", r"Watching step 98\.1")
    terminal.press("q")
    if terminal.ended("quit while it checks") != 0:
        fail("to quit is no failure, whatever runs")
    save(start)
    sys.exit(failures > 0)


main()
