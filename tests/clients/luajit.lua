-- SPDX-License-Identifier: MIT
-- Draws the scene of reference.c step by step with LuaJIT's FFI: luajit.lua CDEF LIBRARY SAMPLES PICTURE.
-- It uses only the declarations in CDEF.
local ffi = require "ffi"

local cdef_path, library_path, samples_path, picture_path = ...
local WIDTH, HEIGHT = 640, 480

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "*a"
  file:close()
  return text
end

ffi.cdef(read(cdef_path))
local C = ffi.load(library_path)

local function new(name)
  local struct = ffi.new(name)
  assert(C[name .. "_init"](struct, ffi.sizeof(struct)) == C.HRBFNPR_STATUS_OK)
  return struct
end

local failure = new "hrbfnpr_error"

local function check(status)
  if status ~= C.HRBFNPR_STATUS_OK then error(ffi.string(failure.message), 2) end
end

-- Returns the handle that `construct(..., out, failure)` makes. The garbage collector releases it.
local function made(type, release, construct, ...)
  local out = ffi.new(type .. "*[1]")
  local arguments = { n = select("#", ...), ... }
  arguments[arguments.n + 1], arguments[arguments.n + 2] = out, failure
  check(construct(unpack(arguments, 1, arguments.n + 2)))
  return ffi.gc(out[0], release)
end
jit.off(made) -- compiled code must not call functions that call back

local function array(data, count, stride)
  return ffi.new("hrbfnpr_array", { data, count, stride, C.HRBFNPR_SCALAR_FLOAT64, 3 })
end

local function fit_desc(samples, count)
  local desc = new "hrbfnpr_fit_desc"
  desc.points, desc.normals = array(samples, count, 48), array(samples + 3, count, 48)
  return desc
end

-- Fits a model while a callback watches the progress.
local function fitted(context, desc)
  local operation = made("hrbfnpr_operation", C.hrbfnpr_operation_release, C.hrbfnpr_operation_create, context)
  local calls, last = 0, 0
  local watch = ffi.cast("hrbfnpr_progress_fn", function(_, progress)
    assert(progress >= last and progress <= 1)
    calls, last = calls + 1, progress
    return 0
  end)
  check(C.hrbfnpr_operation_set_callback(operation, watch, nil, failure))
  local model = made("hrbfnpr_model", C.hrbfnpr_model_release, C.hrbfnpr_model_fit, context, desc, operation)
  check(C.hrbfnpr_operation_set_callback(operation, nil, nil, failure))
  watch:free()
  assert(calls > 0 and last == 1, "the progress callback was not called to the end")
  return model
end

local function expect_refusal(context, samples, count)
  local desc = fit_desc(samples, count)
  desc.normals.count = count - 1
  local fine, message = pcall(made, "hrbfnpr_model", C.hrbfnpr_model_release, C.hrbfnpr_model_fit, context, desc, nil)
  assert(not fine and message:find "normals", "a failure's message does not name the argument: " .. tostring(message))
end

local numbers = {}
for word in read(samples_path):gmatch "%S+" do
  numbers[#numbers + 1] = assert(tonumber(word))
end
local samples, count = ffi.new("double[?]", #numbers, numbers), #numbers / 6

local context = made("hrbfnpr_context", C.hrbfnpr_context_release, C.hrbfnpr_context_create, nil)
expect_refusal(context, samples, count)
local model = fitted(context, fit_desc(samples, count))

local style, generate = new "hrbfnpr_style", new "hrbfnpr_generate_desc"
local count_of_layers = ffi.new "int64_t[1]"
check(C.hrbfnpr_style_init_preset(style, ffi.sizeof(style), C.HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, failure))
generate.layers = C.hrbfnpr_preset_layers(C.HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, count_of_layers)
generate.layer_count = count_of_layers[0]
local marks = made("hrbfnpr_point_set", C.hrbfnpr_point_set_release, C.hrbfnpr_point_set_generate,
  context, model, generate, nil)

local info, camera = new "hrbfnpr_model_info", new "hrbfnpr_camera"
check(C.hrbfnpr_model_get_info(model, info, failure))
check(C.hrbfnpr_camera_fit_bounds(camera, info.bounds_min, info.bounds_max, ffi.new("double[3]", 0, 1, -1),
  ffi.new("double[3]", 0, 0, 1), 0.5, WIDTH, HEIGHT, 0.02, failure))

local item, image = new "hrbfnpr_item", new "hrbfnpr_image"
local pixels = ffi.new("uint8_t[?]", 4 * WIDTH * HEIGHT)
item.point_set, item.style = marks, style
image.width, image.height, image.pixels = WIDTH, HEIGHT, pixels
local renderer = made("hrbfnpr_renderer", C.hrbfnpr_renderer_release, C.hrbfnpr_renderer_create, context)
local drawing = made("hrbfnpr_drawing", C.hrbfnpr_drawing_release, C.hrbfnpr_renderer_draw,
  renderer, item, 1, 0, camera)
check(C.hrbfnpr_drawing_rasterize(drawing, image, nil, failure))

local picture = assert(io.open(picture_path, "wb"))
assert(picture:write(ffi.string(pixels, ffi.sizeof(pixels))))
assert(picture:close())
