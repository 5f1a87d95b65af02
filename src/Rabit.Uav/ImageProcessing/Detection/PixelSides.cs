using System;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How large the pixels of a picture are on the ground: sides of squares of their area, metres.</summary>
internal readonly struct PixelSides
{
    // Across, and down; more where a part of the picture is not searched: its border is where pixels are largest.
    private const int Places = 3;
    private const int PlacesOfPart = 17;

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
        if (!IsGroundAt(input, Places, out PixelSides sides))
            IsGroundAt(input, PlacesOfPart, out sides);
        return sides;
    }

    private static bool IsGroundAt(in DetectorInput input, int places, out PixelSides sides)
    {
        bool isAll = true;
        (double finest, double coarsest) = (double.MaxValue, 0);
        for (int i = 0; i < places * places; i++)
        {
            double column = i % places * (input.Width - 1.0) / (places - 1);
            double row = i / places * (input.Height - 1.0) / (places - 1);
            if (!input.GroundScale.TryAt(column, row, out GroundScale scale))
            {
                isAll = false;
                continue;
            }

            double side = Math.Sqrt(scale.PixelArea);
            (finest, coarsest) = (Math.Min(finest, side), Math.Max(coarsest, side));
        }

        sides = new PixelSides(finest, coarsest);
        return isAll;
    }
}
