"""Form factors by View3D: python3 view3d.py SCENE.vs3 prints from,to,estimate. VIEW3D names the program."""

import os
import subprocess
import sys
import tempfile

scene = sys.argv[1]
surfaces = [words for words in map(str.split, open(scene)) if words[:1] == ["S"]]
faces = [words[9] for words in surfaces if words[7] == "0"]  # others are combined with one of them
with tempfile.TemporaryDirectory() as folder:
    factors = os.path.join(folder, "factors")
    subprocess.run([os.environ.get("VIEW3D", "View3D"), scene, factors], check=True, stdout=sys.stderr, cwd=folder)
    numbers = " ".join(open(factors).readlines()[1:]).split()  # areas, rows of factors, emissivities
if len(numbers) != len(faces) * (len(faces) + 2):
    sys.exit(f"{len(numbers)} numbers for {len(faces)} faces: not the text format of View3D")
print("from,to,estimate")
for i, face in enumerate(faces):
    for j, other in enumerate(faces):
        print(f"{face},{other},{numbers[(i + 1) * len(faces) + j]}")
