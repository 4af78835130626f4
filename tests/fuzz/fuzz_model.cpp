#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<std::uint8_t> file = fuzz::signed_file(data, size);
    hrbfnpr_context* context = fuzz::context();
    hrbfnpr_model* model = nullptr;
    const auto length = static_cast<std::int64_t>(file.size());
    fuzz::expect_clean(hrbfnpr_model_load_memory(context, file.data(), length, &model, nullptr));
    if (model != nullptr) { // whatever loads can be used
        const double point[3] = {0.1, 0.2, 0.3};
        double value[10];
        const hrbfnpr_array points{point, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out values{value, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out gradients{value + 1, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out hessians{value + 4, 1, 0, HRBFNPR_SCALAR_FLOAT64, 6};
        hrbfnpr_model_evaluate(model, &points, &values, &gradients, &hessians, nullptr, nullptr);
        hrbfnpr_model_info info;
        hrbfnpr_model_info_init(&info, sizeof info);
        hrbfnpr_model_get_info(model, &info, nullptr);
    }
    hrbfnpr_model_release(model);
    hrbfnpr_context_release(context);
    return 0;
}
