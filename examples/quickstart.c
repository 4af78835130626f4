/* SPDX-License-Identifier: MIT */
#include <hrbfnpr.h>
#include <math.h>
#include <stdio.h>
static unsigned char rgba[800 * 600 * 4];
static int32_t put(void* file, const void* data, uint64_t size) { return fwrite(data, 1, size, file) != size; }
int main(void) {
    double points[192][3], normals[192][3]; /* of a torus */
    for (int i = 0; i < 192; ++i) {
        const double a = 6.283185307179586 * (i / 8) / 24, b = 6.283185307179586 * (i % 8) / 8;
        const double normal[3] = {cos(a) * cos(b), sin(a) * cos(b), sin(b)}, centre[3] = {cos(a), sin(a), 0};
        for (int k = 0; k < 3; ++k) normals[i][k] = normal[k], points[i][k] = centre[k] + 0.4 * normal[k];
    }
    hrbfnpr_array p = {points, 192, 0, HRBFNPR_SCALAR_FLOAT64, 3}, n = {normals, 192, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    hrbfnpr_error err = {.struct_size = sizeof err};
    hrbfnpr_picture_source source = {.struct_size = sizeof source, .points = p, .normals = n};
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture_desc_init(&desc, sizeof desc); /* sets every field to its default */
    desc.sources = &source, desc.source_count = 1, desc.width = 800, desc.height = 600, desc.style_name = "engraving";
    const hrbfnpr_image image = {sizeof image, HRBFNPR_FORMAT_RGBA8, 800, 600, rgba, 0};
    hrbfnpr_context* context;
    hrbfnpr_picture* picture;
    hrbfnpr_drawing* drawing;
    FILE* file = fopen("torus.svg", "wb");
    if (hrbfnpr_context_create(NULL, &context, &err) || hrbfnpr_picture_create(context, &desc, NULL, &picture, &err) ||
        hrbfnpr_picture_draw(picture, NULL, NULL, &drawing, &err) ||
        hrbfnpr_picture_rasterize(picture, drawing, NULL, &image, &err) || !file ||
        hrbfnpr_picture_write(picture, drawing, NULL, NULL, put, file, NULL, NULL, &err))
        return fprintf(stderr, "%s\n", err.message) != 0;
    return fclose(file);
}
