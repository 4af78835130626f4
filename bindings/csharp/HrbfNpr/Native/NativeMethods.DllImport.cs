// SPDX-License-Identifier: MIT
// Made by make_native.py from include/hrbfnpr.h; do not edit.
#if !NET7_0_OR_GREATER
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    internal static unsafe partial class NativeMethods
    {
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint hrbfnpr_version();
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint hrbfnpr_abi_version();
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern byte* hrbfnpr_version_string();
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern byte* hrbfnpr_status_name(int status);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_error_init(hrbfnpr_error* error, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_build_info(byte* destination, long capacity, long* needed);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern byte* hrbfnpr_layout(byte* name);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_image_init(hrbfnpr_image* image, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_context_desc_init(hrbfnpr_context_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_context_create(hrbfnpr_context_desc* desc, out IntPtr out_context,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_context_retain(IntPtr context);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_context_release(IntPtr context);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_context_info_init(ContextInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_context_get_info(ContextHandle context, ContextInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_operation_create(IntPtr context, out IntPtr out_operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_operation_retain(IntPtr operation);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_operation_release(IntPtr operation);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_operation_cancel(OperationHandle operation);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_operation_is_cancelled(OperationHandle operation);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern double hrbfnpr_operation_progress(OperationHandle operation);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_operation_set_callback(OperationHandle operation, IntPtr callback,
            IntPtr user, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_fit_desc_init(hrbfnpr_fit_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_fit(ContextHandle context, hrbfnpr_fit_desc* desc,
            OperationHandle operation, out IntPtr out_model, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_orient_desc_init(hrbfnpr_orient_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_orient_info_init(OrientationInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_orient(ContextHandle context, hrbfnpr_orient_desc* desc,
            OperationHandle operation, hrbfnpr_array* out_normals, OrientationInfo* info, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_depth_image_desc_init(hrbfnpr_depth_image_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_depth_image_info_init(DepthImageInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_smooth_depth_image(ContextHandle context, hrbfnpr_depth_image_desc* desc,
            OperationHandle operation, hrbfnpr_array* out_points, hrbfnpr_array* out_normals, DepthImageInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_custom_desc_init(hrbfnpr_custom_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_create_custom(ContextHandle context, hrbfnpr_custom_desc* desc,
            out IntPtr out_model, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_model_retain(IntPtr model);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_model_release(IntPtr model);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_info_init(ModelInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_get_info(ModelHandle model, ModelInfo* info, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_view(ModelHandle model, uint attribute, hrbfnpr_array* out_view,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_evaluate(ModelHandle model, hrbfnpr_array* points,
            hrbfnpr_array* value, hrbfnpr_array* gradient, hrbfnpr_array* hessian, OperationHandle operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_project_desc_init(hrbfnpr_project_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_projection_init(hrbfnpr_projection* projection, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_project(ModelHandle model, hrbfnpr_array* points,
            hrbfnpr_project_desc* desc, hrbfnpr_projection* projection, OperationHandle operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_curvature_init(hrbfnpr_curvature* curvature, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_curvature(ModelHandle model, hrbfnpr_array* points,
            hrbfnpr_curvature* curvature, OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_cast_desc_init(hrbfnpr_cast_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_ray_hits_init(hrbfnpr_ray_hits* hits, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_cast_rays(ModelHandle model, hrbfnpr_array* origins,
            hrbfnpr_array* directions, hrbfnpr_cast_desc* desc, hrbfnpr_ray_hits* hits, OperationHandle operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_lipschitz(ModelHandle model, double* lipschitz,
            OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_contains(ModelHandle model, hrbfnpr_array* points,
            hrbfnpr_array* inside, long* inside_count, OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_trim_desc_init(hrbfnpr_trim_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_trim(ModelHandle model, hrbfnpr_trim_desc* desc,
            OperationHandle operation, out IntPtr out_model, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_trim_info_init(TrimInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_get_trim_info(ModelHandle model, TrimInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_csg_node_init(hrbfnpr_csg_node* node, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_csg_desc_init(hrbfnpr_csg_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_create_csg(IntPtr context, hrbfnpr_csg_desc* desc,
            out IntPtr out_model, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_csg_info_init(CsgInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_get_csg_info(ModelHandle model, CsgInfo* info, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_save(ModelHandle model, IntPtr write, IntPtr user,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_save_memory(ModelHandle model, void* destination, long capacity,
            long* size, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_load(ContextHandle context, IntPtr read, IntPtr user,
            out IntPtr out_model, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_load_memory(ContextHandle context, void* data, long size,
            out IntPtr out_model, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_layer_desc_init(hrbfnpr_layer_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_generate_desc_init(hrbfnpr_generate_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_generate(ContextHandle context, ModelHandle model,
            hrbfnpr_generate_desc* desc, OperationHandle operation, out IntPtr out_point_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_layer_arrays_init(hrbfnpr_layer_arrays* arrays, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_create(ContextHandle context, hrbfnpr_point_set_desc* desc,
            out IntPtr out_point_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_point_set_retain(IntPtr set);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_point_set_release(IntPtr set);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_info_init(PointSetInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_get_info(PointSetHandle set, PointSetInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_layer_info_init(LayerInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_get_layer_info(PointSetHandle set, long layer, LayerInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_placement_info_init(PlacementInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_get_seed_placement(PointSetHandle set, PlacementInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_get_placement(PointSetHandle set, long layer, int level,
            PlacementInfo* info, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_view(PointSetHandle set, long layer, uint attribute,
            hrbfnpr_array* out_view, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mark_field_init(hrbfnpr_mark_field* field, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_with_fields(ContextHandle context, PointSetHandle set,
            hrbfnpr_mark_field* fields, long field_count, long field_stride, OperationHandle operation,
            out IntPtr out_point_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_get_field(PointSetHandle set, long number, byte** name,
            uint* kind, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_view_field(PointSetHandle set, long layer, byte* name,
            hrbfnpr_array* values, hrbfnpr_array* weights, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_step_patches(ContextHandle context, ModelHandle model,
            hrbfnpr_generate_desc* desc, hrbfnpr_array* corners, double* step, OperationHandle operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_save(PointSetHandle set, IntPtr write, IntPtr user,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_save_memory(PointSetHandle set, void* destination, long capacity,
            long* size, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_load(ContextHandle context, IntPtr read, IntPtr user,
            out IntPtr out_point_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_load_memory(ContextHandle context, void* data, long size,
            out IntPtr out_point_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_line_desc_init(hrbfnpr_line_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_line_set_create(ContextHandle context, ModelHandle model,
            hrbfnpr_line_set_desc* desc, OperationHandle operation, out IntPtr out_line_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_line_set_retain(IntPtr line_set);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_line_set_release(IntPtr line_set);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_line_set_info_init(LineSetInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_line_set_get_info(LineSetHandle line_set, LineSetInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_camera_init(hrbfnpr_camera* camera, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_camera_look_at(hrbfnpr_camera* camera, double* eye, double* target,
            double* up, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle,
            double width, double height, double near_plane, double far_plane, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height,
            double width, double height, double near_plane, double far_plane, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, double* bounds_min,
            double* bounds_max, double* direction, double* up, double vertical_angle, double width, double height,
            double margin, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, hrbfnpr_array* points,
            double* origin, double* direction, double* up, double vertical_angle, double width, double height,
            double margin, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_light_init(hrbfnpr_light* light, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_style_init(hrbfnpr_style* style, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_style_init_preset(hrbfnpr_style* style, uint struct_size, uint preset,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint preset, long* count);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern byte* hrbfnpr_preset_name(uint preset);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_dab_init(hrbfnpr_dab* dab, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_field_desc_init(hrbfnpr_field_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_field_create(ContextHandle context, hrbfnpr_field_desc* desc,
            OperationHandle operation, out IntPtr out_field, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_field_retain(IntPtr field);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_field_release(IntPtr field);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_field_evaluate(FieldHandle field, hrbfnpr_array* positions,
            hrbfnpr_array* normals, hrbfnpr_array* values, hrbfnpr_array* weights, OperationHandle operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_renderer_create(ContextHandle context, out IntPtr out_renderer,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_renderer_retain(IntPtr renderer);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_renderer_release(IntPtr renderer);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_item_init(hrbfnpr_item* item, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_occluders_create(ContextHandle context, hrbfnpr_item* items,
            long item_count, long item_stride, OperationHandle operation, out IntPtr out_occluders,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_occluders_retain(IntPtr occluders);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_occluders_release(IntPtr occluders);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_shading_desc_init(hrbfnpr_shading_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_shading_create(ContextHandle context, OccludersHandle occluders,
            hrbfnpr_item* item, hrbfnpr_camera* camera, hrbfnpr_shading_desc* desc, OperationHandle operation,
            out IntPtr out_shading, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_shading_view(ShadingHandle shading, long layer, long light,
            hrbfnpr_array* out_view, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_shading_retain(IntPtr shading);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_shading_release(IntPtr shading);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_renderer_draw(RendererHandle renderer, hrbfnpr_item* items,
            long item_count, long item_stride, hrbfnpr_camera* camera, out IntPtr out_drawing, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_renderer_draw_with_operation(RendererHandle renderer, hrbfnpr_item* items,
            long item_count, long item_stride, hrbfnpr_camera* camera, OperationHandle operation,
            out IntPtr out_drawing, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_point_set_generate_still(ContextHandle context, ModelHandle model,
            hrbfnpr_generate_desc* desc, hrbfnpr_item* item, hrbfnpr_camera* camera, OperationHandle operation,
            out IntPtr out_point_set, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_drawing_retain(IntPtr drawing);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_drawing_release(IntPtr drawing);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_info_init(DrawingInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_get_info(DrawingHandle drawing, DrawingInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_layer_info_init(DrawingLayerInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_get_layer_info(DrawingHandle drawing, long number,
            DrawingLayerInfo* info, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_rasterize(DrawingHandle drawing, hrbfnpr_image* image,
            hrbfnpr_raster_desc* desc, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute,
            uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_vertex_bound(DrawingHandle drawing, uint primitive, long* vertices,
            long* indices, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_write_vertices(DrawingHandle drawing,
            hrbfnpr_vertex_layout* layout, void* vertices, long vertex_capacity, long* vertex_count, uint* indices,
            long index_capacity, long* index_count, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_mark_results(DrawingHandle drawing, long item, long layer,
            hrbfnpr_mark_results* results, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_write_mark_indices(DrawingHandle drawing, long item, long layer,
            uint mark_class, uint primitive, uint* indices, long capacity, long* count, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mark_identity_init(MarkIdentity* identity, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_drawing_identify(DrawingHandle drawing, uint id, MarkIdentity* identity,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_create(ContextHandle context, hrbfnpr_mesh_desc* desc,
            OperationHandle operation, out IntPtr out_mesh, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_mesh_retain(IntPtr mesh);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_mesh_release(IntPtr mesh);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_info_init(MeshInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_get_info(MeshHandle mesh, MeshInfo* info, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_view(MeshHandle mesh, uint attribute, hrbfnpr_array* out_view,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_sample(MeshHandle mesh, hrbfnpr_sample_desc* desc,
            hrbfnpr_array* points, hrbfnpr_array* normals, OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_edges_info_init(MeshEdgesInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_edges(MeshHandle mesh, hrbfnpr_mesh_edges_desc* desc,
            hrbfnpr_array* patch, hrbfnpr_array* sharp, MeshEdgesInfo* info, OperationHandle operation,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_farthest_points(ContextHandle context, hrbfnpr_array* points,
            hrbfnpr_array* indices, hrbfnpr_array* distance, OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_comparison_init(MeshComparison* comparison, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_compare_mesh(ModelHandle model, MeshHandle mesh,
            hrbfnpr_compare_desc* desc, MeshComparison* comparison, OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_mesh_fit_info_init(MeshFitInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_model_fit_mesh(MeshHandle mesh, hrbfnpr_mesh_fit_desc* desc,
            hrbfnpr_fit_desc* fit, MeshFitInfo* info, OperationHandle operation, out IntPtr out_model,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_page_item_init(hrbfnpr_page_item* item, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_pen_init(hrbfnpr_pen* pen, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_page_info_init(PageInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_page_write(ContextHandle context, hrbfnpr_page_desc* desc, IntPtr write,
            IntPtr user, PageInfo* info, OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_source_field_init(hrbfnpr_source_field* field, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_change_init(hrbfnpr_change* change, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_note_init(hrbfnpr_note* note, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_event_init(hrbfnpr_picture_event* @event, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_source_info_init(SourceInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_source_inspect(ContextHandle context, hrbfnpr_picture_source* source,
            uint wording, IntPtr on_event, IntPtr event_user, OperationHandle operation, SourceInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_create(ContextHandle context, hrbfnpr_picture_desc* desc,
            OperationHandle operation, out IntPtr out_picture, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_restyle(PictureHandle picture, hrbfnpr_picture_desc* desc,
            OperationHandle operation, out IntPtr out_picture, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_picture_retain(IntPtr picture);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_picture_release(IntPtr picture);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_draw(PictureHandle picture, hrbfnpr_camera* camera,
            OperationHandle operation, out IntPtr out_drawing, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_info_init(PictureInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_info(PictureHandle picture, PictureInfo* info,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_part(PictureHandle picture, long number,
            hrbfnpr_picture_part* part, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_style(PictureHandle picture, hrbfnpr_style** style,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_marks(PictureHandle picture, hrbfnpr_generate_desc** desc,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_note(PictureHandle picture, long number, hrbfnpr_note* note,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_stage(PictureHandle picture, long number,
            hrbfnpr_picture_event* stage, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_get_camera(PictureHandle picture, hrbfnpr_camera* camera,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_look(PictureHandle picture, double* direction, double azimuth,
            double elevation, hrbfnpr_camera* camera, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_orbit(PictureHandle picture, double degrees,
            hrbfnpr_camera* camera, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_plate_size(PictureHandle picture, hrbfnpr_camera* camera,
            int* width, int* height, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_rasterize(PictureHandle picture, DrawingHandle drawing,
            hrbfnpr_camera* camera, hrbfnpr_image* image, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_write(PictureHandle picture, DrawingHandle drawing,
            hrbfnpr_camera* camera, hrbfnpr_picture_page_desc* desc, IntPtr write, IntPtr user, PageInfo* info,
            OperationHandle operation, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_settings_load(ContextHandle context, IntPtr read, IntPtr user,
            out IntPtr out_settings, hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_settings_retain(IntPtr settings);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void hrbfnpr_settings_release(IntPtr settings);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_write_settings(PictureHandle picture, IntPtr write, IntPtr user,
            hrbfnpr_error* error);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_views_info_init(ViewsInfo* info, uint struct_size);
        [DllImport(Name, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int hrbfnpr_picture_write_views(PictureHandle picture, hrbfnpr_views_desc* desc,
            IntPtr write, IntPtr user, ViewsInfo* info, OperationHandle operation, hrbfnpr_error* error);
    }
}
#endif
