/* SPDX-License-Identifier: MIT */
/* A C program that loads the library at run time, again and again: load LIBRARY HOW, where HOW is
 *   idle     50 times, without a call
 *   work     50 times, with a fit and a drawing each time, all released
 *   openmp   the same by OpenMP's threads
 *   keep     once, and ends with everything alive and the library closed */
#include <dirent.h>
#include <dlfcn.h>
#include <hrbfnpr.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ROUNDS = 50, WARM = 5, COUNT = 48, SIZE = 64 };

static double points[COUNT][3];
static unsigned char pixels[SIZE][SIZE][4];

static void fail(const char* what) {
    fprintf(stderr, "load: %s\n", what);
    exit(1);
}

static void check(int32_t status) {
    if (status != HRBFNPR_STATUS_OK) fail("a call failed");
}

/* Sets the local variable `name` to the function of that name. */
#define FIND(name)                                                                                                     \
    __typeof__(hrbfnpr_##name)* name;                                                                                  \
    find(library, "hrbfnpr_" #name, &name, sizeof name)

static void find(void* library, const char* name, void* function, size_t size) {
    void* const address = dlsym(library, name);
    if (address == NULL) fail(name);
    memcpy(function, &address, size);
}

/* Points on the unit sphere, which are their own normals. */
static void sample_sphere(void) {
    for (int i = 0; i < COUNT; ++i) {
        const double z = (2 * i + 1.0) / COUNT - 1, r = sqrt(1 - z * z), a = 2.4 * i;
        points[i][0] = r * cos(a);
        points[i][1] = r * sin(a);
        points[i][2] = z;
    }
}

static void work(void* library, uint32_t backend, int keep) {
    FIND(context_desc_init);
    FIND(context_create);
    FIND(context_release);
    FIND(fit_desc_init);
    FIND(model_fit);
    FIND(model_release);
    FIND(generate_desc_init);
    FIND(point_set_generate);
    FIND(point_set_release);
    FIND(camera_init);
    FIND(camera_fit_bounds);
    FIND(item_init);
    FIND(image_init);
    FIND(renderer_create);
    FIND(renderer_draw);
    FIND(drawing_rasterize);
    FIND(drawing_release);
    FIND(renderer_release);
    const double low[3] = {-1, -1, -1}, high[3] = {1, 1, 1}, direction[3] = {0, 1, -1}, up[3] = {0, 0, 1};
    hrbfnpr_context_desc desc;
    hrbfnpr_context* context;
    hrbfnpr_model* model;
    hrbfnpr_point_set* marks;
    hrbfnpr_renderer* renderer;
    hrbfnpr_drawing* drawing;
    hrbfnpr_fit_desc fit;
    hrbfnpr_generate_desc generate;
    hrbfnpr_camera camera;
    hrbfnpr_item item;
    hrbfnpr_image image;
    check(context_desc_init(&desc, sizeof desc));
    desc.thread_count = 3;
    desc.thread_backend = backend;
    check(context_create(&desc, &context, NULL));
    check(fit_desc_init(&fit, sizeof fit));
    fit.points = fit.normals = (hrbfnpr_array){points, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(model_fit(context, &fit, NULL, &model, NULL));
    check(generate_desc_init(&generate, sizeof generate));
    generate.shared_budget = 500;
    check(point_set_generate(context, model, &generate, NULL, &marks, NULL));
    check(camera_init(&camera, sizeof camera));
    check(camera_fit_bounds(&camera, low, high, direction, up, 0.5, SIZE, SIZE, 0.02, NULL));
    check(item_init(&item, sizeof item));
    item.point_set = marks;
    check(renderer_create(context, &renderer, NULL));
    check(renderer_draw(renderer, &item, 1, 0, &camera, &drawing, NULL));
    check(image_init(&image, sizeof image));
    image.width = image.height = SIZE;
    image.pixels = pixels;
    check(drawing_rasterize(drawing, &image, NULL, NULL));
    if (keep) return;
    drawing_release(drawing);
    renderer_release(renderer);
    point_set_release(marks);
    model_release(model);
    context_release(context);
}

/* Entries of a folder of /proc/self: threads, or open files. */
static int count_entries(const char* folder) {
    int count = 0;
    DIR* const entries = opendir(folder);
    if (entries == NULL) fail(folder);
    while (readdir(entries) != NULL) ++count;
    closedir(entries);
    return count;
}

/* The threads of this process.  One that was joined may be listed a moment longer: what lasts is counted. */
static int count_threads(void) {
    int least = count_entries("/proc/self/task");
    for (int look = 0; look < 40; ++look) {
        usleep(5000);
        const int count = count_entries("/proc/self/task");
        if (count < least) least = count;
    }
    return least;
}

/* Whether a file is mapped into this process. */
static int is_mapped(const char* path) {
    char line[4096];
    int found = 0;
    FILE* const file = fopen("/proc/self/maps", "r");
    if (file == NULL) fail("/proc/self/maps");
    while (fgets(line, sizeof line, file) != NULL) found |= strstr(line, path) != NULL;
    fclose(file);
    return found;
}

static long resident_kilobytes(void) {
    long all, resident;
    FILE* const file = fopen("/proc/self/statm", "r");
    if (file == NULL || fscanf(file, "%ld %ld", &all, &resident) != 2) fail("/proc/self/statm");
    fclose(file);
    return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

int main(int argc, char** argv) {
    const int works = argc == 3 && strcmp(argv[2], "idle") != 0;
    const int keep = argc == 3 && strcmp(argv[2], "keep") == 0;
    const int openmp = argc == 3 && strcmp(argv[2], "openmp") == 0;
    const uint32_t backend = openmp ? HRBFNPR_THREAD_BACKEND_OPENMP : HRBFNPR_THREAD_BACKEND_AUTO;
    char path[4096];
    int threads = 0, files = 0;
    long memory = 0;
    if (argc != 3 || realpath(argv[1], path) == NULL) return 2;
    sample_sphere();
    for (int round = 0; round < (keep ? 1 : ROUNDS); ++round) {
        /* As plug-in hosts do, and as those that keep their own C++ runtime apart. */
        void* const library = dlopen(argv[1], RTLD_LOCAL | (round % 2 == 0 ? RTLD_NOW : RTLD_LAZY | RTLD_DEEPBIND));
        if (library == NULL) fail(dlerror());
        if (works) work(library, backend, keep);
        if (dlclose(library) != 0) fail(dlerror());
        if (is_mapped(path) != keep) fail(keep ? "it is gone, and its threads are not" : "it is still there");
        if (round == WARM) {
            threads = count_threads();
            files = count_entries("/proc/self/fd");
            memory = resident_kilobytes();
        }
    }
    if (keep) return 0;
    memory = resident_kilobytes() - memory;
    printf("%d rounds: %ld KiB more than after %d\n", ROUNDS, memory, WARM);
    if (count_threads() != threads) fail("threads are left over");
    if (count_entries("/proc/self/fd") != files) fail("files are left open");
    if (memory > 4096) fail("memory grows");
    return 0;
}
