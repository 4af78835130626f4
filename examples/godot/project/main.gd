# Samples become a drawing, seen from all sides.
#
#   drag: turn    wheel: zoom    space: turn by itself    M: the marks as points of a mesh    Escape: quit
#
#   --samples=FILE     lines "x y z nx ny nz" in place of the torus
#   --marks            start with the mesh
#   --strokes          draw strokes, in the style etching, and start with their mesh
#   --picture=FILE     save the library's picture and quit (also without a screen: godot3-server)
#   --screenshot=FILE  save the window and quit
#
# Files are PNG, or rows of RGBA8 where the name does not end so.
extends Node

const Drawing = preload("res://drawing.gdns")
const UP = Vector3(0, 0, 1)

var drawing = Drawing.new()
var picture = Image.new()
var texture = ImageTexture.new()
var azimuth = 0.0
var elevation = PI / 4
var zoom = 1.0
var turning = false
var strokes = false # the mesh is of triangles of strokes
var drawn_for = [] # what the frame on the screen shows


func _ready():
	var options = read_options()
	strokes = options.has("strokes")
	if not start(options.get("samples", "res://torus.xyzn")):
		get_tree().quit(1)
		return
	$Drawing.texture = texture
	if strokes:
		$Marks.material_override = ShaderMaterial.new()
		$Marks.material_override.shader = preload("res://strokes.shader")
	if (options.has("marks") or strokes) and not options.has("picture"):
		show_marks(true)
	update_frame()
	if options.has("picture"):
		save(picture, options.picture)
		get_tree().quit()
	if options.has("screenshot"):
		yield(VisualServer, "frame_post_draw")
		var image = get_viewport().get_texture().get_data()
		image.flip_y()
		image.convert(Image.FORMAT_RGBA8)
		save(image, options.screenshot)
		if $Marks.visible:
			var count = $Marks.mesh.surface_get_array_len(0)
			print("mesh of %d points in %s" % [count, $Marks.get_aabb()])
			if strokes:
				print("%d triangles" % ($Marks.mesh.surface_get_array_index_len(0) / 3))
		get_tree().quit()


func read_options():
	var options = {}
	for argument in OS.get_cmdline_args():
		var parts = argument.trim_prefix("--").split("=", true, 1)
		options[parts[0]] = parts[1] if parts.size() > 1 else ""
	return options


func start(path):
	var file = File.new()
	if file.open(path, File.READ) != OK:
		push_error("cannot read " + path)
		return false
	var points = PoolVector3Array()
	var normals = PoolVector3Array()
	while not file.eof_reached():
		var n = file.get_line().split_floats(" ", false)
		if n.size() == 6:
			points.append(Vector3(n[0], n[1], n[2]))
			normals.append(Vector3(n[3], n[4], n[5]))
	return drawing.fit(points, normals) and drawing.mark("etching" if strokes else "contour-and-stipple", 0)


func _process(delta):
	if turning:
		azimuth += 0.5 * delta
	update_frame()


func _input(event):
	if event is InputEventMouseMotion and event.button_mask & BUTTON_MASK_LEFT:
		azimuth -= 0.01 * event.relative.x
		elevation = clamp(elevation + 0.01 * event.relative.y, -1.5, 1.5)
	elif event is InputEventMouseButton and event.pressed and event.button_index == BUTTON_WHEEL_UP:
		zoom = min(zoom * 1.1, 20.0)
	elif event is InputEventMouseButton and event.pressed and event.button_index == BUTTON_WHEEL_DOWN:
		zoom = max(zoom / 1.1, 0.1)
	elif event is InputEventKey and event.pressed and not event.echo:
		match event.scancode:
			KEY_SPACE:
				turning = not turning
			KEY_M:
				show_marks(not $Marks.visible)
			KEY_ESCAPE:
				get_tree().quit()


func show_marks(shown):
	$Marks.visible = shown
	$Drawing.visible = not shown
	drawn_for = []


func update_frame():
	var size = get_viewport().size
	var wanted = [azimuth, elevation, zoom, size]
	if wanted == drawn_for:
		return
	drawn_for = wanted
	var direction = Vector3(sin(azimuth), cos(azimuth), -tan(elevation))
	if not drawing.look(direction, UP, zoom, int(size.x), int(size.y)):
		return
	if $Marks.visible:
		update_mesh(direction)
	else:
		update_texture(size)


func update_texture(size):
	picture.create_from_data(int(size.x), int(size.y), false, Image.FORMAT_RGBA8, drawing.pixels())
	if texture.get_size() == size:
		texture.set_data(picture)
	else:
		texture.create_from_image(picture, 0) # no filter, no mipmaps: pixel for pixel


# The marks under Godot's own camera: other things of the scene can stand between them.
func update_mesh(direction):
	var mesh = ArrayMesh.new()
	var arrays = drawing.strokes() if strokes else drawing.points()
	# 0: positions and colours as they are.
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES if strokes else Mesh.PRIMITIVE_POINTS, arrays, [], 0)
	$Marks.mesh = mesh
	var box = mesh.get_aabb()
	var eye = drawing.eye()
	var distance = eye.distance_to(box.position + box.size / 2)
	$Camera.look_at_from_position(eye, eye + direction, UP)
	$Camera.fov = drawing.angle()
	$Camera.near = 0.01 * distance
	$Camera.far = 10 * distance


func save(image, path):
	if path.ends_with(".png"):
		image.save_png(path)
		return
	var file = File.new()
	if file.open(path, File.WRITE) != OK:
		push_error("cannot write " + path)
	file.store_buffer(image.get_data())
	file.close()
