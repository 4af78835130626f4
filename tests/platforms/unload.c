/* SPDX-License-Identifier: MIT */
/* A Windows program that loads the library at run time, uses threads, and unloads it: unload LIBRARY.
 * The library then must stay in memory, because a context with threads was left alive. */
#include <hrbfnpr.h>

#include <stdio.h>
#include <string.h>
#include <windows.h>

enum { COUNT = 512 };

static double points[COUNT][3], normals[COUNT][3];

static void* find(HMODULE library, const char* name) {
    void* function = NULL;
    const FARPROC found = GetProcAddress(library, name);
    memcpy(&function, &found, sizeof function);
    return function;
}

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const HMODULE library = LoadLibraryA(argv[1]);
    if (library == NULL) return 3;
    __typeof__(hrbfnpr_context_desc_init)* const desc_init = find(library, "hrbfnpr_context_desc_init");
    __typeof__(hrbfnpr_context_create)* const create = find(library, "hrbfnpr_context_create");
    __typeof__(hrbfnpr_fit_desc_init)* const fit_init = find(library, "hrbfnpr_fit_desc_init");
    __typeof__(hrbfnpr_model_fit)* const model_fit = find(library, "hrbfnpr_model_fit");
    hrbfnpr_context_desc desc;
    hrbfnpr_fit_desc fit;
    hrbfnpr_context* context = NULL;
    hrbfnpr_model* model = NULL;
    hrbfnpr_error error = {.struct_size = sizeof error};
    for (int i = 0; i < COUNT; ++i) {
        const double t = 2.0 * i / COUNT - 1;
        points[i][0] = t, points[i][1] = 0.25 * (i % 32) / 32, points[i][2] = t * t;
        normals[i][0] = -2 * t, normals[i][2] = 1;
    }
    if (desc_init(&desc, sizeof desc) != 0) return 4;
    desc.thread_count = 4;
    if (create(&desc, &context, &error) != 0 || fit_init(&fit, sizeof fit) != 0) return 5;
    fit.points = (hrbfnpr_array){points, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    fit.normals = (hrbfnpr_array){normals, COUNT, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    if (model_fit(context, &fit, NULL, &model, &error) != 0) {
        printf("%s\n", error.message);
        return 6;
    }
    if (!FreeLibrary(library)) return 7;
    Sleep(200); /* the library's threads go to sleep, or would crash here */
    puts(GetModuleHandleA("libhrbfnpr.dll") != NULL ? "still loaded" : "unloaded");
    return 0;
}
