namespace Rabit.Uav.Simulation;

/// <summary>
/// The rays within one pixel, from those of its neighbours: the lens bends so little within a pixel that a straight
/// line is good to a thousandth of it. A plain value.
/// </summary>
internal readonly struct PixelCone
{
    private readonly double _x;
    private readonly double _y;
    private readonly double _xByU;
    private readonly double _yByU;
    private readonly double _xByV;
    private readonly double _yByV;

    public PixelCone(LensRays lens, int u, int v)
    {
        double[] rays = lens.Rays;
        int stride = 2 * lens.Width;
        int at = (v * stride) + (2 * u);
        (_x, _y) = (rays[at], rays[at + 1]);

        int left = u > 0 ? at - 2 : at;
        int right = u < lens.Width - 1 ? at + 2 : at;
        double across = 2.0 / (right - left);
        (_xByU, _yByU) = ((rays[right] - rays[left]) * across, (rays[right + 1] - rays[left + 1]) * across);

        int above = v > 0 ? at - stride : at;
        int below = v < lens.Height - 1 ? at + stride : at;
        double along = (double)stride / (below - above);
        (_xByV, _yByV) = ((rays[below] - rays[above]) * along, (rays[below + 1] - rays[above + 1]) * along);
    }

    /// <summary>x of a ray, pixels to the right of and below the middle of the pixel.</summary>
    public double X(double du, double dv) => _x + (du * _xByU) + (dv * _xByV);

    /// <summary>y of a ray, pixels to the right of and below the middle of the pixel.</summary>
    public double Y(double du, double dv) => _y + (du * _yByU) + (dv * _yByV);
}
