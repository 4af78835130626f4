shader_type spatial;
// The triangles come far to near and lie over each other like ink; UV.x is how far along its stroke a point is, in
// pixels: the ink runs a little dry and wet again, as a brush's does.
render_mode unshaded, cull_disabled, depth_test_disable, depth_draw_never;

void fragment() {
	ALBEDO = COLOR.rgb;
	ALPHA = COLOR.a * (0.95 + 0.05 * sin(0.2 * UV.x));
}
