/* SPDX-License-Identifier: MIT */
/* Draws the scene of examples/README.md with nothing but the C interface: reference SAMPLES PICTURE [steps | all].
 * With the word "steps" it draws a similar scene with the calls below hrbfnpr_picture_create and their defaults. With
 * the word "all" it places all marks, not only those that the picture shows. */
#include <hrbfnpr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1024, WIDTH = 640, HEIGHT = 480 };

static double points[MOST][3], normals[MOST][3];
static unsigned char pixels[HEIGHT][WIDTH][4];
static hrbfnpr_error error;

static void check(hrbfnpr_status status) {
    if (status == HRBFNPR_STATUS_OK) return;
    fprintf(stderr, "%s: %s\n", hrbfnpr_status_name(status), error.message);
    exit(1);
}

static int64_t read_samples(const char* path) {
    FILE* file = fopen(path, "r");
    int64_t count = 0;
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    while (count < MOST) {
        double *p = points[count], *n = normals[count];
        if (fscanf(file, "%lf %lf %lf %lf %lf %lf", p, p + 1, p + 2, n, n + 1, n + 2) != 6) break;
        ++count;
    }
    fclose(file);
    return count;
}

static hrbfnpr_model* fitted(hrbfnpr_context* context, int64_t count) {
    hrbfnpr_fit_desc fit;
    hrbfnpr_model* model;
    check(hrbfnpr_fit_desc_init(&fit, sizeof fit));
    fit.points = (hrbfnpr_array){points, count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    fit.normals = (hrbfnpr_array){normals, count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(hrbfnpr_model_fit(context, &fit, NULL, &model, &error));
    return model;
}

static void draw_by_steps(hrbfnpr_context* context, hrbfnpr_model* model) {
    const double direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    hrbfnpr_style style;
    hrbfnpr_generate_desc generate;
    check(hrbfnpr_generate_desc_init(&generate, sizeof generate));
    generate.layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, &generate.layer_count);
    check(hrbfnpr_style_init_preset(&style, sizeof style, HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, &error));
    hrbfnpr_point_set* marks;
    check(hrbfnpr_point_set_generate(context, model, &generate, NULL, &marks, &error));

    hrbfnpr_model_info info;
    hrbfnpr_camera camera;
    check(hrbfnpr_model_info_init(&info, sizeof info));
    check(hrbfnpr_model_get_info(model, &info, &error));
    check(hrbfnpr_camera_init(&camera, sizeof camera));
    check(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, 0.5, WIDTH, HEIGHT, 0.02,
                                    &error));
    hrbfnpr_item item;
    hrbfnpr_image image;
    hrbfnpr_renderer* renderer;
    hrbfnpr_drawing* drawing;
    check(hrbfnpr_item_init(&item, sizeof item));
    item.point_set = marks;
    item.style = &style;
    check(hrbfnpr_renderer_create(context, &renderer, &error));
    check(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, &error));
    check(hrbfnpr_image_init(&image, sizeof image));
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.pixels = pixels;
    check(hrbfnpr_drawing_rasterize(drawing, &image, NULL, &error));
    hrbfnpr_drawing_release(drawing);
    hrbfnpr_renderer_release(renderer);
    hrbfnpr_point_set_release(marks);
}

static void draw_picture(hrbfnpr_context* context, int64_t count, int all_marks) {
    const double direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    hrbfnpr_picture_source source;
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture* picture;
    hrbfnpr_drawing* drawing;
    hrbfnpr_image image;
    check(hrbfnpr_picture_source_init(&source, sizeof source));
    source.points = (hrbfnpr_array){points, count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    source.normals = (hrbfnpr_array){normals, count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(hrbfnpr_picture_desc_init(&desc, sizeof desc));
    desc.sources = &source;
    desc.source_count = 1;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    if (all_marks) desc.flags |= HRBFNPR_PICTURE_KEEP_MARKS;
    memcpy(desc.direction, direction, sizeof direction);
    memcpy(desc.up, up, sizeof up);
    check(hrbfnpr_picture_create(context, &desc, NULL, &picture, &error));
    check(hrbfnpr_picture_draw(picture, NULL, NULL, &drawing, &error));
    check(hrbfnpr_image_init(&image, sizeof image));
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = WIDTH;
    image.height = HEIGHT;
    image.pixels = pixels;
    check(hrbfnpr_picture_rasterize(picture, drawing, NULL, &image, &error));
    hrbfnpr_drawing_release(drawing);
    hrbfnpr_picture_release(picture);
}

int main(int argc, char** argv) {
    hrbfnpr_context* context;
    FILE* file;
    const int by_steps = argc == 4 && strcmp(argv[3], "steps") == 0;
    const int all_marks = argc == 4 && strcmp(argv[3], "all") == 0;
    if (argc != 3 && !by_steps && !all_marks) return 2;
    check(hrbfnpr_error_init(&error, sizeof error));
    check(hrbfnpr_context_create(NULL, &context, &error));
    const int64_t count = read_samples(argv[1]);
    if (by_steps) {
        hrbfnpr_model* const model = fitted(context, count);
        draw_by_steps(context, model);
        hrbfnpr_model_release(model);
    } else {
        draw_picture(context, count, all_marks);
    }
    hrbfnpr_context_release(context);
    file = fopen(argv[2], "wb");
    if (file == NULL || fwrite(pixels, sizeof pixels, 1, file) != 1) return 1;
    return fclose(file) == 0 ? 0 : 1;
}
