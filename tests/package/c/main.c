/* SPDX-License-Identifier: MIT */
/* One sample is a plane: z at (0, 0, 2) must be 2.  Prints "2" and the version. */
#include <hrbfnpr.h>
#include <stdio.h>

static int fail(const hrbfnpr_error* error) {
    fprintf(stderr, "%s: %s\n", hrbfnpr_status_name(error->status), error->message);
    return 1;
}

int main(void) {
    const double point[3] = {0, 0, 0}, normal[3] = {0, 0, 1}, query[3] = {0, 0, 2};
    double value = 0;
    hrbfnpr_array points = {point, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3}, normals = points, queries = points;
    hrbfnpr_array_out values = {&value, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    hrbfnpr_context* context = NULL;
    hrbfnpr_model* model = NULL;
    hrbfnpr_fit_desc desc;
    hrbfnpr_error error;

    normals.data = normal;
    queries.data = query;
    hrbfnpr_error_init(&error, sizeof error);
    hrbfnpr_fit_desc_init(&desc, sizeof desc);
    desc.points = points;
    desc.normals = normals;
    if (hrbfnpr_context_create(NULL, &context, &error) != HRBFNPR_STATUS_OK) return fail(&error);
    if (hrbfnpr_model_fit(context, &desc, NULL, &model, &error) != HRBFNPR_STATUS_OK) return fail(&error);
    if (hrbfnpr_model_evaluate(model, &queries, &values, NULL, NULL, NULL, &error) != HRBFNPR_STATUS_OK)
        return fail(&error);
    hrbfnpr_model_release(model);
    hrbfnpr_context_release(context);
    printf("%.6g %s\n", value, hrbfnpr_version_string());
    return value > 1.999999 && value < 2.000001 ? 0 : 1;
}
