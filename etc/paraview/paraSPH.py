#!/usr/bin/env python3
# The particles of a case as discs of the particle diameter, in ParaView.
#
#     paraSPH -case myCase -field p -latestTime -output p.png
#     paraSPH -case myCase -film collapse.ogv
#
# Opens VTK/<case>.vtp.series and VTK/<case>Walls.vtp.series. Where there is no
# display, it starts Xvfb.
# Options and files are checked before pvpython (ParaView 5.11) draws.
import argparse
import contextlib
import json
import os
import re
import shutil
import subprocess
import sys


class CaseError(Exception):
    """What is wrong with the case or an option, for the user to read."""


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="paraSPH", add_help=False, allow_abbrev=False,
        description="Pictures of the particles of a case, by ParaView")
    parser.add_argument("-help", action="help", help="list the options")
    parser.add_argument("-case", default=".", metavar="dir",
                        help="case folder (default: the present one)")
    parser.add_argument("-field", default="U", metavar="name",
                        help="field that gives the colour (default: U); a "
                             "vector or tensor by its magnitude")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("-time", type=float, metavar="t",
                       help="only the time nearest to t [s]")
    which.add_argument("-latestTime", action="store_true",
                       help="only the latest time")
    which.add_argument("-film", metavar="file",
                       help="film of all times: .ogv or .avi (ParaView), .mp4 "
                            "(ffmpeg), or a folder for its pictures")
    parser.add_argument("-rate", type=int, default=10, metavar="n",
                        help="pictures a second of a film (default: 10)")
    parser.add_argument("-range", type=float, nargs=2,
                        metavar=("min", "max"),
                        help="values at the ends of the colour bar (default: "
                             "those of the times drawn)")
    parser.add_argument("-output", metavar="file.png",
                        help="picture (default: <field>.png); for several "
                             "times file.0000.png, file.0001.png, ...")
    parser.add_argument("-size", type=int, nargs=2, default=[1200, 600],
                        metavar=("width", "height"), help="in pixels")
    options = parser.parse_args(arguments)
    if options.film:
        checkFilm(options, parser)
    options.output = options.output or options.field + ".png"
    if not options.output.endswith(".png"):
        parser.error("-output: the name must end in .png: " + options.output)
    if options.range and not options.range[0] < options.range[1]:
        parser.error("-range: min must be less than max")
    if min(options.size) < 1:
        parser.error("-size: width and height must be greater than 0")
    return options


def checkFilm(options, parser):
    kind = filmKind(options)
    if kind not in ("", ".ogv", ".avi", ".mp4"):
        parser.error("-film: a name in .ogv, .avi or .mp4, or a folder: "
                     + options.film)
    if options.output:
        parser.error("-film: the name of the film stands for -output")
    if options.rate < 1:
        parser.error("-rate: must be at least 1")
    if kind and any(pixels % 4 for pixels in options.size):
        parser.error("-size: of films in multiples of 4")


def filmKind(options):
    """".ogv", ".avi", ".mp4"; empty for a folder."""
    return os.path.splitext(options.film)[1] if options.film else ""


def findSeries(case):
    """The series of the particles, and that of the walls or None."""
    case = os.path.abspath(case)
    stem = os.path.join(case, "VTK", os.path.basename(case))
    series, walls = stem + ".vtp.series", stem + "Walls.vtp.series"
    if not os.path.isfile(series):
        raise CaseError("No series " + series + "\n    Has setParticles or "
                        "granularFoamSPH run, in a folder of this name?")
    return series, walls if os.path.isfile(walls) else None


def readSeries(series):
    """List of (time [s], file), in the order of the series."""
    try:
        with open(series) as stream:
            members = json.load(stream)["files"]
        times = [(float(member["time"]),
                  os.path.join(os.path.dirname(series), member["name"]))
                 for member in members]
    except (ValueError, KeyError, TypeError) as error:
        raise CaseError("Cannot read " + series + ": " + str(error))
    if not times:
        raise CaseError("No times in " + series)
    return times


def readHeader(file):
    """Names of the point fields, and the spacing [m], of a written time."""
    try:
        with open(file, "rb") as stream:
            text = stream.read(65536).decode("latin-1")
    except OSError as error:
        raise CaseError("Cannot read " + file + ": " + error.strerror)
    points = re.search(r"<PointData.*?</PointData>", text, re.S)
    fields = re.findall(r'\sName="([^"]*)"', points.group(0) if points else "")
    spacing = re.search(r'Name="spacing"[^>]*RangeMin="([^"]*)"', text)
    if not spacing:
        raise CaseError("No field data spacing in " + file)
    return fields, float(spacing.group(1))


def selectTimes(times, options):
    """The times of the series that are to be drawn [s]."""
    values = [time for time, _ in times]
    if options.latestTime:
        return values[-1:]
    if options.time is not None:
        return [min(values, key=lambda time: abs(time - options.time))]
    return values


def checkField(field, fields, file):
    if field not in fields:
        raise CaseError("No field " + field + " in " + file
                        + "\n    Valid fields: " + " ".join(sorted(fields)))


@contextlib.contextmanager
def display():
    """The environment with an X server in it, one of our own if need be."""
    if os.environ.get("DISPLAY"):
        yield os.environ
        return
    if not shutil.which("Xvfb"):
        raise CaseError("No display, and no Xvfb: install xvfb")
    # Says the number of its display once it is ready. Without -noreset it
    # starts anew after ParaView's first look, and ParaView may lose it.
    ready, say = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(say), "-screen", "0", "1280x1024x24",
         "-nolisten", "tcp", "-noreset"],
        pass_fds=[say], stderr=subprocess.DEVNULL)
    os.close(say)
    try:
        with open(ready) as stream:
            number = stream.readline().strip()
        if not number:
            raise CaseError("Xvfb does not start")
        yield dict(os.environ, DISPLAY=":" + number)
    finally:
        server.terminate()
        server.wait()


def main(arguments):
    options = parse(arguments)
    series, walls = findSeries(options.case)
    times = readSeries(series)
    chosen = selectTimes(times, options)
    file = dict(times)[chosen[-1]]
    fields, spacing = readHeader(file)
    checkField(options.field, fields, file)
    task = dict(series=series, walls=walls, radius=spacing / 2,
                times=chosen, field=options.field, range=options.range,
                output=options.output, size=options.size, rate=options.rate,
                film=None, numbered=False)
    if filmKind(options) in (".ogv", ".avi"):
        task["film"] = options.film
    elif options.film:
        return drawPictures(task, options)
    return draw(task)


def drawPictures(task, options):
    """Pictures into a folder, and for .mp4 by ffmpeg into a film beside it."""
    folder, kind = os.path.splitext(options.film)
    os.makedirs(folder, exist_ok=True)
    pictures = os.path.join(folder, options.field)
    code = draw(dict(task, numbered=True, output=pictures + ".png"))
    if code != 0 or not kind:
        return code
    if not shutil.which("ffmpeg"):
        raise CaseError("No ffmpeg, which makes " + options.film
                        + " of the pictures in " + folder
                        + "\n    ParaView itself writes .ogv and .avi")
    unfinished = folder + ".unfinished" + kind
    code = subprocess.run(
        ["ffmpeg", "-loglevel", "error", "-y", "-framerate",
         str(options.rate), "-i", pictures + ".%04d.png", "-pix_fmt",
         "yuv420p", unfinished]).returncode
    if code == 0:
        os.replace(unfinished, options.film)
        print(options.film)
    return code


def draw(task):
    """Has ParaView do a task; its exit code."""
    if not shutil.which("pvpython"):
        raise CaseError("No pvpython: install paraview and python3-paraview")
    # As one word: pvpython would take options with one dash for its own
    task = json.dumps(task)
    view = os.path.join(os.path.dirname(os.path.realpath(__file__)),
                        "particleView.py")
    with display() as environment:
        return subprocess.run(["pvpython", view, task],
                              env=environment).returncode


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except CaseError as error:
        sys.exit("paraSPH: " + str(error))
