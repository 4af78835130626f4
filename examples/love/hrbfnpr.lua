-- SPDX-License-Identifier: MIT
-- hrbfnpr for LuaJIT: the garbage collector releases objects, and errors are Lua errors.
local ffi = require "ffi"
require "hrbfnpr_cdef"

local C = ffi.load(os.getenv "HRBFNPR_LIBRARY" or "libhrbfnpr")
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

-- Reads lines `x y z nx ny nz`. Returns a double[6 * count] and the count.
function hrbfnpr.samples(text)
  local numbers, count = {}, 0
  for line in text:gmatch "[^\r\n]+" do
    count = count + 1
    for word in line:gmatch "%S+" do
      numbers[#numbers + 1] = tonumber(word)
    end
    if #numbers ~= 6 * count then
      error(("sample %d must be six numbers, x y z nx ny nz, not: %s"):format(count, line:sub(1, 60)), 0)
    end
  end
  return ffi.new("double[?]", #numbers, numbers), count
end

-- The name of a style, or nil if no style has this number.
function hrbfnpr.style_name(preset)
  local name = C.hrbfnpr_preset_name(preset)
  if name ~= nil then return ffi.string(name) end
end

-- A description of the picture: a named style, a size in pixels, and direction and up of the first view, as double[3].
function hrbfnpr.desc(preset, width, height, direction, up)
  local desc = hrbfnpr.new "hrbfnpr_picture_desc"
  desc.preset, desc.width, desc.height = preset, width, height
  for i = 0, 2 do
    desc.direction[i], desc.up[i] = direction[i], up[i]
  end
  return desc
end

-- Makes a picture of samples from hrbfnpr.samples. The library chooses the pen, the marks and the lines.
function hrbfnpr.picture(context, desc, samples, count)
  local source, stride = hrbfnpr.new "hrbfnpr_picture_source", 6 * ffi.sizeof "double"
  source.points = { samples, count, stride, C.HRBFNPR_SCALAR_FLOAT64, 3 }
  source.normals = { samples + 3, count, stride, C.HRBFNPR_SCALAR_FLOAT64, 3 }
  desc.sources, desc.source_count = source, 1
  local out = ffi.new "hrbfnpr_picture*[1]"
  check(C.hrbfnpr_picture_create(context, desc, nil, out, failure))
  return ffi.gc(out[0], C.hrbfnpr_picture_release)
end

-- The same surface in another style or size.
function hrbfnpr.restyle(picture, desc)
  local out = ffi.new "hrbfnpr_picture*[1]"
  check(C.hrbfnpr_picture_restyle(picture, desc, nil, out, failure))
  return ffi.gc(out[0], C.hrbfnpr_picture_release)
end

function hrbfnpr.picture_info(picture)
  local info = hrbfnpr.new "hrbfnpr_picture_info"
  check(C.hrbfnpr_picture_get_info(picture, info, failure))
  return info
end

-- Sets the camera so that the model fills the picture, seen along a direction (double[3]).
function hrbfnpr.look(picture, direction, camera)
  check(C.hrbfnpr_picture_look(picture, direction, 0 / 0, 0 / 0, camera, failure))
end

-- Draws a picture into an hrbfnpr_image.
function hrbfnpr.draw(picture, camera, image)
  local out = ffi.new "hrbfnpr_drawing*[1]"
  check(C.hrbfnpr_picture_draw(picture, camera, nil, out, failure))
  local status = C.hrbfnpr_drawing_rasterize(out[0], image, nil, failure)
  C.hrbfnpr_drawing_release(out[0]) -- release now, so that the next drawing reuses its memory
  check(status)
end

return hrbfnpr
