-- SPDX-License-Identifier: MIT
-- hrbfnpr for LuaJIT: what the garbage collector collects is released, and failures are Lua errors.
local ffi = require "ffi"
require "hrbfnpr_cdef"

local C = ffi.load(os.getenv "HRBFNPR_LIBRARY" or "hrbfnpr")
assert(C.hrbfnpr_abi_version() == C.HRBFNPR_ABI_VERSION, "hrbfnpr_cdef.lua is not of this library's version")

local hrbfnpr = { C = C }

-- A struct with the library's defaults.
function hrbfnpr.new(name)
  local struct = ffi.new(name)
  C[name .. "_init"](struct, ffi.sizeof(struct))
  return struct
end

local failure = hrbfnpr.new "hrbfnpr_error"

local function check(status)
  if status ~= C.HRBFNPR_STATUS_OK then
    local name = ffi.string(C.hrbfnpr_status_name(status))
    error(("%s: %s"):format(name, ffi.string(failure.message)), 0)
  end
end

function hrbfnpr.context()
  local out = ffi.new "hrbfnpr_context*[1]"
  check(C.hrbfnpr_context_create(nil, out, failure))
  return ffi.gc(out[0], C.hrbfnpr_context_release)
end

-- Reads lines `x y z nx ny nz`: a double[6 * count], and the count.
function hrbfnpr.samples(text)
  local numbers, count = {}, 0
  for line in text:gmatch "[^\r\n]+" do
    count = count + 1
    for word in line:gmatch "%S+" do
      numbers[#numbers + 1] = tonumber(word)
    end
    if #numbers ~= 6 * count then
      error(("sample %d is not six numbers, x y z nx ny nz: %s"):format(count, line:sub(1, 60)), 0)
    end
  end
  return ffi.new("double[?]", #numbers, numbers), count
end

-- Fits a surface to samples as hrbfnpr.samples returns them.
function hrbfnpr.fit(context, samples, count)
  local desc = hrbfnpr.new "hrbfnpr_fit_desc"
  local stride = 6 * ffi.sizeof "double"
  desc.points = { samples, count, stride, C.HRBFNPR_SCALAR_FLOAT64, 3 }
  desc.normals = { samples + 3, count, stride, C.HRBFNPR_SCALAR_FLOAT64, 3 }
  local out = ffi.new "hrbfnpr_model*[1]"
  check(C.hrbfnpr_model_fit(context, desc, nil, out, failure))
  return ffi.gc(out[0], C.hrbfnpr_model_release)
end

function hrbfnpr.model_info(model)
  local info = hrbfnpr.new "hrbfnpr_model_info"
  check(C.hrbfnpr_model_get_info(model, info, failure))
  return info
end

-- A named style, HRBFNPR_PRESET_...
function hrbfnpr.style(preset)
  local style = ffi.new "hrbfnpr_style"
  check(C.hrbfnpr_style_init_preset(style, ffi.sizeof(style), preset, failure))
  return style
end

-- The style's name, or nil if no style has this number.
function hrbfnpr.style_name(preset)
  local name = C.hrbfnpr_preset_name(preset)
  if name ~= nil then return ffi.string(name) end
end

-- Places the marks that a named style draws on the surface.
function hrbfnpr.generate(context, model, preset)
  local desc, count = hrbfnpr.new "hrbfnpr_generate_desc", ffi.new "int64_t[1]"
  desc.layers = C.hrbfnpr_preset_layers(preset, count)
  desc.layer_count = count[0]
  local out = ffi.new "hrbfnpr_point_set*[1]"
  check(C.hrbfnpr_point_set_generate(context, model, desc, nil, out, failure))
  return ffi.gc(out[0], C.hrbfnpr_point_set_release)
end

-- Sets the camera so that the box fills the picture; vectors are double[3].
function hrbfnpr.fit_bounds(camera, minimum, maximum, direction, up, vertical_angle, width, height, margin)
  check(C.hrbfnpr_camera_fit_bounds(
    camera, minimum, maximum, direction, up, vertical_angle, width, height, margin, failure))
end

function hrbfnpr.renderer(context)
  local out = ffi.new "hrbfnpr_renderer*[1]"
  check(C.hrbfnpr_renderer_create(context, out, failure))
  return ffi.gc(out[0], C.hrbfnpr_renderer_release)
end

-- Draws an hrbfnpr_item into an hrbfnpr_image.
function hrbfnpr.draw(renderer, item, camera, image)
  local out = ffi.new "hrbfnpr_drawing*[1]"
  check(C.hrbfnpr_renderer_draw(renderer, item, 1, 0, camera, out, failure))
  local status = C.hrbfnpr_drawing_rasterize(out[0], image, nil, failure)
  C.hrbfnpr_drawing_release(out[0]) -- at once: the next drawing is made in its memory
  check(status)
end

return hrbfnpr
