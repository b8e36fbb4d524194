"""Runs a program until its end or a deadline, and leaves nothing of it behind."""

import contextlib
import os
import shutil
import signal
import subprocess
import time


class Failure(Exception):
    """a program is missing, failed or took too long; the message has one line"""


class Deadline:
    def __init__(self, seconds):
        self.seconds = seconds
        self.end = time.monotonic() + seconds

    def remaining(self):
        return self.end - time.monotonic()

    @contextlib.contextmanager
    def paused(self):
        """for what a user does once, such as building a program"""
        start = time.monotonic()
        try:
            yield
        finally:
            self.end += time.monotonic() - start


def one_line(text):
    """the end, where programs say what went wrong; 200 characters are enough for a message"""
    return " ".join(text.split())[-200:]


def stop(process):
    """ends also the children of `process`, first kindly, so that they remove their own files"""
    for signal_number in (signal.SIGTERM, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal_number)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.communicate(timeout=5)
            return


def run(command, folder, deadline):
    """output and wall time of `command`, which has `folder` as its home and for temporary files, so
    that neither reads settings of the user nor leaves any"""
    if deadline.remaining() <= 0:
        raise Failure(f"no result within {deadline.seconds:g} seconds")
    command = [str(word) for word in command]
    if not shutil.which(command[0]):
        raise Failure(f"{command[0]} is not installed")
    start = time.perf_counter()
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
        text=True, errors="replace", cwd=folder, start_new_session=True,
        env={**os.environ, "HOME": str(folder), "TMPDIR": str(folder),
             "XDG_RUNTIME_DIR": str(folder)})
    try:
        output, errors = process.communicate(timeout=deadline.remaining())
    except subprocess.TimeoutExpired:
        raise Failure(f"no result within {deadline.seconds:g} seconds") from None
    finally:
        if process.returncode is None:
            stop(process)
    seconds = time.perf_counter() - start
    if process.returncode != 0:
        raise Failure(f"exit code {process.returncode}: {one_line(errors) or one_line(output)}")
    return output, seconds


def run_headless(command, folder, deadline):
    """for programs with windows, even if they show none"""
    if not shutil.which(command[0]):
        raise Failure(f"{command[0]} is not installed")
    return run(["xvfb-run", "-a", *command], folder, deadline)
