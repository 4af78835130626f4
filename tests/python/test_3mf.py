# SPDX-License-Identifier: MIT
"""3MF: the build's items are placed, and damaged files give a clear error."""
import sys
from pathlib import Path

import numpy as np
import pytest
from test_shapes import write

from hrbfnpr import shapes

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fuzz"))
from reader_files import CORE, TRIANGLES, VERTICES, mf3, mf3_model  # noqa: E402

CUBE = np.array(VERTICES, dtype=float)
PRODUCTION = 'xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"'
MOVED = 'transform="1 0 0 0 1 0 0 0 1 5 6 7"'


def volume(shape):
    a, b, c = (shape.points[shape.triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def test_a_cube(tmp_path):
    shape = shapes.read(write(tmp_path, "a.3mf", mf3()))
    np.testing.assert_array_equal(shape.points, CUBE)
    np.testing.assert_array_equal(shape.triangles, TRIANGLES)
    assert shape.format == "3MF" and shape.up == (0, 0, 1) and not shape.notes


def test_3mf_is_recognized_by_its_contents(tmp_path):
    other = shapes.read(write(tmp_path, "a.zip", mf3(name="other.model", target="other.model")))
    assert len(other.triangles) == 12
    assert "the file holds 3MF" in shapes.read(write(tmp_path, "a.stl", mf3())).notes[0]
    with pytest.raises(shapes.ShapeError, match="unpack it first"):
        shapes.read(write(tmp_path, "b.zip", b"PK\3\4" + bytes(100)))


def test_items_and_components_are_placed(tmp_path):
    pair = f'<object id="2"><components><component objectid="1"/><component objectid="1" {MOVED}/></components></object>'
    turned = 'transform="0 1 0 -1 0 0 0 0 2 0 0 0"'  # a quarter turn, and twice as high
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(mf3_model(f'<item objectid="2" {turned}/>', pair))))
    turn = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 2]])
    np.testing.assert_allclose(shape.points, np.concatenate([CUBE @ turn, (CUBE + (5, 6, 7)) @ turn]))
    assert abs(volume(shape)) == pytest.approx(4)


def test_mirrored_parts_keep_their_outside(tmp_path):
    plain = shapes.read(write(tmp_path, "a.3mf", mf3()))
    mirror = 'transform="-1 0 0 0 1 0 0 0 1 0 0 0"'
    mirrored = shapes.read(write(tmp_path, "b.3mf", mf3(mf3_model(f'<item objectid="1" {mirror}/>'))))
    assert volume(mirrored) == pytest.approx(volume(plain))


def test_items_may_be_in_other_files_of_the_archive(tmp_path):
    build = f'<item objectid="1" p:path="/3D/a.model" {PRODUCTION}/><item objectid="1" {MOVED}/>'
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(mf3_model(build), more=[("3D/a.model", mf3_model())])))
    np.testing.assert_array_equal(shape.points, np.concatenate([CUBE, CUBE + (5, 6, 7)]))


def test_print_supports_are_left_out(tmp_path):
    support = mf3_model('<item objectid="1"/><item objectid="3"/>').replace("</resources>", "{}</resources>")
    mesh = support[support.index("<mesh>") : support.index("</mesh>") + 7]
    model = support.replace("{}", f'<object id="3" type="support">{mesh}</object>')
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(model)))
    assert len(shape.points) == 8 and shape.notes == ("1 support object of the print left out",)


def lattice(beams, said='radius="0.1"', head='xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"', more=""):
    """A model whose only object is a lattice at the corners of the cube."""
    places = "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*vertex) for vertex in VERTICES)
    one = f'<b:beamlattice {said}><b:beams>{beams}</b:beams>{more}</b:beamlattice>'
    mesh = f"<mesh><vertices>{places}</vertices><triangles/>{one}</mesh>"
    objects = f'<resources><object id="1" type="model">{mesh}</object></resources>'
    return f'<?xml version="1.0"?><model xmlns="{CORE}" {head}>{objects}<build><item objectid="1"/></build></model>'


CAPSULE = np.pi * 0.1**2 + 4 / 3 * np.pi * 0.1**3  # the volume of a beam of length 1 and radius 0.1
CONE = np.pi / 3 * (0.2**2 + 0.2 * 0.1 + 0.1**2) + 2 / 3 * np.pi * (0.2**3 + 0.1**3)  # nearly: the tangent cone is tilted


@pytest.mark.parametrize(
    "model, parts, content",
    [
        (lattice('<b:beam v1="0" v2="1"/>'), 1, CAPSULE),
        (lattice('<b:beam v1="0" v2="1"/><b:beam v1="6" v2="7"/>'), 2, 2 * CAPSULE),
        (lattice('<b:beam v1="1" v2="0"/>', head=""), 1, CAPSULE),  # the prefix is not declared
        (lattice('<b:beam v1="0" v2="1"/>', 'radius="0.1" cap="butt"'), 1, np.pi * 0.1**2),
        (lattice('<b:beam v1="0" v2="1" cap1="butt" cap2="butt"/>'), 1, np.pi * 0.1**2),
        (lattice('<b:beam v1="0" v2="1" r1="0.2" r2="0.1"/>'), 1, CONE),
        (lattice('<b:beam v1="0" v2="1" r1="0.1"/>', 'radius="7"'), 1, CAPSULE),
        (lattice('<b:beam v1="0" v2="1"/><b:beam v1="0" v2="7"/>', 'radius="0.1" minlength="1.5"'), 1, CAPSULE + 0.7321 * np.pi * 0.1**2),
        (lattice("", 'radius="0.1" ballmode="mixed" ballradius="0.3"', more='<b:balls><b:ball vindex="3"/></b:balls>'), 1,
         4 / 3 * np.pi * 0.3**3),
        (lattice('<b:beam v1="0" v2="1"/>', 'radius="0.1" ballmode="all" ballradius="0.3"'), 3, CAPSULE + 8 / 3 * np.pi * 0.3**3),
    ],
)  # fmt: skip
def test_beams_are_capsules(tmp_path, model, parts, content):
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(model)))
    facts = shapes.mesh_facts(shape)
    assert facts.closed and facts.components == parts and not facts.inside_out
    assert volume(shape) == pytest.approx(content, rel=0.05)


def test_beams_touch_their_balls(tmp_path):
    """No corner is within the hull of the two balls of a beam, or out of it by more than rounding."""
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(lattice('<b:beam v1="0" v2="1" r1="0.2" r2="0.1"/>'))))
    along = np.linspace(0, 1, 20001)
    off = [(np.linalg.norm(point - along[:, None] * [1, 0, 0], axis=1) - 0.2 + 0.1 * along).min() for point in shape.points[8:]]
    assert np.abs(off).max() < 2e-3


def test_many_beams_have_few_sides(tmp_path, monkeypatch):
    one = '<b:beam v1="0" v2="1"/>'
    path = write(tmp_path, "a.3mf", mf3(lattice(one * 500)))
    assert len(shapes.read(path).triangles) < 200_000
    monkeypatch.setattr("hrbfnpr.shapes._3mf.MOST_CAPSULES", 400)
    with pytest.raises(shapes.ShapeError, match="has 500 beams; 400 can be drawn: export"):
        shapes.read(path)


@pytest.mark.parametrize("beam, said, words", [
    ('<b:beam v1="0" v2="9"/>', 'radius="1"', "names a vertex that it lacks; it has 8"),
    ('<b:beam v1="0"/>', 'radius="1"', "a beam without v2"),
    ('<b:beam v1="0" v2="1"/>', "", "a beam without r1"),
    ('<b:beam v1="0" v2="1" r1="-1"/>', 'radius="1"', "no radius above 0"),
    ('<b:beam v1="0" v2="1" r2="nan"/>', 'radius="1"', "no radius above 0"),
])  # fmt: skip
def test_broken_beams(tmp_path, beam, said, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.3mf", mf3(lattice(beam, said))))


def test_a_clipping_mesh_is_not_applied(tmp_path):
    said = 'radius="0.1" clippingmode="inside" clippingmesh="2"'
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(lattice('<b:beam v1="0" v2="1"/>', said))))
    assert shape.notes == ("the beams of object 1 are not clipped by its clipping mesh",)


@pytest.mark.parametrize("old, new", [
    ("<triangles>", "<triangles><m:colors/>"),
    ("<triangle ", '<triangle m:pid="3" '),
    ("<vertices>", '<x-y:note a="1">text</x-y:note><vertices>'),
    ("<resources>", '<t:a xmlns:t="u"/><resources t:b="1">'),
])  # fmt: skip
def test_undeclared_prefixes_are_ignored(tmp_path, old, new):
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(mf3_model().replace(old, new))))
    np.testing.assert_array_equal(shape.points, CUBE)
    assert len(shape.triangles) == 12


def test_undeclared_paths_keep_their_meaning(tmp_path):
    build = f'<item objectid="1" p:path="/3D/a.model"/><item objectid="1" {MOVED}/>'
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(mf3_model(build), more=[("3D/a.model", mf3_model())])))
    np.testing.assert_array_equal(shape.points, np.concatenate([CUBE, CUBE + (5, 6, 7)]))


SLICES = 'xmlns:s="http://schemas.microsoft.com/3dmanufacturing/slice/2015/07"'


def disc(radius, turn=1, corners=60):
    angle = turn * 2 * np.pi * np.arange(corners) / corners
    return np.column_stack([5 + radius * np.cos(angle), radius * np.sin(angle)])


def stack(levels, number=9, bottom=1.0, more=""):
    """A stack of slices: for each level its upper end and its polygons."""
    slices = ""
    for top, polygons in levels:
        corners = "".join(f'<s:vertex x="{x}" y="{y}"/>' for polygon in polygons for x, y in polygon.tolist())
        first, lines = 0, ""
        for polygon in polygons:
            ends = [*range(first + 1, first + len(polygon)), first]
            lines += f'<s:polygon startv="{first}">' + "".join(f'<s:segment v2="{end}"/>' for end in ends) + "</s:polygon>"
            first += len(polygon)
        slices += f'<s:slice ztop="{top}"><s:vertices>{corners}</s:vertices>{lines}</s:slice>'
    return f'<s:slicestack id="{number}" zbottom="{bottom}">{more}{slices}</s:slicestack>'


def sliced(stacks, said='s:slicestackid="9" s:meshresolution="lowres"', head=SLICES, model=None):
    model = (model or mf3_model()).replace('<object id="1"', f'<object id="1" {said}').replace("<model ", f"<model {head} ")
    return model.replace("<resources>", f"<resources>{stacks}")


TUBE = [(2.0, [disc(2), disc(1, -1)]), (3.0, [disc(2)])]  # a cup that is upside down


@pytest.mark.parametrize("how", ["plain", "no prefix", "no mesh", "other part", "moved"])
def test_slices_are_stacked(tmp_path, how):
    more, model = [], sliced(stack(TUBE), head="" if how == "no prefix" else SLICES)
    if how == "no mesh":
        model = sliced(stack(TUBE), 's:slicestackid="9"', model=mf3_model().replace("mesh>", "nothing>"))
    if how == "moved":
        model = model.replace('<item objectid="1"', f'<item objectid="1" {MOVED}')
    if how == "other part":
        more = [("2D/a.model", f'<model xmlns="{CORE}" {SLICES}><resources>{stack(TUBE, 4)}</resources></model>')]
        model = sliced(stack([], more='<s:sliceref slicestackid="4" slicepath="/2D/a.model"/>'))
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(model, more=more)))
    facts = shapes.mesh_facts(shape)
    assert facts.closed and facts.components == 1 and not facts.inside_out
    assert volume(shape) == pytest.approx(np.pi * (4 - 1) + np.pi * 4, rel=0.02)
    place = np.array([5, 6, 7]) if how == "moved" else 0
    np.testing.assert_allclose(shape.points.min(axis=0), np.array([3, -2, 1]) + place, atol=0.05)
    np.testing.assert_allclose(shape.points.max(axis=0), np.array([7, 2, 3]) + place, atol=0.05)
    assert shape.notes == ("object 1 is made of 2 slices: they are stacked, in cells of 0.05",)


def test_a_ball_of_slices_is_round(tmp_path):
    ends = np.linspace(-1, 1, 61)
    levels = [(top, [disc(np.sqrt(1 - ((top + low) / 2) ** 2))]) for low, top in zip(ends, ends[1:])]
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(sliced(stack(levels, bottom=-1.0)))))
    assert np.abs(np.linalg.norm(shape.points - [5, 0, 0], axis=1) - 1).max() < 0.03


def test_an_exact_mesh_comes_before_its_slices(tmp_path):
    shape = shapes.read(write(tmp_path, "a.3mf", mf3(sliced(stack(TUBE), 's:slicestackid="9"'))))
    assert len(shape.triangles) == 12 and shape.notes == ()


@pytest.mark.parametrize("stacks, words", [
    ("", "names the slices '9', which 3D/3dmodel.model does not have"),
    (stack([]), "object '1' of the 3MF file is made of slices: its slices have no polygons"),
    (stack([(2.0, [disc(2)]), (1.5, [disc(2)])]), "its slices do not rise"),
    (stack(TUBE).replace('v2="3"', 'v2="333"', 1), "names a vertex that it lacks; it has 120"),
    (stack(TUBE).replace('ztop="2.0"', ""), "a slice without ztop"),
    (stack(TUBE).replace('x="', 'x="nan" b="', 1), "corners that are not finite"),
    (stack([], more='<s:sliceref slicestackid="9"/>'), "names the slices '9'"),
])  # fmt: skip
def test_broken_slices(tmp_path, stacks, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.3mf", mf3(sliced(stacks))))


CIRCLE = '<object id="2"><components><component objectid="3"/></components></object>'
CIRCLE += '<object id="3"><components><component objectid="2"/></components></object>'
MANY = "".join(
    f'<object id="{i}"><components>{f"""<component objectid="{i - 1}"/>""" * 10}</components></object>'
    for i in range(2, 12)
)


@pytest.mark.parametrize(
    "data, words",
    [
        (mf3()[:-30], "not a whole ZIP archive"),
        (b"PK\3\4" + bytes(100), "not a whole ZIP archive"),
        (mf3().replace(b'x="1"', b'x="2"', 1), "not a whole ZIP archive"),  # its checksum differs
        (mf3("<model"), r"3D/3dmodel.model of the 3MF file is not XML: .*line 1, column"),
        (mf3('<?xml version="1.0" encoding="none"?><model/>'), "cannot be read|no XML"),
        (mf3(target="/3D/lost.model"), "refers to 3D/lost.model, which is not in it"),
        (mf3(mf3_model("")), "places nothing"),
        (mf3(f'<model xmlns="{CORE}"/>'), "places nothing"),
        (mf3(mf3_model('<item objectid="7"/>')), "places object '7', which 3D/3dmodel.model does not have"),
        (mf3(mf3_model('<item objectid="1" transform="1 2 x"/>')), "not 12 numbers: '1 2 x'"),
        (mf3(mf3_model('<item objectid="2"/>', CIRCLE)), "contain each other"),
        (mf3(mf3_model('<item objectid="11"/>', MANY)), "more than 100000 objects"),
        (mf3(mf3_model().replace('v3="3"', 'v3="99"', 1)), "names vertex 99, but there are only 8"),
        (mf3(mf3_model().replace('v3="3"', 'v3="-1"', 1)), "names vertex -1, but there are only 8"),
        (mf3(mf3_model().replace('v3="3"', 'v3="1e400"', 1)), "a triangle without v1, v2, v3"),
        (mf3(mf3_model().replace(' y="0"', "", 1)), "object '1' of the 3MF file has a vertex without x, y, z"),
    ],
)
def test_broken_files(tmp_path, data, words):
    with pytest.raises(shapes.ShapeError, match=words):
        shapes.read(write(tmp_path, "a.3mf", data))


def test_odd_values_never_raise_anything_but_shape_error(tmp_path):
    rng = np.random.default_rng(5)
    odd = ["", "nan", "1e999", "-7", "x" * 50, "99999999999999999999", "model", "0x1", "é"]
    pieces = mf3_model(f'<item objectid="2" {MOVED}/>', CIRCLE.replace("3", "1", 1)).split('"')
    for _ in range(300):
        some = list(pieces)
        for at in rng.integers(1, len(some) - 1, 2):
            some[at] = odd[rng.integers(len(odd))]
        try:
            shapes.read(write(tmp_path, "a.3mf", mf3('"'.join(some))))
        except shapes.ShapeError:
            pass
