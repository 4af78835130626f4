# Draws samples and shows the drawing from all sides.
#
#   drag: turn    wheel: zoom    space: rotate    M: the drawing as a mesh    Escape: quit
#
#   --samples=FILE     lines "x y z nx ny nz" instead of the torus
#   --style=NAME       a style such as etching, instead of contour-and-stipple
#   --mesh             start with the mesh
#   --picture=FILE     save the library's picture and quit (also without a screen: godot3-server)
#   --screenshot=FILE  save the window and quit
#
# Files are PNG, or rows of RGBA8 if the name has another ending.
extends Node

const Drawing = preload("res://drawing.gdns")
const DotsShader = preload("res://marks.shader")
const StrokesShader = preload("res://strokes.shader")
const UP = Vector3(0, 0, 1)

var drawing = Drawing.new()
var picture = Image.new()
var texture = ImageTexture.new()
var azimuth = 0.0
var elevation = PI / 4
var zoom = 1.0
var turning = false
var style = "contour-and-stipple"
var drawn_size = Vector2() # the size of the picture; the window may have another size
var drawn_for = [] # the view for which the current frame was drawn


func _ready():
	var options = read_options()
	style = options.get("style", style)
	if not start(options.get("samples", "res://torus.xyzn")):
		get_tree().quit(1)
		return
	for note in drawing.notes():
		print("note: ", note)
	$Drawing.texture = texture
	if options.has("mesh") and not options.has("picture"):
		show_mesh(true)
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
			print_mesh($Marks.mesh)
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
	drawn_size = get_viewport().size
	return drawing.draw(points, normals, style, direction(), UP, int(drawn_size.x), int(drawn_size.y))


# The direction from the eye into the scene.
func direction():
	return Vector3(sin(azimuth), cos(azimuth), -tan(elevation))


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
				show_mesh(not $Marks.visible)
			KEY_ESCAPE:
				get_tree().quit()


func show_mesh(shown):
	$Marks.visible = shown
	$Drawing.visible = not shown
	drawn_for = []


func update_frame():
	var size = get_viewport().size
	var wanted = [azimuth, elevation, zoom, size]
	if wanted == drawn_for:
		return
	drawn_for = wanted
	if size != drawn_size:
		if not drawing.restyle(style, direction(), UP, int(size.x), int(size.y)):
			return
		drawn_size = size
	if not drawing.look(direction(), zoom):
		return
	if $Marks.visible:
		update_mesh()
	else:
		update_texture(size)


func update_texture(size):
	picture.create_from_data(int(size.x), int(size.y), false, Image.FORMAT_RGBA8, drawing.pixels())
	if texture.get_size() == size:
		texture.set_data(picture)
	else:
		texture.create_from_image(picture, 0) # no filter and no mipmaps


# Shows the drawing under Godot's own camera, so that other objects can stand between its marks.
func update_mesh():
	var mesh = ArrayMesh.new()
	add_surface(mesh, Mesh.PRIMITIVE_POINTS, drawing.points(), DotsShader, 0)
	add_surface(mesh, Mesh.PRIMITIVE_TRIANGLES, drawing.strokes(), StrokesShader, 1)
	$Marks.mesh = mesh
	var box = mesh.get_aabb()
	var eye = drawing.eye()
	var distance = eye.distance_to(box.position + box.size / 2)
	$Camera.look_at_from_position(eye, eye + direction(), UP)
	# The picture is fitted to the model, so its middle can differ from the middle of the view.
	var near = 0.01 * distance
	var seen = near * drawing.frustum()
	$Camera.set_frustum(seen.z, Vector2(seen.x, seen.y), near, 10 * distance)


# Surfaces with a higher priority are drawn over the others.
func add_surface(mesh, primitive, arrays, shader, priority):
	if arrays[Mesh.ARRAY_VERTEX].size() == 0:
		return
	var material = ShaderMaterial.new()
	material.shader = shader
	material.render_priority = priority
	mesh.add_surface_from_arrays(primitive, arrays, [], 0) # 0: no compression of positions and colours
	mesh.surface_set_material(mesh.get_surface_count() - 1, material)


# For tests: prints the numbers of points and triangles of the mesh, and its bounding box.
func print_mesh(mesh):
	var count = { Mesh.PRIMITIVE_POINTS: 0, Mesh.PRIMITIVE_TRIANGLES: 0 }
	for i in mesh.get_surface_count():
		var primitive = mesh.surface_get_primitive_type(i)
		var is_points = primitive == Mesh.PRIMITIVE_POINTS
		count[primitive] = mesh.surface_get_array_len(i) if is_points else mesh.surface_get_array_index_len(i) / 3
	print("mesh of %d points and %d triangles in %s" %
			[count[Mesh.PRIMITIVE_POINTS], count[Mesh.PRIMITIVE_TRIANGLES], mesh.get_aabb()])


func save(image, path):
	if path.ends_with(".png"):
		image.save_png(path)
		return
	var file = File.new()
	if file.open(path, File.WRITE) != OK:
		push_error("cannot write " + path)
	file.store_buffer(image.get_data())
	file.close()
