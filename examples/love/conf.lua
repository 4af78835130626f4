-- SPDX-License-Identifier: MIT
function love.conf(t)
  t.identity = "hrbfnpr"
  t.version = "11.3" -- for ImageData:getFFIPointer
  t.window.title = "hrbfnpr"
  t.window.width, t.window.height = 640, 480
  t.window.resizable = true
  t.window.highdpi = true
  for _, unused in ipairs { "audio", "sound", "physics", "joystick", "video", "touch", "thread" } do
    t.modules[unused] = false
  end
end
