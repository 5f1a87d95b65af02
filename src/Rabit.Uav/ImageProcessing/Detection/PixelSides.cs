using System;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How large the pixels of a picture are on the ground: sides of squares of their area, metres.</summary>
internal readonly struct PixelSides
{
    private const int Places = 3;   // across, and down

    private PixelSides(double finest, double coarsest) => (Finest, Coarsest) = (finest, coarsest);

    /// <summary>Of the smallest.</summary>
    public double Finest { get; }

    /// <summary>Of the largest.</summary>
    public double Coarsest { get; }

    /// <summary>Whether any ground is seen.</summary>
    public bool IsGround => Coarsest > 0;

    /// <summary>Of a picture, at its corners, in the middle of its borders, and in its own.</summary>
    public static PixelSides Of(in DetectorInput input)
    {
        (double finest, double coarsest) = (double.MaxValue, 0);
        for (int i = 0; i < Places * Places; i++)
        {
            double column = i % Places * (input.Width - 1.0) / (Places - 1);
            double row = i / Places * (input.Height - 1.0) / (Places - 1);
            if (!input.GroundScale.TryAt(column, row, out GroundScale scale))
                continue;
            double side = Math.Sqrt(scale.PixelArea);
            (finest, coarsest) = (Math.Min(finest, side), Math.Max(coarsest, side));
        }

        return new PixelSides(finest, coarsest);
    }
}
