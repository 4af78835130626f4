shader_type spatial;
// The points come far to near and lie over each other like ink: round, with soft edges.
render_mode unshaded, cull_disabled, depth_test_disable, depth_draw_never;

void vertex() {
	POINT_SIZE = 2.0 * UV.x + 1.0;
}

void fragment() {
	float distance_in_pixels = length(POINT_COORD - vec2(0.5)) * (2.0 * UV.x + 1.0);
	ALBEDO = COLOR.rgb;
	ALPHA = COLOR.a * clamp(UV.x + 0.5 - distance_in_pixels, 0.0, 1.0);
}
