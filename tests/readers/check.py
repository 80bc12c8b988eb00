"""Reads t.xyz, e.csv, s.csv with the programs they are written for and compares with r.json."""
import json

import duckdb
import MDAnalysis
import numpy as np
import pandas
from ase.io import read
from ovito.io import import_file

report = json.load(open("r.json"))
lines = open("t.xyz").read().split("\n")
frames = []  # of the text: ids, positions, velocities, radii
at = 0
while lines[at]:
    n = int(lines[at])
    rows = [line.split() for line in lines[at + 2: at + 2 + n]]
    frames.append({"head": lines[at + 1], "species": [r[0] for r in rows],
                   "id": np.array([int(r[4]) for r in rows]),
                   "pos": np.array([[float(x) for x in r[1:4]] for r in rows]),
                   "radius": np.array([float(r[5]) for r in rows]),
                   "mass": np.array([float(r[6]) for r in rows]),
                   "velo": np.array([[float(x) for x in r[7:10]] for r in rows])})
    at += 2 + n
assert len(frames) == 31
counts = [len(f["id"]) for f in frames]
assert counts[0] == 21 and max(counts) == 22 and counts[-1] == 21, counts
assert 21 in frames[-1]["id"] and 3 not in frames[-1]["id"]

atoms = read("t.xyz", index=":", format="extxyz")
assert len(atoms) == 31
for k, (a, f) in enumerate(zip(atoms, frames)):
    assert (a.arrays["id"] == f["id"]).all()
    assert (a.positions == f["pos"]).all() and (a.arrays["velo"] == f["velo"]).all()
    assert (a.arrays["radius"] == f["radius"]).all() and (a.arrays["mass"] == f["mass"]).all()
    assert list(a.pbc) == [True, False, False]
    assert np.allclose(np.diag(a.cell), [10, 8, 0.8], rtol=0, atol=0)
    assert abs(a.info["Time"] - k / 15) < 1e-12 and a.info["frame"] == 2 * k
    assert a.info["scene"] == "readers" and a.info["seed"] == 4
assert str(atoms[-1].info["state_hash"]).lstrip("0") == report["state_hash"].lstrip("0")
print("ASE: %d frames" % len(atoms))

pipeline = import_file("t.xyz")
assert pipeline.source.num_frames == 31
for k in (0, 10, 30):
    data = pipeline.compute(k)
    f = frames[k]
    assert data.particles.count == len(f["id"])
    assert (np.array(data.particles["Particle Identifier"]) == f["id"]).all()
    assert (np.array(data.particles["Radius"]) == f["radius"].astype(np.float64)).all() or \
        np.allclose(data.particles["Radius"], f["radius"], rtol=1e-6)
    assert np.allclose(data.particles["Velocity"], f["velo"], rtol=1e-6)
    assert np.allclose(data.particles["Position"], f["pos"], rtol=1e-6)
    assert np.allclose(data.particles["Mass"], f["mass"])
    assert list(data.cell.pbc) == [True, False, False]
    assert np.allclose(data.cell[:, 3], [-5, -4, -0.4])
    assert abs(data.attributes["Time"] - k / 15) < 1e-12
    types = {t.id: t.name for t in data.particles.particle_types.types}
    assert [types[t] for t in data.particles["Particle Type"]] == f["species"]
print("OVITO: %d frames" % pipeline.source.num_frames)

# MDAnalysis reads XYZ with one number of atoms for all frames: those up to the first command.
with open("same.xyz", "w") as out:
    at = 0
    for f in frames[:7]:
        n = len(f["id"])
        out.write("\n".join(lines[at: at + 2 + n]) + "\n")
        at += 2 + n
universe = MDAnalysis.Universe("same.xyz", format="XYZ")
assert len(universe.trajectory) == 7 and len(universe.atoms) == 21
for step, f in zip(universe.trajectory, frames):
    assert np.allclose(universe.atoms.positions, f["pos"], atol=1e-6)
print("MDAnalysis: %d frames" % len(universe.trajectory))

events = pandas.read_csv("e.csv")
assert str(events["time"].dtype) == "float64" and str(events["event"].dtype) == "int64"
assert str(events["kind"].dtype) in ("object", "str", "string")
impacts = events[events.kind.isin(["ball", "joint"]) & events.b.notna()]
assert len(impacts) == report["events"]["ball_ball"]
book = report["energy"]
lost = book["initial"] + book["input"] - book["final"]
assert abs(events.energy_lost.sum() - lost) < 1e-12 * book["initial"]
types = dict(duckdb.sql("select column_name, column_type from (describe select * from 'e.csv')").fetchall())
assert types["event"] == "BIGINT" and types["time"] == "DOUBLE" and types["kind"] == "VARCHAR"
assert types["a"] == "BIGINT" and types["b"] == "BIGINT" and types["impulse"] == "DOUBLE", types
assert types["wall"] == "VARCHAR"
(n,) = duckdb.sql("select count(*) from 'e.csv' where kind in ('wall', 'joint') and wall is not null").fetchall()[0]
assert n == report["events"]["ball_wall"]
types = dict(duckdb.sql("select column_name, column_type from (describe select * from 's.csv')").fetchall())
assert types["Z"] == "DOUBLE" and types["balls"] == "BIGINT" and types["temperature"] == "DOUBLE", types
series = pandas.read_csv("s.csv")
assert list(series.frame) == list(range(0, 61, 2)) and str(series.Z.dtype) == "float64"
print("pandas, DuckDB: %d events, %d lines" % (len(events), len(series)))
