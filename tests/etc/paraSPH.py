# Options, series and headers of etc/paraview/paraSPH.py; a picture where
# pvpython is found.
import ast
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "..", "..", "etc", "paraview")
sys.dont_write_bytecode = True
sys.path.insert(0, FOLDER)
import paraSPH  # noqa: E402

VTP = """<VTKFile type="PolyData"><PolyData><FieldData>
<DataArray type="Float64" Name="spacing" NumberOfTuples="1" format="ascii"
RangeMin="0.1">0.1</DataArray></FieldData>
<Piece NumberOfPoints="2" NumberOfVerts="1">
<PointData><DataArray type="Float64" Name="p" format="ascii">1 2</DataArray>
</PointData><Points><DataArray type="Float64" NumberOfComponents="3"
format="ascii">0 0 0 1 0 0</DataArray></Points>
<Verts><DataArray type="Int64" Name="connectivity" format="ascii">0 1
</DataArray><DataArray type="Int64" Name="offsets" format="ascii">2
</DataArray></Verts></Piece></PolyData></VTKFile>
"""


def sizeOf(picture):
    with open(picture, "rb") as stream:
        return struct.unpack(">II", stream.read(24)[16:])


class Case(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.TemporaryDirectory()
        self.case = os.path.join(self.root.name, "heap")
        os.makedirs(os.path.join(self.case, "VTK"))
        files = []
        for time in 0, 0.5, 2:
            folder = os.path.join(self.case, str(time))
            os.mkdir(folder)
            with open(os.path.join(folder, "granular.vtp"), "w") as stream:
                stream.write(VTP)
            files.append({"name": "../%s/granular.vtp" % time, "time": time})
        self.series = os.path.join(self.case, "VTK", "heap.vtp.series")
        with open(self.series, "w") as stream:
            json.dump({"file-series-version": "1.0", "files": files}, stream)

    def tearDown(self):
        self.root.cleanup()

    def chosen(self, *arguments):
        return paraSPH.selectTimes(paraSPH.readSeries(self.series),
                                   paraSPH.parse(list(arguments)))

    def testTimes(self):
        self.assertEqual(self.chosen(), [0, 0.5, 2])
        self.assertEqual(self.chosen("-latestTime"), [2])
        self.assertEqual(self.chosen("-time", "0.6"), [0.5])

    def testHeader(self):
        file = os.path.join(self.case, "0", "granular.vtp")
        self.assertEqual(paraSPH.readHeader(file), (["p"], 0.1))

    def testErrors(self):
        with self.assertRaisesRegex(paraSPH.CaseError, "Valid fields: p"):
            paraSPH.main(["-case", self.case, "-field", "q"])
        with self.assertRaisesRegex(paraSPH.CaseError, "No series"):
            paraSPH.main(["-case", self.root.name])

    def testWrongOptions(self):
        for wrong in (["-feild", "p"], ["-time", "0", "-latestTime"],
                      ["-range", "2", "1"], ["-output", "p.gif"],
                      ["-size", "0", "10"], ["-film", "p.gif"],
                      ["-film", "p.ogv", "-output", "p.png"],
                      ["-film", "p.ogv", "-latestTime"],
                      ["-film", "p.ogv", "-size", "322", "200"],
                      ["-film", "p.ogv", "-rate", "0"]):
            run = subprocess.run(
                [sys.executable, "-B", os.path.join(FOLDER, "paraSPH.py")]
                + wrong, stderr=subprocess.PIPE)
            self.assertEqual(run.returncode, 2, wrong)

    def testPicturesWithoutFfmpeg(self):
        tasks = []
        with unittest.mock.patch.object(
                paraSPH, "draw", lambda task: tasks.append(task) or 0), \
                unittest.mock.patch("shutil.which", lambda name: None):
            film = os.path.join(self.root.name, "p.mp4")
            with self.assertRaisesRegex(paraSPH.CaseError, "No ffmpeg, .*"
                                        "p.mp4"):
                paraSPH.main(["-case", self.case, "-field", "p", "-film", film])
        self.assertEqual(tasks[0]["times"], [0, 0.5, 2])
        self.assertEqual(tasks[0]["output"],
                         os.path.join(self.root.name, "p", "p.png"))
        self.assertTrue(tasks[0]["numbered"])

    def testFilmOfPictures(self):
        """A program in the place of ffmpeg makes the film of its input."""
        def draw(task):
            with open(task["output"].replace(".png", ".0000.png"), "w"):
                return 0
        ffmpeg = os.path.join(self.root.name, "ffmpeg")
        with open(ffmpeg, "w") as stream:
            stream.write("#!/bin/sh\nfor last; do :; done\necho $* > $last\n")
        os.chmod(ffmpeg, 0o755)
        film = os.path.join(self.root.name, "p.mp4")
        path = self.root.name + ":" + os.environ["PATH"]
        with unittest.mock.patch.object(paraSPH, "draw", draw), \
                unittest.mock.patch.dict(os.environ, PATH=path):
            self.assertEqual(paraSPH.main(["-case", self.case, "-field", "p",
                                           "-film", film, "-rate", "5"]), 0)
        with open(film) as stream:
            self.assertIn("-framerate 5 -i " + film[:-4] + "/p.%04d.png",
                          stream.read())

    def testSyntaxOfView(self):
        with open(os.path.join(FOLDER, "particleView.py")) as stream:
            ast.parse(stream.read())

    @unittest.skipUnless(shutil.which("pvpython")
                         and shutil.which("Xvfb"), "no ParaView")
    def testPicture(self):
        picture = os.path.join(self.root.name, "p.png")
        run = self.draw("-latestTime", "-output", picture)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(sizeOf(picture), (320, 200))

    @unittest.skipUnless(shutil.which("pvpython")
                         and shutil.which("Xvfb"), "no ParaView")
    def testFilm(self):
        film = os.path.join(self.root.name, "p.ogv")
        run = self.draw("-film", film)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(film, "rb") as stream:
            self.assertEqual(stream.read(4), b"OggS")

    def draw(self, *options, env=None):
        return subprocess.run(
            [sys.executable, "-B", os.path.join(FOLDER, "paraSPH.py"),
             "-case", self.case, "-field", "p", "-size", "320", "200",
             *options], env=env, timeout=300, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


if __name__ == "__main__":
    unittest.main()
