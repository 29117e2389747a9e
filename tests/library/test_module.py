# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module: a scene as a dictionary, results with arrays, and a session."""
import copy
import json

import numpy as np
import pytest

import abut

# A block pressed on a held one: the pressure between them is the load's.
SCENE = {
    "abut": 1,
    "units": {"length": "mm", "force": "N"},
    "materials": {"steel": {"E": 210000, "nu": 0}},
    "parts": [
        {"name": "base", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [20, 10]}}},
        {"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [0, 10], "max": [20, 18]}}},
    ],
    "supports": [
        {"on": "base/bottom", "fix": ["x", "y"]},
        {"part": "block", "rigid": {"translation": [0, None], "rotation": None}},
    ],
    "loads": [{"name": "press", "on": "block/top", "pressure": 50}],
    "output": {"probes": [{"part": "block", "at": [10, 18]}]},
}
SHORTENING = 50 * 18 / 210000  # pressure times height over E


def test_analyze_answers_as_the_file_would():
    result = abut.analyze(SCENE)
    assert result["status"] == "ok"
    assert result["units"] == {"length": "mm", "force": "N"}
    (contact,) = result["contacts"]
    assert contact["status"] == "closed"
    assert contact["force"] == pytest.approx([0, -1000])
    profile = contact["profile"]
    assert isinstance(profile["pressure"], np.ndarray) and profile["pressure"].shape == profile["x"].shape
    assert profile["pressure"] == pytest.approx(50)
    assert profile["gap"] == pytest.approx(0, abs=1e-12)
    assert result["probes"][0]["displacement"] == pytest.approx([0, -SHORTENING], abs=1e-9)


def test_fields_are_arrays_of_one_length():
    fields = abut.analyze(SCENE)["fields"]
    assert [f["part"] for f in fields] == ["base", "block"]
    for field in fields:
        n = field["x"].size
        assert n > 0 and all(field[name].shape == (n,) for name in ("y", "ux", "uy", "xx", "yy", "xy", "zz", "von_mises"))
        assert field["patches"].ndim == 2 and field["patches"].shape[1] == 4 and field["patches"].max() < n
        assert field["yy"] == pytest.approx(-50, rel=1e-6)
        assert field["uy"] == pytest.approx(-50 * field["y"] / 210000, abs=1e-9)
        assert field["boundary"][0]["x"].size == field["boundary"][0]["uy"].size > 0


def test_a_session_answers_other_factors():
    session = abut.Session(SCENE)
    assert session.loads == {"press": 1}
    for factor in (1, 3, 0.2):
        session.set_load("press", factor)
        answer = session.answer()
        assert answer["status"] == "ok" and answer["doubts"] == []
        (contact,) = answer["contacts"]
        assert contact["pressure"] == pytest.approx(50 * factor)
        assert contact["pressure"].shape == contact["x"].shape == (len(contact["edge"]),)
        assert contact["force"] == pytest.approx([0, -1000 * factor])
        assert answer["probes"][0]["displacement"] == pytest.approx([0, -SHORTENING * factor], abs=1e-9)
        assert session.fields()[1]["yy"] == pytest.approx(-50 * factor, rel=1e-6)
    assert session.result()["contacts"][0]["max_pressure"]["value"] == pytest.approx(10, rel=1e-6)


def test_load_cases():
    scene = copy.deepcopy(SCENE)
    scene["cases"] = [{"name": "light", "loads": {"press": 1}}, {"name": "heavy", "loads": {"press": 2}}]
    cases = abut.analyze(scene)["cases"]
    assert list(cases) == ["light", "heavy"]
    assert cases["heavy"]["contacts"][0]["force"] == pytest.approx([0, -2000])
    session = abut.Session(scene)
    session.set_case("heavy")
    assert session.answer()["contacts"][0]["force"] == pytest.approx([0, -2000])


def test_whatever_is_wrong_is_one_error():
    scene = copy.deepcopy(SCENE)
    scene["parts"][0]["material"] = "steal"
    scene["loads"][0]["presure"] = scene["loads"][0].pop("pressure")
    with pytest.raises(abut.InputError) as caught:
        abut.analyze(scene)
    assert "did you mean 'steel'" in str(caught.value) and "presure" in str(caught.value)
    assert isinstance(caught.value, ValueError)
    with pytest.raises(abut.InputError, match="did you mean 'press'"):
        abut.Session(SCENE).set_load("pres", 1)
    with pytest.raises(ValueError):
        abut.analyze({**SCENE, "thickness": float("nan")})


def test_a_load_that_lifts_fails_with_the_motion():
    session = abut.Session(SCENE)
    session.prepare()
    session.set_load("press", -1)
    answer = session.answer()
    assert answer["status"] == "failed" and "block slides along (0, 1)" in answer["message"]
    assert session.fields() == []


def test_a_path_is_read_as_a_file(tmp_path):
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(SCENE))
    assert abut.analyze(str(file))["contacts"][0]["force"] == pytest.approx([0, -1000])
    assert abut.analyze(file)["contacts"][0]["force"] == pytest.approx([0, -1000])
