/* SPDX-License-Identifier: MIT */
/* hrbfnpr in a window.
 *
 *     sdl2 [--strokes] [--screenshot FILE] [SAMPLES.xyzn]
 *
 * SAMPLES has a line `x y z nx ny nz` for each sample. A worker thread makes a picture of them; Escape cancels it.
 * Then: drag to turn, wheel to zoom, space for a turntable, Tab for the next style, Escape to end.
 * S switches from the image to the strokes alone, as triangles with the texture of a brush. --strokes starts with them.
 * --screenshot writes the first picture to FILE, *.bmp or raw RGBA rows, and ends. */
#include <SDL.h>
#include <hrbfnpr.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VALUES = 6, /* numbers of a sample */ BRUSH_LENGTH = 1024, BRUSH_WIDTH = 16 /* pixels */ };

/* The share of the brush's width where its ink has at least half strength. Strokes are widened by 1 / SOLID. */
static const float SOLID = 0.75f;

/* The worker's data. While the worker is busy, the main thread uses only the operation. */
typedef struct Drawing {
    double* samples;
    int64_t count;
    uint32_t preset;
    int width, height; /* size of the window when the worker started */
    hrbfnpr_context* context;
    hrbfnpr_operation* operation;
    hrbfnpr_picture* picture;
    hrbfnpr_picture_info info;
    hrbfnpr_status status;
    hrbfnpr_error error;
    SDL_atomic_t is_done;
} Drawing;

/* The viewer's position: the direction into the scene is (sin turn, cos turn, -height). */
typedef struct View {
    double turn, height, zoom;
    SDL_bool turntable;
} View;

typedef struct App {
    SDL_Window* window;
    SDL_Renderer* screen;
    SDL_Texture* texture;
    int width, height;
    Drawing drawing;
    SDL_Thread* worker; /* NULL: the drawing is ready */
    View view;
    SDL_Texture* brush;
    SDL_bool shows_strokes, is_stale, quits;
} App;

static void fail(const char* what, const char* why) {
    fprintf(stderr, "%s: %s\n", what, why);
    exit(1);
}

static void check(hrbfnpr_status status, const hrbfnpr_error* error) {
    if (status != HRBFNPR_STATUS_OK) fail(hrbfnpr_status_name(status), error->message);
}

static void check_sdl(int is_fine) {
    if (!is_fine) fail("SDL", SDL_GetError());
}

static void read_samples(const char* path, Drawing* drawing) {
    FILE* const file = fopen(path, "r");
    int64_t capacity = 0;
    if (file == NULL) fail(path, "cannot be opened; check the name");
    for (;; ++drawing->count) {
        if (drawing->count == capacity) {
            capacity = 2 * capacity + 1024;
            drawing->samples = realloc(drawing->samples, (size_t)capacity * VALUES * sizeof(double));
            if (drawing->samples == NULL) fail(path, "has too many samples for the memory");
        }
        double* const s = drawing->samples + VALUES * drawing->count;
        if (fscanf(file, "%lf %lf %lf %lf %lf %lf", s, s + 1, s + 2, s + 3, s + 4, s + 5) != VALUES) break;
    }
    if (!feof(file)) fail(path, "has a line that is not six numbers, x y z nx ny nz");
    fclose(file);
}

/* The long call, on the worker thread. It makes a picture of the samples, and later restyles it for other styles and
 * sizes. The library chooses the pen, the marks and the lines. */
static hrbfnpr_status make_picture(Drawing* d) {
    const int64_t stride = VALUES * (int64_t)sizeof(double);
    const double direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    hrbfnpr_picture* const before = d->picture;
    hrbfnpr_picture_source source;
    hrbfnpr_picture_desc desc;
    hrbfnpr_status status;
    hrbfnpr_picture_desc_init(&desc, sizeof desc);
    desc.preset = d->preset;
    desc.width = d->width;
    desc.height = d->height;
    memcpy(desc.direction, direction, sizeof direction);
    memcpy(desc.up, up, sizeof up);
    if (before != NULL) {
        status = hrbfnpr_picture_restyle(before, &desc, d->operation, &d->picture, &d->error);
    } else {
        hrbfnpr_picture_source_init(&source, sizeof source);
        source.points = (hrbfnpr_array){d->samples, d->count, stride, HRBFNPR_SCALAR_FLOAT64, 3};
        source.normals = (hrbfnpr_array){d->samples + 3, d->count, stride, HRBFNPR_SCALAR_FLOAT64, 3};
        desc.sources = &source;
        desc.source_count = 1;
        status = hrbfnpr_picture_create(d->context, &desc, d->operation, &d->picture, &d->error);
    }
    if (status != HRBFNPR_STATUS_OK) return status;
    hrbfnpr_picture_release(before);
    hrbfnpr_picture_info_init(&d->info, sizeof d->info);
    return hrbfnpr_picture_get_info(d->picture, &d->info, &d->error);
}

static int SDLCALL work(void* user) {
    Drawing* const d = user;
    d->status = make_picture(d);
    SDL_AtomicSet(&d->is_done, 1);
    return 0;
}

static void start_work(App* app) {
    SDL_GetRendererOutputSize(app->screen, &app->drawing.width, &app->drawing.height);
    SDL_AtomicSet(&app->drawing.is_done, 0);
    app->worker = SDL_CreateThread(work, "drawing", &app->drawing);
    check_sdl(app->worker != NULL);
}

static void end_work(App* app) {
    Drawing* const d = &app->drawing;
    SDL_WaitThread(app->worker, NULL);
    app->worker = NULL;
    check(d->status, &d->error);
    SDL_SetWindowTitle(app->window, hrbfnpr_preset_name(d->preset));
    app->is_stale = SDL_TRUE;
}

/* ---- Input ---- */

static void press_key(App* app, SDL_Keycode key) {
    if (key == SDLK_ESCAPE) app->quits = SDL_TRUE;
    if (key == SDLK_s) app->shows_strokes = !app->shows_strokes;
    if (key == SDLK_SPACE) app->view.turntable = !app->view.turntable;
    if (key == SDLK_TAB && app->worker == NULL) {
        if (hrbfnpr_preset_name(++app->drawing.preset) == NULL) app->drawing.preset = 0;
        start_work(app);
    }
}

static void handle(App* app, const SDL_Event* event) {
    View* const view = &app->view;
    app->is_stale = SDL_TRUE;
    if (event->type == SDL_QUIT) app->quits = SDL_TRUE;
    if (event->type == SDL_KEYDOWN) press_key(app, event->key.keysym.sym);
    if (event->type == SDL_MOUSEWHEEL) view->zoom *= pow(1.1, event->wheel.y);
    if (event->type == SDL_MOUSEMOTION && (event->motion.state & SDL_BUTTON_LMASK) != 0) {
        view->turn += 0.01 * event->motion.xrel;
        view->height = fmin(fmax(view->height + 0.01 * event->motion.yrel, -5), 5);
    }
}

/* ---- Output ---- */

static void show_progress(App* app) {
    const double progress = hrbfnpr_operation_progress(app->drawing.operation);
    const SDL_Rect bar = {0, app->height / 2 - 8, (int)(app->width * progress), 16};
    char title[64];
    snprintf(title, sizeof title, "fitting: %.0f %% (Escape cancels)", 100 * progress);
    SDL_SetWindowTitle(app->window, title);
    SDL_SetRenderDrawColor(app->screen, 255, 255, 255, 255);
    SDL_RenderClear(app->screen);
    SDL_SetRenderDrawColor(app->screen, 0, 0, 0, 255);
    SDL_RenderFillRect(app->screen, &bar);
}

static void fit_texture(App* app) {
    int width, height;
    SDL_GetRendererOutputSize(app->screen, &width, &height);
    if (app->texture != NULL && width == app->width && height == app->height) return;
    if (app->texture != NULL) SDL_DestroyTexture(app->texture);
    app->texture = SDL_CreateTexture(app->screen, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STREAMING, width, height);
    check_sdl(app->texture != NULL);
    app->width = width;
    app->height = height;
}

static hrbfnpr_camera camera_from(App* app, double turn, double height) {
    Drawing* const d = &app->drawing;
    const double direction[3] = {sin(turn), cos(turn), -height};
    hrbfnpr_camera camera;
    hrbfnpr_camera_init(&camera, sizeof camera);
    check(hrbfnpr_picture_look(d->picture, direction, NAN, NAN, &camera, &d->error), &d->error);
    return camera;
}

static double distance_of_centre(const App* app, const hrbfnpr_camera* camera) {
    const hrbfnpr_picture_info* const info = &app->drawing.info;
    double z = camera->view[14];
    for (int axis = 0; axis < 3; ++axis)
        z += camera->view[2 + 4 * axis] * 0.5 * (info->bounds_min[axis] + info->bounds_max[axis]);
    return -z;
}

/* The model fills the picture in the first view, and keeps its size when it is turned. */
static hrbfnpr_camera camera_of(App* app) {
    const hrbfnpr_camera first = camera_from(app, 0, 1);
    hrbfnpr_camera camera = camera_from(app, app->view.turn, app->view.height);
    const double scale = app->view.zoom * distance_of_centre(app, &camera) / distance_of_centre(app, &first);
    camera.projection[0] *= scale;
    camera.projection[5] *= scale;
    return camera;
}

/* Draws directly into the texture's memory, whose rows may be longer than the picture's. */
static void draw_image(App* app, const hrbfnpr_drawing* drawing) {
    Drawing* const d = &app->drawing;
    hrbfnpr_image image;
    int pitch;
    hrbfnpr_image_init(&image, sizeof image);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = app->width;
    image.height = app->height;
    check_sdl(SDL_LockTexture(app->texture, NULL, &image.pixels, &pitch) == 0);
    image.row_stride = pitch;
    check(hrbfnpr_drawing_rasterize(drawing, &image, NULL, &d->error), &d->error);
    SDL_UnlockTexture(app->texture);
    SDL_RenderCopy(app->screen, app->texture, NULL, NULL);
}

/* The brush is white, with its ink as alpha: soft edges, and some dry hairs that leave gaps along the stroke. */
static SDL_Texture* new_brush(SDL_Renderer* screen) {
    static Uint8 pixels[BRUSH_WIDTH][BRUSH_LENGTH][4];
    for (int y = 0; y < BRUSH_WIDTH; ++y) {
        const double across = (y + 0.5) / BRUSH_WIDTH, edge = fmin(1, 4 * fmin(across, 1 - across));
        for (int x = 0; x < BRUSH_LENGTH; ++x) {
            const double dry = 0.5 + 0.5 * sin(0.031 * x + 5 * across) * sin(0.017 * x + 1.7 * y);
            memset(pixels[y][x], 255, 3);
            pixels[y][x][3] = (Uint8)(255 * edge * (1 - 0.35 * dry));
        }
    }
    SDL_Texture* const brush =
        SDL_CreateTexture(screen, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC, BRUSH_LENGTH, BRUSH_WIDTH);
    check_sdl(brush != NULL);
    check_sdl(SDL_UpdateTexture(brush, NULL, pixels, (int)sizeof pixels[0]) == 0);
    check_sdl(SDL_SetTextureBlendMode(brush, SDL_BLENDMODE_BLEND) == 0);
    check_sdl(SDL_SetTextureScaleMode(brush, SDL_ScaleModeLinear) == 0);
    return brush;
}

/* The vertex format that the library writes. */
typedef struct StrokeVertex {
    float x, y, depth, length;
    SDL_Color color;
} StrokeVertex;

static hrbfnpr_vertex_attribute attribute_of(uint32_t attribute, uint32_t scalar, size_t offset) {
    hrbfnpr_vertex_attribute result;
    hrbfnpr_vertex_attribute_init(&result, sizeof result);
    result.attribute = attribute;
    result.scalar = scalar;
    result.offset = (uint32_t)offset;
    return result;
}

static void write_strips(App* app, const hrbfnpr_drawing* drawing, StrokeVertex* vertices, int64_t vertex_count,
                         uint32_t* indices, int64_t index_count) {
    const hrbfnpr_vertex_attribute attributes[3] = {
        attribute_of(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0),
        attribute_of(HRBFNPR_VERTEX_ATTRIBUTE_LENGTH, HRBFNPR_SCALAR_FLOAT32, offsetof(StrokeVertex, length)),
        attribute_of(HRBFNPR_VERTEX_ATTRIBUTE_COLOR, HRBFNPR_SCALAR_UINT8, offsetof(StrokeVertex, color))};
    hrbfnpr_error* const error = &app->drawing.error;
    hrbfnpr_vertex_layout layout;
    hrbfnpr_vertex_layout_init(&layout, sizeof layout);
    layout.primitive = HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS;
    layout.attributes = attributes;
    layout.attribute_count = 3;
    layout.stride = sizeof(StrokeVertex);
    check(hrbfnpr_drawing_write_vertices(drawing, &layout, vertices, vertex_count, NULL, indices, index_count, NULL,
                                         error),
          error);
}

/* Moves the left and the right vertex of a stroke's point apart, to make up for the brush's soft edges. SDL fills
 * pixels whose centres are in a triangle, so thin lines would be broken. They are two pixels wide, but paler. */
static void widen(SDL_Vertex* left, SDL_Vertex* right) {
    const float x = 0.5f * (right->position.x - left->position.x), y = 0.5f * (right->position.y - left->position.y);
    const float half = hypotf(x, y), wanted = half / SOLID;
    const float more = half > 0 ? fmaxf(wanted, 1) / half - 1 : 0; /* half is 0 at the tip of a pointed end */
    left->position.x -= more * x;
    left->position.y -= more * y;
    right->position.x += more * x;
    right->position.y += more * y;
    left->color.a = right->color.a = (Uint8)((float)left->color.a * fminf(wanted, 1));
}

/* SDL's textures do not repeat, so the brush is longer than most strokes. */
static SDL_Vertex vertex_of(const StrokeVertex* v, float side) {
    return (SDL_Vertex){{v->x, v->y}, v->color, {fminf(v->length / BRUSH_LENGTH, 1), side}};
}

/* Left and right vertices alternate along a strip. SDL draws only lists of triangles, so each index after the first two
 * of a strip makes one triangle. */
static void paint_strips(App* app, const StrokeVertex* from, SDL_Vertex* vertices, int64_t vertex_count,
                         const uint32_t* strips, int* triangles, int64_t index_count) {
    int count = 0;
    int64_t begin = 0;
    for (int64_t i = 0; i < index_count; ++i) {
        if (strips[i] == (uint32_t)HRBFNPR_INDEX_RESTART) {
            begin = i + 1;
            continue;
        }
        const int is_right = (int)((i - begin) % 2);
        vertices[strips[i]] = vertex_of(from + strips[i], (float)is_right);
        if (is_right) widen(vertices + strips[i - 1], vertices + strips[i]);
        for (int64_t k = i - 2; i >= begin + 2 && k <= i; ++k) triangles[count++] = (int)strips[k];
    }
    if (count == 0) return;
    check_sdl(SDL_RenderGeometry(app->screen, app->brush, vertices, (int)vertex_count, triangles, count) == 0);
}

static Uint8 byte_of(float channel) { return (Uint8)(255 * channel + 0.5f); }

static void draw_strokes(App* app, const hrbfnpr_drawing* drawing) {
    hrbfnpr_error* const error = &app->drawing.error;
    const hrbfnpr_style* style;
    int64_t vertex_count, index_count;
    check(hrbfnpr_picture_get_style(app->drawing.picture, &style, error), error);
    check(hrbfnpr_drawing_vertex_bound(drawing, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS, &vertex_count, &index_count, error),
          error);
    StrokeVertex* const strokes = malloc((size_t)(vertex_count + 1) * sizeof *strokes);
    SDL_Vertex* const vertices = malloc((size_t)(vertex_count + 1) * sizeof *vertices);
    uint32_t* const strips = malloc((size_t)(index_count + 1) * sizeof *strips);
    int* const triangles = malloc(3 * (size_t)(index_count + 1) * sizeof *triangles);
    if (strokes == NULL || vertices == NULL || strips == NULL || triangles == NULL)
        fail("strokes", "there is not enough memory");
    write_strips(app, drawing, strokes, vertex_count, strips, index_count);
    SDL_SetRenderDrawColor(app->screen, byte_of(style->paper[0]), byte_of(style->paper[1]), byte_of(style->paper[2]),
                           255);
    SDL_RenderClear(app->screen);
    paint_strips(app, strokes, vertices, vertex_count, strips, triangles, index_count);
    free(triangles);
    free(strips);
    free(vertices);
    free(strokes);
}

static void draw(App* app) {
    Drawing* const d = &app->drawing;
    const hrbfnpr_camera camera = camera_of(app);
    hrbfnpr_drawing* drawing;
    check(hrbfnpr_picture_draw(d->picture, &camera, NULL, &drawing, &d->error), &d->error);
    if (app->shows_strokes)
        draw_strokes(app, drawing);
    else
        draw_image(app, drawing);
    hrbfnpr_drawing_release(drawing);
}

static void save_screen(App* app, const char* path) {
    const size_t length = strlen(path);
    SDL_Surface* const surface = SDL_CreateRGBSurfaceWithFormat(0, app->width, app->height, 32, SDL_PIXELFORMAT_RGBA32);
    check_sdl(surface != NULL);
    check_sdl(SDL_RenderReadPixels(app->screen, NULL, surface->format->format, surface->pixels, surface->pitch) == 0);
    if (length > 4 && strcmp(path + length - 4, ".bmp") == 0) {
        check_sdl(SDL_SaveBMP(surface, path) == 0);
    } else { /* rows of 32-bit pixels have no padding */
        const size_t rows = (size_t)app->height;
        FILE* const file = fopen(path, "wb");
        if (file == NULL || fwrite(surface->pixels, (size_t)surface->pitch, rows, file) != rows || fclose(file) != 0)
            fail(path, "cannot be written");
    }
    SDL_FreeSurface(surface);
}

static void run(App* app, const char* screenshot) {
    SDL_Event event;
    while (!app->quits) {
        const SDL_bool moves = app->worker != NULL || app->view.turntable;
        if (SDL_WaitEventTimeout(&event, moves ? 15 : 1000)) {
            do handle(app, &event);
            while (SDL_PollEvent(&event));
        }
        if (app->worker != NULL && SDL_AtomicGet(&app->drawing.is_done)) end_work(app);
        if (!moves && !app->is_stale) continue;
        if (app->view.turntable) app->view.turn += 0.01;
        fit_texture(app);
        if (app->worker == NULL && (app->width != app->drawing.width || app->height != app->drawing.height))
            start_work(app); /* another size needs other marks */
        if (app->worker != NULL)
            show_progress(app);
        else
            draw(app);
        app->is_stale = SDL_FALSE;
        if (screenshot != NULL && app->worker == NULL) {
            save_screen(app, screenshot);
            app->quits = SDL_TRUE;
        }
        SDL_RenderPresent(app->screen);
    }
    if (app->worker != NULL) {
        hrbfnpr_operation_cancel(app->drawing.operation);
        end_work(app);
    }
}

static void set_up(App* app) {
    Drawing* const d = &app->drawing;
    d->preset = app->shows_strokes ? HRBFNPR_PRESET_CROSS_HATCH : HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    app->view.height = app->view.zoom = 1;
    hrbfnpr_error_init(&d->error, sizeof d->error);
    check(hrbfnpr_context_create(NULL, &d->context, &d->error), &d->error);
    check(hrbfnpr_operation_create(d->context, &d->operation, &d->error), &d->error);

    check_sdl(SDL_Init(SDL_INIT_VIDEO) == 0);
    app->window =
        SDL_CreateWindow("hrbfnpr", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 640, 480, SDL_WINDOW_RESIZABLE);
    check_sdl(app->window != NULL);
    app->screen = SDL_CreateRenderer(app->window, -1, 0);
    check_sdl(app->screen != NULL);
    app->brush = new_brush(app->screen);
}

static void tear_down(App* app) {
    Drawing* const d = &app->drawing;
    SDL_DestroyTexture(app->brush);
    SDL_DestroyTexture(app->texture);
    SDL_DestroyRenderer(app->screen);
    SDL_DestroyWindow(app->window);
    SDL_Quit();
    hrbfnpr_picture_release(d->picture);
    hrbfnpr_operation_release(d->operation);
    hrbfnpr_context_release(d->context);
    free(d->samples);
}

int main(int argc, char** argv) {
    static App app;
    const char* screenshot = NULL;
    const char* samples = TORUS;
    for (int i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--screenshot") == 0 && i + 1 < argc)
            screenshot = argv[++i];
        else if (strcmp(argv[i], "--strokes") == 0)
            app.shows_strokes = SDL_TRUE;
        else if (argv[i][0] != '-')
            samples = argv[i];
        else
            fail("usage", "sdl2 [--strokes] [--screenshot FILE] [SAMPLES.xyzn]");
    }
    read_samples(samples, &app.drawing);
    set_up(&app);
    start_work(&app);
    run(&app, screenshot);
    tear_down(&app);
    return 0;
}
