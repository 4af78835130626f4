// SPDX-License-Identifier: MIT
// Draws the scene of reference.c step by step with Node and koffi: koffi.js CDEF LIBRARY SAMPLES PICTURE.
// It uses only the declarations in CDEF.
"use strict";
const assert = require("assert");
const fs = require("fs");
const koffi = require("koffi");

const [cdefPath, libraryPath, samplesPath, picturePath] = process.argv.slice(2);
const WIDTH = 640, HEIGHT = 480;

// Declares everything in CDEF. koffi reads prototypes, but each type must be declared separately.
function declared(text, library) {
    const C = {};
    const filled = new Set(["uint32_t", "int64_t", "double"]); // types that koffi must copy back: numbers and structs

    // "double view[16]" -> ["view", "double [16]"]. Callbacks in structs are not used here.
    function field(declaration) {
        if (declaration.includes("(*")) return [declaration.match(/\(\*(\w+)\)/)[1], "void *"];
        const [, type, name, size = ""] = declaration.match(/^(.*\W)(\w+)(\[\d+\])?$/);
        return [name, type + size];
    }

    function parameter(declaration) {
        const [, type, stars] = declaration.match(/^(?:const )?(\w+)(\**)/);
        if (stars === "**") return "_Out_ " + declaration;
        return stars && filled.has(type) && !declaration.startsWith("const") ? "_Inout_ " + declaration : declaration;
    }

    const FORMS = [
        [/^enum \{(.*)\};$/, (body) => {
            for (const [, name, value] of body.matchAll(/(\w+) = (-?\d+)/g)) C[name] = Number(value);
        }],
        [/^typedef struct (\w+) \{ (.*); \} \w+;$/, (name, fields) => {
            koffi.struct(name, Object.fromEntries(fields.split("; ").map(field)));
            filled.add(name);
        }],
        [/^typedef struct (\w+) \w+;$/, (name) => koffi.opaque(name)],
        [/^typedef (.*) ?\(\*(\w+)\)(.*);$/, (result, name, parameters) =>
            koffi.pointer(name, koffi.proto(`${result} ${name}_prototype${parameters}`))],
        [/^typedef (\w+) (\w+);$/, (type, name) => koffi.alias(name, type)],
        [/^(.*\W)(hrbfnpr_\w+)\((.*)\);$/, (result, name, parameters) => {
            C[name] = library.func(`${result} ${name}(${parameters.split(", ").map(parameter).join(", ")})`);
        }],
    ];
    for (const [declaration] of text.replace(/\/\*.*?\*\//gs, "").matchAll(/[^;{]+(\{[^}]*\}[^;]*)?;/g)) {
        const line = declaration.trim().replace(/\s+/g, " ");
        const [pattern, declare] = FORMS.find(([form]) => form.test(line));
        declare(...line.match(pattern).slice(1));
    }
    return C;
}

const C = declared(fs.readFileSync(cdefPath, "utf8"), koffi.load(libraryPath));

function make(name) {
    const struct = {};
    assert.equal(C[`${name}_init`](struct, koffi.sizeof(name)), C.HRBFNPR_STATUS_OK);
    return struct;
}

const failure = make("hrbfnpr_error");

function check(status) {
    if (status !== C.HRBFNPR_STATUS_OK) throw new Error(failure.message);
}

// Calls a function whose last parameters are the new handle and the error. Returns the handle.
function made(construct, ...parameters) {
    const out = [null];
    check(construct(...parameters, out, failure));
    return out[0];
}

function array(data) {
    return { data, count: data.length / 3, stride: 0, scalar: C.HRBFNPR_SCALAR_FLOAT64, components: 3 };
}

function readSamples(path) {
    const rows = fs.readFileSync(path, "utf8").trim().split("\n").map((line) => line.split(" ").map(Number));
    const points = rows.flatMap((row) => row.slice(0, 3)), normals = rows.flatMap((row) => row.slice(3));
    return { ...make("hrbfnpr_fit_desc"), points: array(new Float64Array(points)),
        normals: array(new Float64Array(normals)) };
}

// Fits a model while a callback watches the progress.
function fitted(context, desc) {
    const operation = made(C.hrbfnpr_operation_create, context);
    let calls = 0, last = 0;
    const watch = koffi.register((user, progress) => {
        assert(progress >= last && progress <= 1);
        calls += 1;
        last = progress;
        return 0;
    }, "hrbfnpr_progress_fn");
    check(C.hrbfnpr_operation_set_callback(operation, watch, null, failure));
    const model = made(C.hrbfnpr_model_fit, context, desc, operation);
    C.hrbfnpr_operation_release(operation);
    koffi.unregister(watch);
    assert(calls > 0 && last === 1, "the progress callback was not called to the end");
    return model;
}

function generated(context, model) {
    const style = make("hrbfnpr_style"), desc = make("hrbfnpr_generate_desc"), count = [0];
    const preset = C.HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    check(C.hrbfnpr_style_init_preset(style, koffi.sizeof("hrbfnpr_style"), preset, failure));
    desc.layers = C.hrbfnpr_preset_layers(preset, count);
    desc.layer_count = count[0];
    return [style, made(C.hrbfnpr_point_set_generate, context, model, desc, null)];
}

function cameraOf(model) {
    const info = make("hrbfnpr_model_info"), camera = make("hrbfnpr_camera");
    check(C.hrbfnpr_model_get_info(model, info, failure));
    check(C.hrbfnpr_camera_fit_bounds(
        camera, info.bounds_min, info.bounds_max, [0, 1, -1], [0, 0, 1], 0.5, WIDTH, HEIGHT, 0.02, failure));
    return camera;
}

const desc = readSamples(samplesPath);
const context = made(C.hrbfnpr_context_create, null);
const uneven = { ...desc, normals: { ...desc.normals, count: desc.normals.count - 1 } };
assert.throws(() => made(C.hrbfnpr_model_fit, context, uneven, null), /normals/);
const model = fitted(context, desc);
const [style, marks] = generated(context, model);

const renderer = made(C.hrbfnpr_renderer_create, context);
const pixels = Buffer.alloc(4 * WIDTH * HEIGHT);
const item = { ...make("hrbfnpr_item"), point_set: marks, style };
const image = { ...make("hrbfnpr_image"), width: WIDTH, height: HEIGHT, pixels };
const drawing = made(C.hrbfnpr_renderer_draw, renderer, item, 1, 0, cameraOf(model));
check(C.hrbfnpr_drawing_rasterize(drawing, image, null, failure));
fs.writeFileSync(picturePath, pixels);

C.hrbfnpr_drawing_release(drawing);
C.hrbfnpr_renderer_release(renderer);
C.hrbfnpr_point_set_release(marks);
C.hrbfnpr_model_release(model);
C.hrbfnpr_context_release(context);
