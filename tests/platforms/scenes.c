/* SPDX-License-Identifier: MIT */
/* Draws small pictures and prints a hash of each: scenes [baseline [FOLDER]].
 *
 * The samples are rational functions of whole numbers, so they have the same bits on all platforms. With the word
 * "baseline" the context uses the least instruction set of its processor. Three styles are also drawn by three threads,
 * and the program fails if these pictures differ. Metadata name the compiler, so they are left out of the hashes. With
 * FOLDER it also writes the drawings there as SVG. */
#include <hrbfnpr.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { AROUND = 24, ALONG = 12, COUNT = AROUND * ALONG, WIDTH = 240, HEIGHT = 180, MOST_PIXELS = 512 * 512 };

static double points[COUNT][3], normals[COUNT][3];
static unsigned char pixels[2][MOST_PIXELS][4];
static size_t pixels_size;
static char text[2][1 << 22];
static size_t text_size[2];
static hrbfnpr_error error;

static void check(hrbfnpr_status status, const char* what) {
    if (status == HRBFNPR_STATUS_OK) return;
    fprintf(stderr, "%s: %s: %s\n", what, hrbfnpr_status_name(status), error.message);
    exit(1);
}

static unsigned hash(const void* data, size_t size) { /* FNV-1a */
    const unsigned char* bytes = (const unsigned char*)data;
    unsigned h = 2166136261u;
    for (size_t i = 0; i < size; ++i) h = (h ^ bytes[i]) * 16777619u;
    return h;
}

/* Sets a point of the unit circle for i of `count` steps, by the rational parametrization of a quarter. */
static void circle(int i, int count, double* c, double* s) {
    const int quarter = count / 4;
    const double t = (double)(i % quarter) / quarter;
    const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    switch (i / quarter) {
    case 0: *c = x, *s = y; break;
    case 1: *c = -y, *s = x; break;
    case 2: *c = -x, *s = -y; break;
    default: *c = y, *s = -x;
    }
}

static void make_torus(void) {
    for (int i = 0; i < COUNT; ++i) {
        double ca, sa, cb, sb;
        circle(i / ALONG, AROUND, &ca, &sa);
        circle(i % ALONG, ALONG, &cb, &sb);
        const double normal[3] = {ca * cb, sa * cb, sb}, centre[3] = {ca, sa, 0};
        for (int k = 0; k < 3; ++k) {
            normals[i][k] = normal[k];
            points[i][k] = centre[k] + 0.4 * normal[k];
        }
    }
}

static hrbfnpr_context* make_context(int threads, int baseline) {
    hrbfnpr_context_desc desc;
    hrbfnpr_context* context = NULL;
    check(hrbfnpr_context_desc_init(&desc, sizeof desc), "context_desc");
    desc.thread_count = threads;
    if (baseline) desc.highest_instruction_set = HRBFNPR_INSTRUCTION_SET_BASELINE;
    check(hrbfnpr_context_create(&desc, &context, &error), "context");
    return context;
}

static int32_t append(void* which, const void* data, uint64_t size) {
    const int i = *(const int*)which;
    if (text_size[i] + size >= sizeof text[i]) return 1;
    memcpy(text[i] + text_size[i], data, (size_t)size);
    text_size[i] += (size_t)size;
    return 0;
}

static void leave_out_metadata(int which) {
    static const char begin[] = "<metadata>", end[] = "</metadata>";
    text[which][text_size[which]] = '\0';
    char* const from = strstr(text[which], begin);
    char* const to = from != NULL ? strstr(from, end) : NULL;
    if (to == NULL) exit(1);
    text_size[which] -= (size_t)(to - from);
    memmove(from, to, text_size[which] - (size_t)(from - text[which]));
}

static void draw(hrbfnpr_context* context, uint32_t preset, int which) {
    const double direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    hrbfnpr_picture_source source;
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture* picture;
    hrbfnpr_drawing* drawing;
    hrbfnpr_image image;
    check(hrbfnpr_picture_source_init(&source, sizeof source), "source");
    source.points = (hrbfnpr_array){points, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    source.normals = (hrbfnpr_array){normals, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(hrbfnpr_picture_desc_init(&desc, sizeof desc), "picture_desc");
    desc.sources = &source;
    desc.source_count = 1;
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.preset = preset;
    memcpy(desc.direction, direction, sizeof direction);
    memcpy(desc.up, up, sizeof up);
    check(hrbfnpr_picture_create(context, &desc, NULL, &picture, &error), "picture");
    check(hrbfnpr_picture_draw(picture, NULL, NULL, &drawing, &error), "drawing");
    check(hrbfnpr_image_init(&image, sizeof image), "image");
    image.format = HRBFNPR_FORMAT_RGBA8;
    check(hrbfnpr_picture_plate_size(picture, NULL, &image.width, &image.height, &error), "plate");
    pixels_size = (size_t)image.width * (size_t)image.height * 4;
    if (pixels_size > sizeof pixels[0]) exit(1);
    image.pixels = pixels[which];
    check(hrbfnpr_picture_rasterize(picture, drawing, NULL, &image, &error), "pixels");
    text_size[which] = 0;
    check(hrbfnpr_picture_write(picture, drawing, NULL, NULL, append, &which, NULL, NULL, &error), "svg");
    leave_out_metadata(which);
    hrbfnpr_drawing_release(drawing);
    hrbfnpr_picture_release(picture);
}

/* Prints the message of an error, which contains whole numbers and fractions. */
static void print_messages(hrbfnpr_context* context) {
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture* picture = NULL;
    hrbfnpr_fit_desc fit;
    hrbfnpr_model* model = NULL;
    double twice[2][3] = {{0, 0, 0}, {1e-5, 0, 0}};
    check(hrbfnpr_picture_desc_init(&desc, sizeof desc), "picture_desc");
    desc.width = 40000;
    desc.height = 10;
    hrbfnpr_picture_create(context, &desc, NULL, &picture, &error);
    printf("message %s\n", error.message);
    check(hrbfnpr_fit_desc_init(&fit, sizeof fit), "fit_desc");
    fit.points = (hrbfnpr_array){twice, 2, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    fit.normals = (hrbfnpr_array){twice, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    hrbfnpr_model_fit(context, &fit, NULL, &model, &error);
    printf("message %s\n", error.message);
    fit.normals = (hrbfnpr_array){twice, 2, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    fit.regularization = -1.5e-7;
    hrbfnpr_model_fit(context, &fit, NULL, &model, &error);
    printf("message %s\n", error.message);
}

static void write_svg(const char* folder, const char* name) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.svg", folder, name);
    FILE* const file = fopen(path, "wb");
    if (file == NULL || fwrite(text[0], text_size[0], 1, file) != 1 || fclose(file) != 0) exit(1);
}

int main(int argc, char** argv) {
    static const char* const names[] = {
        "stipple", "hatch",     "cross-hatch",   "combing", "silhouette", "contour-and-stipple",
        "x-ray",   "full",      "engraving",     "etching", "woodcut",    "scientific-stipple",
        "sketch",  "blueprint", "archaeological"};
    const int baseline = argc >= 2 && strcmp(argv[1], "baseline") == 0;
    hrbfnpr_context* contexts[2];
    check(hrbfnpr_error_init(&error, sizeof error), "error");
    make_torus();
    for (int i = 0; i < 2; ++i) contexts[i] = make_context(i == 0 ? 1 : 3, baseline);
    print_messages(contexts[0]);
    for (uint32_t preset = 0; preset < sizeof names / sizeof names[0]; ++preset) {
        const int by_threads =
            preset == HRBFNPR_PRESET_STIPPLE || preset == HRBFNPR_PRESET_FULL || preset == HRBFNPR_PRESET_ENGRAVING;
        draw(contexts[0], preset, 0);
        if (by_threads) draw(contexts[1], preset, 1);
        if (by_threads && (memcmp(pixels[0], pixels[1], pixels_size) != 0 || text_size[0] != text_size[1] ||
                           memcmp(text[0], text[1], text_size[0]) != 0)) {
            fprintf(stderr, "%s: one thread and three threads draw different pictures\n", names[preset]);
            return 1;
        }
        if (argc == 3) write_svg(argv[2], names[preset]);
        printf("%s pixels %08x svg %08x\n", names[preset], hash(pixels[0], pixels_size), hash(text[0], text_size[0]));
        fflush(stdout);
    }
    for (int i = 0; i < 2; ++i) hrbfnpr_context_release(contexts[i]);
    return 0;
}
