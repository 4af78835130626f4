// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>
        /// Fits a surface to a mesh, with as many samples as the tolerance takes.  A fit that ends short of the
        /// tolerance is no error: see <see cref="MeshFitInfo.Reached"/>.
        /// </summary>
        /// <param name="mesh">The mesh.</param>
        /// <param name="info">Receives the result of the fit.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="fit">Kernel, solver, regularization and trim.  Its Tolerance and MaximumCentres are not used.
        /// null = all defaults.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range.</exception>
        /// <exception cref="SingularSystemException">The linear system has no numerically unique solution.</exception>
        /// <exception cref="NotConvergedException">The iterative solver did not reach its tolerance; the message gives
        /// the residual.</exception>
        public static Model FitMesh(
            TriangleMesh mesh, out MeshFitInfo info, MeshFitOptions options = null, FitOptions fit = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            if (mesh == null)
            {
                throw new ArgumentNullException(nameof(mesh));
            }
            hrbfnpr_mesh_fit_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_mesh_fit_desc_init(&desc, (uint)sizeof(hrbfnpr_mesh_fit_desc)));
            (options ?? new MeshFitOptions()).Write(ref desc);
            hrbfnpr_fit_desc how;
            Errors.Check(NativeMethods.hrbfnpr_fit_desc_init(&how, (uint)sizeof(hrbfnpr_fit_desc)));
            (fit ?? new FitOptions()).Write(ref how);
            MeshFitInfo reached;
            Errors.Check(NativeMethods.hrbfnpr_mesh_fit_info_init(&reached, (uint)sizeof(MeshFitInfo)));
            using (var call = new LongCall(mesh.Handle, progress, cancellationToken))
            {
                hrbfnpr_error error = Errors.New();
                var made = new ModelHandle();
                int status = NativeMethods.hrbfnpr_model_fit_mesh(
                    mesh.Handle, &desc, &how, &reached, call.Operation, out IntPtr created, &error);
                made.Take(created, mesh.Handle.Anchor);
                info = reached;
                return Finish(made, null, call, status, &error);
            }
        }

        /// <summary>Measures how near the surface and a mesh are to each other, both ways.</summary>
        /// <param name="mesh">The mesh, in the same coordinates.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range.</exception>
        public MeshComparison Compare(
            TriangleMesh mesh, CompareOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            if (mesh == null)
            {
                throw new ArgumentNullException(nameof(mesh));
            }
            hrbfnpr_compare_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_compare_desc_init(&desc, (uint)sizeof(hrbfnpr_compare_desc)));
            (options ?? new CompareOptions()).Write(ref desc);
            MeshComparison result;
            Errors.Check(NativeMethods.hrbfnpr_comparison_init(&result, (uint)sizeof(MeshComparison)));
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_model_compare_mesh(
                    handle, mesh.Handle, &desc, &result, call.Operation, &error);
                call.Check(status, &error, function);
            }
            return result;
        }
    }
}
