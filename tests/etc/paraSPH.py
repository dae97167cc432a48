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
                      ["-size", "0", "10"]):
            run = subprocess.run(
                [sys.executable, "-B", os.path.join(FOLDER, "paraSPH.py")]
                + wrong, stderr=subprocess.PIPE)
            self.assertEqual(run.returncode, 2, wrong)

    def testSyntaxOfView(self):
        with open(os.path.join(FOLDER, "particleView.py")) as stream:
            ast.parse(stream.read())

    @unittest.skipUnless(shutil.which("pvpython")
                         and shutil.which("Xvfb"), "no ParaView")
    def testPicture(self):
        picture = os.path.join(self.root.name, "p.png")
        subprocess.run([sys.executable, "-B",
                        os.path.join(FOLDER, "paraSPH.py"), "-case", self.case, "-field", "p", "-latestTime", "-output", picture,
                        "-size", "320", "200"], check=True, timeout=300)
        with open(picture, "rb") as stream:
            header = stream.read(24)
        self.assertEqual(struct.unpack(">II", header[16:]), (320, 200))


if __name__ == "__main__":
    unittest.main()
