import numpy
import pytest

import ffstudy

SIGMA = 5.670374419e-8
MATERIALS = """
[materials]
"*" = { emissivity = 0.6, temperature = 300 }
6 = { emissivity = 0.8, temperature = 800 }
"""


def write(name, text):
    with open(name, "w") as out:
        out.write(text)
    return name


def exact_fluxes(emissivity, temperature):
    """W/m² of the faces of the cube, by a dense solution with the exact form factors."""
    factors = numpy.array([[0 if i == j else ffstudy.exact("cube", i + 1, j + 1) for j in range(6)] for i in range(6)])
    emitted = emissivity * SIGMA * temperature**4
    radiosity = numpy.linalg.solve(numpy.eye(6) - (1 - emissivity)[:, None] * factors, emitted)
    return radiosity - factors @ radiosity


def test_intervals_hold_the_exact_powers():
    found = ffstudy.heat("cube", write("materials.toml", MATERIALS))
    assert found.power.shape == found.temperature.shape == (6, 2) and found.balance.shape == (2,)
    emissivity, temperature = numpy.full(6, 0.6), numpy.full(6, 300.0)
    emissivity[5], temperature[5] = 0.8, 800
    powers = found.areas * exact_fluxes(emissivity, temperature)
    assert numpy.all(found.power[:, 0] <= powers + 1e-6) and numpy.all(found.power[:, 1] >= powers - 1e-6)
    assert found.groups["6"] == tuple(found.power[5])
    assert found.trusted and not found.cases
    arrays = ffstudy.heat("cube", emissivity=emissivity, temperature=temperature)
    assert numpy.array_equal(arrays.power, found.power)


def test_a_face_has_a_temperature_or_a_flux():
    temperature = numpy.array([300, numpy.nan, numpy.nan, numpy.nan, numpy.nan, 800])
    found = ffstudy.heat("cube", emissivity=0.7, temperature=temperature, flux=numpy.where(numpy.isnan(temperature), 0, numpy.nan))
    assert numpy.all(found.power[1:5] == 0) and numpy.all(found.temperature[1, :] > 300)
    with pytest.raises(ffstudy.InputError, match="neither temperature nor flux"):
        ffstudy.heat("cube", emissivity=0.7, temperature=temperature)
    with pytest.raises(ffstudy.InputError, match="there are 6 faces"):
        ffstudy.heat("cube", emissivity=[0.7, 0.8], temperature=300)
    with pytest.raises(ffstudy.InputError, match="expected one of the two"):
        ffstudy.heat("cube", "materials.toml", emissivity=0.7)


def test_cases_have_an_axis():
    file = write("cases.toml", MATERIALS + '[[case]]\nname = "a"\n[[case]]\nname = "b"\n[case.materials]\n6 = { temperature = 300 }\n')
    found = ffstudy.heat("cube", file)
    assert found.cases == ["a", "b"] and found.power.shape == (2, 6, 2) and found.balance.shape == (2, 2)
    assert numpy.array_equal(found.power[0], ffstudy.heat("cube", write("materials.toml", MATERIALS)).power)
    assert found.power[1] == pytest.approx(0, abs=1e-6) and len(found.groups) == 2


def test_files_of_meshes_are_scenes():
    write("sheet.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    found = ffstudy.heat("sheet.off", emissivity=0.5, temperature=400, surroundings=300)
    exact = 0.5 * SIGMA * (400**4 - 300**4)
    assert found.power[0, 0] <= exact * (1 + 1e-12) and found.power[0, 1] >= exact * (1 - 1e-12)
