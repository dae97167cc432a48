# What paraSPH asks of ParaView: discs, colour bar, time label, pictures.
import json
import os
import sys
from types import SimpleNamespace

from paraview import simple


def discs(source, view, radius):
    display = simple.Show(source, view)
    display.SetRepresentationType("Point Gaussian")
    display.GaussianRadius = radius
    display.ShaderPreset = "Plain circle"
    return display


def rangeOver(source, field, times):
    """Least and greatest value of a field over times; magnitude of vectors."""
    low, high = float("inf"), float("-inf")
    for time in times:
        source.UpdatePipeline(time)
        array = source.PointData[field]
        component = -1 if array.GetNumberOfComponents() > 1 else 0
        least, greatest = array.GetRange(component)
        low, high = min(low, least), max(high, greatest)
    return low, high if high > low else low + 1


def frame(sources, view, size):
    """All that is there in the view, with room for label and colour bar."""
    boxes = [source.GetDataInformation().GetBounds() for source in sources]
    low = [min(box[2*axis] for box in boxes) for axis in (0, 1)]
    high = [max(box[2*axis + 1] for box in boxes) for axis in (0, 1)]
    middle = [(low[axis] + high[axis])/2 for axis in (0, 1)]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle + [0]
    view.CameraPosition = middle + [max(high[0] - low[0], high[1] - low[1])]
    view.CameraParallelScale = max(0.53*(high[0] - low[0])*size[1]/size[0],
                                   0.8*(high[1] - low[1]))


def show(options):
    """View of the particles and walls at the last of times; radius in m."""
    series, walls = options.series, options.walls
    radius, times = options.radius, options.times
    particles = simple.OpenDataFile(series)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = options.size
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = "2D"

    display = discs(particles, view, radius)
    simple.ColorBy(display, ("POINTS", options.field))
    low, high = options.range or rangeOver(particles, options.field, times)
    colours = simple.GetColorTransferFunction(options.field)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.RescaleTransferFunction(low, high)
    bar = simple.GetScalarBar(colours, view)
    bar.Title = options.field
    bar.ComponentTitle = "Magnitude" if \
        particles.PointData[options.field].GetNumberOfComponents() > 1 else ""
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position = [0.3, 0.06]
    bar.ScalarBarLength = 0.4
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    display.SetScalarBarVisibility(view, True)

    walls = [simple.OpenDataFile(walls)] if walls else []
    for source in walls:
        wall = discs(source, view, radius)
        simple.ColorBy(wall, ("POINTS", None))
        wall.AmbientColor = wall.DiffuseColor = [0.6, 0.6, 0.6]

    label = simple.AnnotateTimeFilter(particles)
    label.Format = "t = {time:g} s"
    text = simple.Show(label, view)
    text.Color = [0, 0, 0]
    text.WindowLocation = "Upper Center"

    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    view.ViewTime = times[-1]
    simple.Render(view)
    frame([particles] + walls, view, options.size)
    return view


def film(view, options):
    """Writes a film of all times; its name."""
    simple.GetAnimationScene().PlayMode = "Snap To TimeSteps"
    stem, kind = os.path.splitext(options.film)
    unfinished = stem + ".unfinished" + kind
    if not simple.SaveAnimation(unfinished, view, FrameRate=options.rate,
                                ImageResolution=options.size):
        sys.exit("paraSPH: this ParaView writes no " + kind)
    os.replace(unfinished, options.film)
    return options.film


def save(view, options):
    """Writes a picture a time; yields their names."""
    times = options.times
    stem = options.output[:-len(".png")]
    for index, time in enumerate(times):
        name = "%s.%04d.png" % (stem, index) \
            if len(times) > 1 or options.numbered else options.output
        view.ViewTime = time
        unfinished = name[:-len(".png")] + ".unfinished.png"
        simple.SaveScreenshot(unfinished, view, ImageResolution=options.size)
        os.replace(unfinished, name)
        yield name


if __name__ == "__main__":
    task = SimpleNamespace(**json.loads(sys.argv[1]))
    view = show(task)
    for name in [film(view, task)] if task.film else save(view, task):
        print(name)
