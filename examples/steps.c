/* SPDX-License-Identifier: MIT */
/* 192 samples of a torus become a pen-and-ink drawing, torus.ppm. */
#include <hrbfnpr.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 192, WIDTH = 800, HEIGHT = 600 };

static double points[COUNT][3], normals[COUNT][3];
static unsigned char pixels[HEIGHT][WIDTH][4];
static hrbfnpr_error error;

static void check(hrbfnpr_status status) {
    if (status == HRBFNPR_STATUS_OK) return;
    fprintf(stderr, "%s: %s\n", hrbfnpr_status_name(status), error.message);
    exit(1);
}

static void sample_torus(void) {
    const double turn = 6.283185307179586;
    for (int i = 0; i < COUNT; ++i) {
        const double a = turn * (i / 8) / 24, b = turn * (i % 8) / 8;
        const double n[3] = {cos(a) * cos(b), sin(a) * cos(b), sin(b)}, centre[3] = {cos(a), sin(a), 0};
        for (int k = 0; k < 3; ++k) {
            normals[i][k] = n[k];
            points[i][k] = centre[k] + 0.4 * n[k];
        }
    }
}

int main(void) {
    const double direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    sample_torus();
    check(hrbfnpr_error_init(&error, sizeof error));

    /* The samples become a smooth surface. */
    hrbfnpr_context* context;
    check(hrbfnpr_context_create(NULL, &context, &error));
    hrbfnpr_fit_desc fit;
    check(hrbfnpr_fit_desc_init(&fit, sizeof fit));
    fit.points = (hrbfnpr_array){points, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    fit.normals = (hrbfnpr_array){normals, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    hrbfnpr_model* model;
    check(hrbfnpr_model_fit(context, &fit, NULL, &model, &error));

    /* The marks of a style are placed on it. */
    hrbfnpr_style style;
    check(hrbfnpr_style_init_preset(&style, sizeof style, HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, &error));
    hrbfnpr_generate_desc generate;
    check(hrbfnpr_generate_desc_init(&generate, sizeof generate));
    generate.layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, &generate.layer_count);
    hrbfnpr_point_set* marks;
    check(hrbfnpr_point_set_generate(context, model, &generate, NULL, &marks, &error));

    /* Its contours are found on a line set. */
    hrbfnpr_line_set* lines;
    check(hrbfnpr_line_set_create(context, model, NULL, NULL, &lines, &error));

    /* Both are drawn for a camera. */
    hrbfnpr_model_info info;
    check(hrbfnpr_model_info_init(&info, sizeof info));
    check(hrbfnpr_model_get_info(model, &info, &error));
    hrbfnpr_camera camera;
    check(hrbfnpr_camera_init(&camera, sizeof camera));
    check(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, 0.5, WIDTH, HEIGHT, 0.02,
                                    &error));
    hrbfnpr_item item;
    check(hrbfnpr_item_init(&item, sizeof item));
    item.point_set = marks;
    item.style = &style;
    item.line_set = lines;
    hrbfnpr_renderer* renderer;
    check(hrbfnpr_renderer_create(context, &renderer, &error));
    hrbfnpr_drawing* drawing;
    check(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, &error));
    hrbfnpr_image image;
    check(hrbfnpr_image_init(&image, sizeof image));
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.pixels = pixels;
    check(hrbfnpr_drawing_rasterize(drawing, &image, NULL, &error));

    FILE* file = fopen("torus.ppm", "wb");
    if (file == NULL) return 1;
    fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; ++i) fwrite(pixels[i / WIDTH][i % WIDTH], 1, 3, file);
    fclose(file);

    hrbfnpr_drawing_release(drawing);
    hrbfnpr_renderer_release(renderer);
    hrbfnpr_line_set_release(lines);
    hrbfnpr_point_set_release(marks);
    hrbfnpr_model_release(model);
    hrbfnpr_context_release(context);
    return 0;
}
