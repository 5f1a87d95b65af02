using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The outline of a thing on the ground, whatever the camera looks at it from. Memory of the largest one; for one
/// thread.
/// </summary>
internal sealed class OutlineOnGround
{
    private PicturePoint[] _points = [];

    /// <summary>North and east of the centre, metres.</summary>
    /// <param name="outline">Columns and rows of the picture.</param>
    /// <param name="centreX">The column of the centre.</param>
    /// <param name="centreY">The row of the centre.</param>
    /// <param name="scale">Where it lies.</param>
    /// <returns>As many points, until the next call.</returns>
    public ReadOnlySpan<PicturePoint> Project(
        ReadOnlySpan<PicturePoint> outline, double centreX, double centreY, in GroundScale scale)
    {
        if (_points.Length < outline.Length)
            _points = new PicturePoint[2 * outline.Length];
        for (int i = 0; i < outline.Length; i++)
        {
            (double column, double row) = (outline[i].X - centreX, outline[i].Y - centreY);
            _points[i] = new PicturePoint(
                (scale.NorthByColumn * column) + (scale.NorthByRow * row),
                (scale.EastByColumn * column) + (scale.EastByRow * row));
        }

        return _points.AsSpan(0, outline.Length);
    }
}
