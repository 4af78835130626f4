-- SPDX-License-Identifier: MIT
-- A surface in pen and ink, drawn directly into LÖVE's ImageData. The keys are listed in README.md.
-- Arguments: the file of samples, and optionally a file for a screenshot.
local function parse(arguments)
  local samples, screenshot = love.filesystem.getSource() .. "/../torus.xyzn", nil
  local i = 1
  while arguments[i] do
    if arguments[i] == "--screenshot" then
      screenshot = assert(arguments[i + 1], "--screenshot needs a file name")
      i = i + 1
    else
      samples = arguments[i]
    end
    i = i + 1
  end
  return samples, screenshot
end

local samples_path, screenshot_path = parse(love.arg.parseGameArguments(arg))
if screenshot_path then -- a test must not wait at LÖVE's error screen
  function love.errorhandler(message)
    io.stderr:write(debug.traceback(message, 2), "\n")
  end
end

local ffi = require "ffi"
local hrbfnpr = require "hrbfnpr"

local TURN = 0.01 -- radians per pixel of dragging
local ROTATION = 0.5 -- radians per second
local UP = ffi.new("double[3]", 0, 0, 1)
local FIRST_DIRECTION = ffi.new("double[3]", 0, 1, -1)

local context = hrbfnpr.context()

-- Objects that every frame uses are made once.
local camera = hrbfnpr.new "hrbfnpr_camera"
local image = hrbfnpr.new "hrbfnpr_image"
local direction = ffi.new "double[3]"

-- `image` holds a plain pointer; `canvas` keeps the memory alive.
local scene
local canvas = {}
local view, rotating, changed

local function reset_view()
  view = { turn = 0, tilt = 0, zoom = 1 } -- turn and tilt are angles relative to the first view
  changed = true
end

-- The description of a picture in the style with this number.
local function desc_of(preset)
  return hrbfnpr.desc(preset, image.width, image.height, FIRST_DIRECTION, UP)
end

local function show(picture)
  scene = { picture = picture, info = hrbfnpr.picture_info(picture) }
  changed = true
end

-- Shows the surface in another style or size. If this fails, nothing changes.
local function restyle(preset)
  show(hrbfnpr.restyle(scene.picture, desc_of(preset)))
end

local function show_samples(text, preset)
  show(hrbfnpr.picture(context, desc_of(preset), hrbfnpr.samples(text)))
  reset_view()
end

-- Makes the ImageData for drawing, as large as the window in pixels.
local function make_canvas()
  local width, height = love.graphics.getPixelDimensions()
  if canvas.image then
    canvas.image:release()
    canvas.data:release()
  end
  canvas.data = love.image.newImageData(width, height)
  canvas.image = love.graphics.newImage(canvas.data, { dpiscale = love.graphics.getDPIScale() })
  image.width, image.height = width, height
  image.pixels = canvas.data:getFFIPointer()
  if scene then restyle(scene.info.preset) end -- another size needs other marks
end

-- Fits the model to the picture, seen along `direction`. Returns the camera's distance from the model's middle.
local function fit_camera(direction)
  local low, high, view_matrix = scene.info.bounds_min, scene.info.bounds_max, camera.view
  hrbfnpr.look(scene.picture, direction, camera)
  local z = view_matrix[14]
  for i = 0, 2 do
    z = z + view_matrix[4 * i + 2] * (low[i] + high[i]) / 2
  end
  return -z
end

-- The first view, tilted about the x axis and turned about the z axis.
local function place_camera()
  local forward = math.cos(view.tilt) + math.sin(view.tilt)
  direction[0], direction[1] = forward * math.sin(view.turn), forward * math.cos(view.turn)
  direction[2] = math.sin(view.tilt) - math.cos(view.tilt)
  local first_distance = fit_camera(FIRST_DIRECTION)
  -- The model fills the picture differently from each side; keep its size constant.
  local scale = view.zoom * fit_camera(direction) / first_distance
  camera.projection[0] = camera.projection[0] * scale
  camera.projection[5] = camera.projection[5] * scale
end

local function draw_scene()
  local start = love.timer.getTime()
  place_camera()
  hrbfnpr.draw(scene.picture, camera, image)
  canvas.image:replacePixels(canvas.data)
  local name = hrbfnpr.style_name(scene.info.preset)
  love.window.setTitle(("hrbfnpr: %s, %.1f ms"):format(name, 1000 * (love.timer.getTime() - start)))
end

local function read_file(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "*a"
  file:close()
  return text
end

-- Saves the window's contents after the next frame, and quits.
local function save_and_quit(path)
  love.graphics.captureScreenshot(function(shot)
    local file = assert(io.open(path, "wb"))
    assert(file:write(shot:encode("png"):getString()))
    assert(file:close())
    love.event.quit()
  end)
end

function love.load()
  make_canvas()
  show_samples(read_file(samples_path), hrbfnpr.C.HRBFNPR_PRESET_CONTOUR_AND_STIPPLE)
  if screenshot_path then save_and_quit(screenshot_path) end
end

function love.update(seconds)
  if rotating then
    view.turn = view.turn + ROTATION * seconds
    changed = true
  end
  if changed then
    draw_scene()
    changed = false
  end
end

function love.draw()
  love.graphics.draw(canvas.image)
end

love.resize = make_canvas

function love.mousemoved(_, _, dx, dy)
  if not love.mouse.isDown(1) then return end
  view.turn = view.turn + TURN * dx
  view.tilt = math.max(-0.24 * math.pi, math.min(view.tilt - TURN * dy, 0.74 * math.pi)) -- stop before the poles
  changed = true
end

function love.wheelmoved(_, y)
  view.zoom = math.max(0.2, math.min(view.zoom * 1.1 ^ y, 50))
  changed = true
end

function love.keypressed(key)
  if key == "tab" then
    local next = scene.info.preset + 1
    restyle(hrbfnpr.style_name(next) and next or 0)
  elseif key == "space" then
    rotating = not rotating
  elseif key == "home" then
    reset_view()
  elseif key == "s" then
    local name = os.date "hrbfnpr-%Y-%m-%d-%H%M%S.png"
    love.graphics.captureScreenshot(name)
    print("saved " .. love.filesystem.getSaveDirectory() .. "/" .. name)
  elseif key == "escape" then
    love.event.quit()
  end
end

function love.filedropped(file)
  assert(file:open "r")
  local shown, message = pcall(show_samples, file:read(), scene.info.preset)
  file:close()
  if not shown then love.window.showMessageBox("hrbfnpr", tostring(message), "error") end
end
