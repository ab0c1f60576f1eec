import numpy
import pytest

import ffstudy

# A cube of edges 1 from outside in: its faces see each other.
VERTICES = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
OPPOSITE, ADJACENT = 0.19982489569838746, 0.20004377607540316  # python3: see test_exact_values


def test_exact_values():
    # The closed form of two opposite unit squares at distance 1, by its own formula.
    root = numpy.sqrt(2)
    opposite = 2 / numpy.pi * (numpy.log(2 / numpy.sqrt(3)) + 2 * root * numpy.arctan(1 / root) - 2 * numpy.arctan(1))
    assert ffstudy.exact("cube", 1, 6) == pytest.approx(opposite, abs=1e-14)
    assert ffstudy.exact("cube", 1, 6) == pytest.approx(OPPOSITE, abs=1e-14)
    assert ffstudy.exact("cube", 1, 2) == pytest.approx(ADJACENT, abs=1e-14)
    with pytest.raises(ffstudy.InputError, match="faces 1 to 6"):
        ffstudy.exact("cube", 0, 1)


def test_polygons_give_what_the_scene_of_that_name_gives():
    found = ffstudy.form_factors(vertices=VERTICES, faces=FACES, tolerance=1e-4)
    assert found.factors.shape == found.half_widths.shape == (6, 6)
    assert found.areas == pytest.approx(numpy.ones(6))
    assert found.factors[0, 1] == pytest.approx(OPPOSITE, abs=1e-4)
    assert found.factors[0, 2] == pytest.approx(ADJACENT, abs=1e-4)
    assert numpy.all(numpy.diag(found.factors) == 0)
    assert found.missed == 0 and found.trusted and not found.faults
    assert numpy.all(found.half_widths <= 1e-4)
    assert "<table>" in found._repr_html_()


def test_names_join_faces():
    names = ["floor", "top", "side", "side", "side", "side"]
    found = ffstudy.form_factors(vertices=numpy.array(VERTICES), faces=FACES, names=names, tolerance=1e-4)
    assert found.names == ["floor", "top", "side"]
    assert found.factors[0, 2] == pytest.approx(4 * ADJACENT, abs=1e-4)


def test_files_are_scenes():
    with open("room.obj", "w") as out:
        for x, y, z in VERTICES:
            out.write(f"v {x} {y} {z}\n")
        for number, face in enumerate(FACES):
            out.write(f"g {'abcdef'[number]}\nf {' '.join(str(corner + 1) for corner in face)}\n")
    found = ffstudy.form_factors("room.obj", tolerance=1e-4)
    assert found.names == list("abcdef")
    assert found.sparse().shape == (6, 6)


def test_large_matrices_are_sparse():
    count = 2049  # squares in a plane, which do not see each other, but for the first two
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    vertices = numpy.concatenate([corners + [2 * number, 0, 0] for number in range(count)])
    vertices[4:8] = corners[::-1] + [0, 0, 1]
    found = ffstudy.form_factors(vertices=vertices, faces=numpy.arange(4 * count).reshape(-1, 4), tolerance=1e-3)
    assert found.factors.shape == found.half_widths.shape == (count, count)
    assert found.factors.format == "csr" and found.factors[0, 1] == pytest.approx(OPPOSITE, abs=1e-3)
    assert f"<p>{count} × {count + 1}</p>" in found._repr_html_()
    assert found.sparse().nnz == found.factors.nnz


@pytest.mark.parametrize("arguments, message", [
    ({}, "a scene, or vertices and faces"),
    ({"scene": "cube", "vertices": VERTICES, "faces": FACES}, "a scene, or vertices and faces"),
    ({"scene": "cub"}, "cub"),
    ({"vertices": [[0, 0]], "faces": []}, "shape"),
    ({"vertices": VERTICES, "faces": [[0, 1, 8]]}, "counted from 0 to 7"),
    ({"vertices": VERTICES, "faces": FACES, "names": ["a"]}, "there are 6 faces"),
    ({"vertices": VERTICES, "faces": FACES, "names": ["a b"] * 6}, "one word"),
    ({"vertices": VERTICES, "faces": [[0, 1, 1]]}, "polygons.obj"),
    ({"vertices": [[0, 0, float("nan")]] * 3, "faces": [[0, 1, 2]]}, "polygons.obj"),
])
def test_bad_input_is_named(arguments, message):
    with pytest.raises(ffstudy.InputError, match=message):
        ffstudy.form_factors(**arguments)


def test_missing_files_are_named():
    with pytest.raises(ffstudy.FileError, match="missing.obj"):
        ffstudy.form_factors("missing.obj")
    with pytest.raises(OSError):
        ffstudy.form_factors("missing.obj")
